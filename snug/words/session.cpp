#include "snug/words/catalogue.h"

// The session of the studio.

namespace snug {
namespace {

constexpr Wording kWordsOfSession[] = {
    {"session.changed", "the object changed while it was turned", "回している間に対象物が変わりました。"},
    {"session.no_foams", "there are no foams yet that could be measured", "測る緩衝材がまだありません。"},
    {"session.cloud", "gaps, undercuts and what the object lies on are not known of a point cloud",
     "点群では、すきま、陰になる所、対象物が載る面はわかりません。"},
    {"session.one_item", "this looks at one item, and {items} lie in the case",
     "これは一つのものだけを調べますが、ケースには {items} 個あります。"},
    {"session.no_object", "there is no object yet: open one first",
     "まだ対象物がありません。先に開いてください。"},
};

}  // namespace

std::span<const Wording> words_of_session() {
    return kWordsOfSession;
}

}  // namespace snug

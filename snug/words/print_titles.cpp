#include "snug/words/catalogue.h"

// Titles of what is printed.

namespace snug {
namespace {

constexpr Wording kWordsOfPrintTitles[] = {
    {"print.title", "{name}: foams", "{name}：緩衝材"},
    {"print.fit_title", "{name}: fit test", "{name}：試験片"},
    {"print.mould_title", "{name}: moulds", "{name}：型"},
};

}  // namespace

std::span<const Wording> words_of_print_titles() {
    return kWordsOfPrintTitles;
}

}  // namespace snug

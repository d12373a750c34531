#include "snug/words/catalogue.h"

// The space of blocks, and the search for a place in it.

namespace snug {
namespace {

constexpr Wording kWordsOfSpace[] = {
    {"space.too_many_blocks",
     "the object and its walls would need {blocks} blocks, more than 4096 on an axis: choose larger blocks",
     "対象物と壁には {blocks} ブロックが必要で、1 軸 4096 個を超えます。ブロックを大きくしてください。"},
    {"parting.too_high", "the parting level {level} is above the space's {blocks} blocks",
     "分割の高さ {level} が、空間の {blocks} ブロックを超えています。"},
    {"case.squeezed",
     "the case is divided into blocks of {block} mm, for which the clearance must be {least} mm or more "
     "(-0.4 of the smallest side), not {clearance}",
     "ケースは {block} mm のブロックに分かれます。すきまは {least} mm（最も短い辺の -0.4 倍）以上にしてく"
     "ださい。今は {clearance} mm です。"},
    {"fit.no_orientation",
     "the object fits the design space of {space} mm in no orientation that was tried: lying best it is "
     "still too long by {too_long}{one_axis}; {blocks} blocks would hold it without any wall",
     "調べたどの向きでも、対象物は設計空間 {space} mm に収まりません。最も収まる向きでも {too_long}長すぎ"
     "ます{one_axis}。{blocks} ブロックあれば、壁なしで収まります。"},
    {"search.leaves_space",
     "the object leaves the design space of {space} mm as it stands: make the space larger or turn the "
     "object before optimizing",
     "今の向きでは対象物が設計空間 {space} mm に収まりません。最適化の前に、空間を大きくするか、対象物を回"
     "してください。"},
    {"search.case_given",
     "the smallest case is looked for where none is given: leave the case out, or search for the best "
     "placement in it",
     "最小のケースは、ケースの指定がないときに探します。ケースの指定を外すか、その中で最良の配置を探してく"
     "ださい。"},
    {"case.too_many_blocks", "the case would take more than 4096 blocks on an axis: choose larger blocks",
     "ケースに 1 軸 4096 個を超えるブロックが必要です。ブロックを大きくしてください。"},
    {"case.too_small",
     "the case leaves {inside} mm (length, width, height) within its play, less than one block of {block} "
     "mm: choose smaller blocks or a larger case",
     "遊びを除いたケースの内側は {inside} mm（長さ、幅、高さ）で、{block} mm のブロック一つより小さくなっ"
     "ています。ブロックを小さくするか、ケースを大きくしてください。"},
    {"workshop.no_foams", "the object leaves the design space, so there are no foams",
     "対象物が設計空間に収まらないため、フォームがありません。"},
    {"fit.too_long", "{mm} mm along {axis}", "{axis} 方向に {mm} mm"},
    {"fit.too_long_too", " and {mm} mm along {axis}", "、{axis} 方向に {mm} mm"},
    {"fit.one_axis_upright", " (one axis is kept upright)", "（1 軸を上に保っています）"},
};

}  // namespace

std::span<const Wording> words_of_space() {
    return kWordsOfSpace;
}

}  // namespace snug

#include "snug/words/catalogue.h"

// Foam between object and case, and the case.

namespace snug {
namespace {

constexpr Wording kWordsOfWalls[] = {
    {"no_floor", "no foam is left {side}: the object would touch the case; {advice}",
     "{side}に緩衝材が残らず、対象物がケースに触れます。{advice}。"},
    {"no_roof", "no foam is left {side}: the object would touch the case; {advice}",
     "{side}に緩衝材が残らず、対象物がケースに触れます。{advice}。"},
    {"touches_case", "no foam is left {side}: the object would touch the case; {advice}",
     "{side}に緩衝材が残らず、対象物がケースに触れます。{advice}。"},
    {"thin_floor", "only {mm} mm of foam {side}; 25 mm is the least that cushions, 50 mm is usual: {advice}",
     "{side}の緩衝材は {mm} mm しかありません。緩衝には最低 25 mm、通常は 50 mm が必要です。{advice}。"},
    {"thin_roof", "only {mm} mm of foam {side}; 25 mm is the least that cushions, 50 mm is usual: {advice}",
     "{side}の緩衝材は {mm} mm しかありません。緩衝には最低 25 mm、通常は 50 mm が必要です。{advice}。"},
    {"thin_wall", "only {mm} mm of foam {side}; 25 mm is the least that cushions, 50 mm is usual: {advice}",
     "{side}の緩衝材は {mm} mm しかありません。緩衝には最低 25 mm、通常は 50 mm が必要です。{advice}。"},
    {"wall_below_wanted", "only {mm} mm of foam {side} where {wanted_mm} mm is wanted; {advice}",
     "{side}の緩衝材は {mm} mm で、希望の {wanted_mm} mm に足りません。{advice}。"},
    {"side.floor", "under the object (-x)", "対象物の下（-x）"},
    {"side.roof", "over the object (+x)", "対象物の上（+x）"},
    {"side.back", "at the back (-y)", "奥（-y）"},
    {"side.front", "at the front (+y)", "手前（+y）"},
    {"side.left", "at the left (-z)", "左（-z）"},
    {"side.right", "at the right (+z)", "右（+z）"},
    {"advice.walls", "--wall {walls} would do", "--wall {walls} とすれば足ります"},
    {"advice.move_or_case",
     "move or turn the object, or take a larger case: about {inside} mm inside (length, width, height)",
     "対象物を動かすか回す、または内寸 {inside} mm（長さ、幅、高さ）程度のより大きなケースを選んでください"},
    {"advice.move", "there is enough on the other side: --move {offset} would do",
     "反対側には余裕があるので、--move {offset} とすれば足ります"},
    {"advice.turn_or_case",
     "turn the object, or take a case of {inside} mm inside (length, width, height) or more",
     "対象物を回すか、内寸 {inside} mm（長さ、幅、高さ）以上のケースを選んでください"},
    {"advice.blocks", "--blocks {blocks} would do", "--blocks {blocks} とすれば足ります"},
    {"advice.larger_blocks", "take larger blocks, so that 4096 of them are enough",
     "4096 個で足りるように、ブロックを大きくしてください"},
    {"outside/case",
     "the object needs {needed} mm (length, width, height){clearance} and leaves the foam of its case, "
     "{foam} mm (length, width, height). Lacking: {lacking,}. A case would do from {least} mm (length, "
     "width, height) inside; `snug cases --for` lists those that fit, in every way to lay the object",
     "対象物には{clearance}{needed} mm（長さ、幅、高さ）が必要で、ケースの緩衝材 {foam} mm（長さ、幅、高"
     "さ）に収まりません。不足：{lacking,}。内寸 {least} mm（長さ、幅、高さ）以上のケースなら収まります。"
     "`snug cases --for` で、あらゆる向きで収まるケースを一覧できます。"},
    {"lacking.height", "{mm} mm of height", "高さ {mm} mm"},
    {"lacking.width", "{mm} mm of width", "幅 {mm} mm"},
    {"lacking.length", "{mm} mm of length", "長さ {mm} mm"},
    {"lacking.place", "nothing but the place: it is moved out of the middle",
     "大きさは足りますが、中央から動かされています"},
    {"leaves_case",
     "the object reaches into a rounded corner or leaning wall of the case: {blocks} "
     "{blocks|block|blocks} that it needs would lie outside; move or turn it, or take a larger case",
     "対象物がケースの角の丸みや傾いた壁に入り込みます。必要な {blocks} ブロックがケースの外になります。動"
     "かすか回す、またはより大きなケースを選んでください。"},
    {"off_lid_line/above", "the foams part {mm} mm above the lid's line, at the nearest step of the blocks",
     "緩衝材は、ふたの線より {mm} mm 上の、最も近いブロックの段で分かれます。"},
    {"off_lid_line/below", "the foams part {mm} mm below the lid's line, at the nearest step of the blocks",
     "緩衝材は、ふたの線より {mm} mm 下の、最も近いブロックの段で分かれます。"},
    {"cases.nothing_fits",
     "nothing in the list fits. A case would do from {least} mm (length, width, height) "
     "inside{nearest}{too_weak}",
     "一覧に収まるケースがありません。内寸 {least} mm（長さ、幅、高さ）以上が必要です。{nearest}{too_weak}"},
    {"cases.nearest", ". Nearest is {name} with {inside} mm, which lacks {lacking,}",
     "最も近いのは {name}（{inside} mm）で、{lacking,} 足りません。"},
    {"cases.too_weak", "; {name} is large enough but carries {kg} kg only",
     "{name} は十分な大きさですが、{kg} kg までしか運べません。"},
};

}  // namespace

std::span<const Wording> words_of_walls() {
    return kWordsOfWalls;
}

}  // namespace snug

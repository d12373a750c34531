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
     "ケースは {block} mm のブロックに分かれます。クリアランスは {least} mm（最も短い辺の -0.4 "
     "倍）以上にしてく"
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
    {"search.known_case_of_one",
     "--known-case arranges several items; which cases hold one object says {command}",
     "--known-case は複数のものを並べるときに使います。一つの対象物が入るケースは {command} "
     "で調べられます。"},
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
     "対象物が設計空間に収まらないため、緩衝材がありません。"},
    {"arrange.locked_nowhere", "{name} is locked and has no place to stay at: give it one ({example})",
     "{name} は固定されていますが、場所が決まっていません。場所を指定してください（{example}）。"},
    {"arrange.locked_meet",
     "{one} and {other} are both locked, and less than {between} mm of foam would stand between them: move "
     "one "
     "of them, or unlock it",
     "{one} と {other} はどちらも固定されていて、間の緩衝材が {between} mm "
     "に足りません。どちらかを動かすか、"
     "固定を外してください。"},
    {"arrange.locked_outside",
     "{name} is locked where it leaves the space of {space} mm: move it, or make the space larger",
     "{name} は、空間 {space} mm からはみ出る位置に固定されています。動かすか、空間を大きくしてください。"},
    {"arrange.layers",
     "{layers} layers are asked for, and there {items|is|are} {items} {items|item|items}: no layer may be "
     "empty, so "
     "ask for {items} at most (--layers)",
     "{layers} 段が指定されていますが、置くものは {items} 個です。空の段は作れないため、--layers は {items} "
     "以下に"
     "してください。"},
    {"arrange.cuts_nothing",
     "{name} cuts no block wherever it lies, so nothing says how much room it needs: choose smaller blocks "
     "or a "
     "larger clearance, or place it yourself",
     "{name} "
     "はどこに置いてもブロックを切り抜かず、必要な場所が決まりません。ブロックを小さくするか、クリアランスを"
     "大きく"
     "するか、自分で場所を指定してください。"},
    {"arrange.does_not_fit",
     "the {items} items do not go into {space} mm together, as far as was looked: {fit} of them do, without "
     "{left&}{holds}",
     "調べたかぎり、{items} 個すべては {space} mm に収まりません。収まるのは {fit} 個で、{left,} "
     "が残ります{holds}。"},
    {"arrange.holds", "; {blocks} blocks would hold all of them, with their walls",
     "（{blocks} ブロックあれば、壁も含めてすべて収まります）"},
    {"arrange.none_around_locked",
     "no space was found that holds the others around what is locked, as far as was looked: unlock it, move "
     "it, or say how large the space is (--blocks)",
     "固定されたもののまわりに、ほかのものも入る空間は、調べたかぎり見つかりませんでした。固定を解除するか、"
     "動かすか、"
     "空間の大きさを指定してください（--blocks）。"},
    {"arrange.too_large",
     "the items and their walls need more than 4096 blocks on an axis: choose larger blocks",
     "置くものと壁に、1 軸 4096 個を超えるブロックが必要です。ブロックを大きくしてください。"},
    {"arrange.no_item", "there is no such item to make copies of", "複製するものがありません。"},
    {"arrange.fills_nothing",
     "as many as fit needs a space to fill: choose a case or a number of blocks first",
     "いくつ入るかを調べるには、先にケースかブロック数を選んでください。"},
    {"arrange.no_known_case",
     "none of the {cases} known cases holds the items together, as far as was looked: let the space be "
     "fitted to "
     "them (--blocks auto) to see what they need",
     "調べたかぎり、登録されている {cases} 個のケースのどれにも、すべてのものは収まりません。--blocks auto "
     "で必要な"
     "大きさを確かめてください。"},
    {"fit.too_long", "{mm} mm along {axis}", "{axis} 方向に {mm} mm"},
    {"fit.too_long_too", " and {mm} mm along {axis}", "、{axis} 方向に {mm} mm"},
    {"fit.one_axis_upright", " (one axis is kept upright)", "（1 軸を上に保っています）"},
};

}  // namespace

std::span<const Wording> words_of_space() {
    return kWordsOfSpace;
}

}  // namespace snug

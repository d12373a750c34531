#include "snug/words/catalogue.h"

// Slit sponge and milled foam.

namespace snug {
namespace {

constexpr Wording kWordsOfSpongeAndMill[] = {
    {"many_maps",
     "the maps at true size would fill more than {pages} pages, so sponge-maps.pdf leaves the layers out: "
     "print the files in sponge/ on a plotter, work by the overview, or take larger blocks",
     "原寸の図が {pages} ページを超えるため、sponge-maps.pdf では各層を省きました。sponge/ のファイルをプ"
     "ロッターで印刷するか、全体図を見て作業するか、ブロックを大きくしてください。"},
    {"cut_off/sponge",
     "the case has no room for {blocks} {blocks|block|blocks} at the sides of the layers: cut them off "
     "first; each map shows its own in grey",
     "層の縁の {blocks} "
     "ブロックはケースに入りません。先に切り落としてください。各図に灰色で示してあります。"},
    {"round_corners/both",
     "a round cutter of {cutter_mm} mm leaves {left_cm3} cm3 of foam in inside corners where the object "
     "does not reach, and takes foam beside the blocks where it must go beyond them to reach a corner (up "
     "to {widest_mm} mm wide, {taken_cm3} cm3 together); a thinner cutter makes both less",
     "直径 {cutter_mm} mm の刃では、対象物の届かない内側の角に {left_cm3} cm3 の緩衝材が残り、角に届くた"
     "めブロックの外まで切る所があります（幅最大 {widest_mm} mm、合わせて {taken_cm3} cm3）。刃を細くする"
     "と、どちらも減ります。"},
    {"round_corners/left",
     "a round cutter of {cutter_mm} mm leaves {left_cm3} cm3 of foam in inside corners where the object "
     "does not reach; a thinner cutter makes both less",
     "直径 {cutter_mm} mm の刃では、対象物の届かない内側の角に {left_cm3} cm3 の緩衝材が残ります。刃を細"
     "くすると減ります。"},
    {"round_corners",
     "a round cutter of {cutter_mm} mm takes foam beside the blocks where it must go beyond them to reach "
     "a corner (up to {widest_mm} mm wide, {taken_cm3} cm3 together); a thinner cutter makes both less",
     "直径 {cutter_mm} mm の刃では、角に届くためブロックの外まで切る所があります（幅最大 {widest_mm} mm、"
     "合わせて {taken_cm3} cm3）。刃を細くすると減ります。"},
    {"no_pins",
     "there is too little foam of full height for pins of {pin_mm} mm, so there are none: line the halves "
     "up by their edges, or choose others with --pin (0: none)",
     "{pin_mm} mm のピンを通せる全高の緩衝材が足りないため、ピンはありません。下とふたを縁で合わせるか、"
     "--pin で別のピンを選んでください（0：なし）。"},
    {"no_pins/cutter",
     "holes for pins of {pin_mm} mm cannot be made with a cutter of {cutter_mm} mm, so there are none: "
     "line the halves up by their edges, or choose others with --pin (0: none)",
     "直径 {cutter_mm} mm の刃では {pin_mm} mm のピンの穴を開けられないため、ピンはありません。下とふたを"
     "縁で合わせるか、--pin で別のピンを選んでください（0：なし）。"},
    {"nothing_to_mill", "both halves are flat boards: there is nothing to mill",
     "下もふたも平らな板なので、削るところがありません。"},
    {"mill.too_many_moves",
     "the program for the {half} would have more than {most} moves: take larger blocks, a larger cutter, "
     "or deeper passes (--step-down)",
     "{half}のプログラムが {most} 動作を超えます。ブロックか刃を大きくするか、切込みを深くしてください（"
     "--step-down）。"},
    {"mill.too_many_columns",
     "the foam has more columns than can be milled with a cutter of {cutter_mm} mm; take larger blocks or "
     "a larger cutter",
     "緩衝材の列が多すぎて、直径 {cutter_mm} mm "
     "の刃では切削できません。ブロックか刃を大きくしてください。"},
    {"mill.short_flute",
     "the flute reaches {flute_mm} mm, but the {half} is cut {depth_mm} mm deep: take a cutter with a "
     "flute of at least {depth_mm} mm (--flute), turn the object so that it lies flatter (--rotate), or "
     "choose another parting level (--parting)",
     "刃長は {flute_mm} mm ですが、{half}の切削の深さは {depth_mm} mm です。刃長 {depth_mm} mm 以上の刃を"
     "使うか（--flute）、対象物をもっと平らに寝かせるか（--rotate）、分割の高さを変えてください（"
     "--parting）。"},
    {"mill.wide_cutter",
     "a cutter of {cutter_mm} mm is wider than every pocket; the widest that goes in is {widest_mm} mm. "
     "Choose it with --cutter, or a larger clearance",
     "直径 {cutter_mm} mm の刃は、どのくぼみにも入りません。入る最大の直径は {widest_mm} mm です。"
     "--cutter で選ぶか、クリアランスを大きくしてください。"},
    {"mill.under_side", "{half}'s underside", "{half}の下面"},
    {"mill.outer_side", "{half}'s outer side", "{half}の外側"},
};

}  // namespace

std::span<const Wording> words_of_sponge_and_mill() {
    return kWordsOfSpongeAndMill;
}

}  // namespace snug

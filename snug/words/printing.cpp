#include "snug/words/catalogue.h"

// Printed foam, and moulds.

namespace snug {
namespace {

constexpr Wording kWordsOfPrinting[] = {
    {"no_dowel/foam",
     "dowels of {diameter_mm} x {length_mm} mm find too little foam around them where {pairs} "
     "{pairs|pair|pairs} of parts meet: glue them face to face, or take smaller dowels or a larger bed",
     "部品の合わせ目 {pairs} か所では、{diameter_mm} x {length_mm} mm のダボのまわりの緩衝材が足りません。"
     "面同士を接着するか、小さいダボか大きいベッドを選んでください。"},
    {"no_dowel/plastic",
     "dowels of {diameter_mm} x {length_mm} mm find too little plastic around them where {pairs} "
     "{pairs|pair|pairs} of parts meet: glue them face to face, or take smaller dowels or a larger bed",
     "部品の合わせ目 {pairs} か所では、{diameter_mm} x {length_mm} mm のダボのまわりの樹脂が足りません。面"
     "同士を接着するか、小さいダボか大きいベッドを選んでください。"},
    {"rigid/print",
     "printed plastic holds the object but is no cushion: put foam between it and the outer box",
     "印刷した樹脂は対象物を支えますが、緩衝にはなりません。外箱との間に緩衝材を入れてください。"},
    {"overhang",
     "the case widens, so {parts} {parts|part|parts} lean out over their lowest blocks: let the printer's "
     "program put support under them{glue}",
     "ケースが広がるため、{parts} 個の部品が一番下のブロックより外に張り出します。プリンターのソフトでサポ"
     "ートを付けてください{glue}。"},
    {"overhang/middle",
     "{parts} {parts|part|parts} of the middle foams have a cavity below: let the printer's program put "
     "support under them{glue}",
     "中間の緩衝材の部品 {parts} 個は下側にもくぼみがあります。プリンターのソフトでサポートを付けてくださ"
     "い{glue}。"},
    {"overhang.glue", ", and glue them face to face: they have no dowels",
     "（ダボがないため、面同士を接着してください）"},
    {"narrow_foam",
     "{blocks} {blocks|block|blocks} of the {foam} {blocks|is|are} not cast: the foam is too narrow there "
     "to leave room between faces that lean by {lean}; take a smaller draft",
     "{foam}の {blocks} ブロックは注型されません。{lean}傾く面の間に余地が残らないほど、緩衝材が細い所で"
     "す。抜き勾配を小さくしてください。"},
    {"draft",
     "faces lean by {lean} to let the foam go, so it is smaller than its blocks towards the cavity: "
     "{foams,}; a smaller draft keeps more",
     "緩衝材が抜けるように面が{lean}傾くため、くぼみに向かってブロックより小さくなります：{foams,}。抜き"
     "勾配を小さくすると減りません。"},
    {"draft.foam", "the {foam} by up to {mm} mm on each side and {lost_litres} of {litres} litres",
     "{foam}は各面で最大 {mm} mm、{litres} リットルのうち {lost_litres} リットル"},
    {"draft.degree", "{degrees} degree", " {degrees} 度"},
    {"draft.degrees", "{degrees} degrees", " {degrees} 度"},
    {"upright",
     "the mould of the {foams} is cut apart along faces of its core, which stand upright there: rub them "
     "smooth, and take the mould apart there to let the foam out",
     "{foams}の型は中子の面に沿って分割され、そこでは面が垂直です。滑らかに磨き、そこで型を分けて緩衝材"
     "を取り出してください。"},
    {"upright.both", "lower foam and the lid", "下の緩衝材とふた"},
    {"trim",
     "the case leaves no room for {blocks} {blocks|block|blocks} at the outer side of the {foam}, "
     "{litres} litres, which the mould casts: trim them off by hand until the foam lies in the case",
     "{foam}の外側の {blocks} ブロック（{litres} リットル）は型で作られますが、ケースに入りません。ケース"
     "に収まるまで手で切り落としてください。"},
    {"mould.layers",
     "foams of several layers are not cast yet: a middle foam has a cavity on each side, which a mould with "
     "one "
     "core does not leave. Pack the layers as designs of their own, or take --for {ways/}",
     "複数の段の緩衝材は、まだ注型できません（中間の緩衝材は両側にくぼみがあり、コアが一つの型では抜けま"
     "せん）。段ごとに別の設計にするか、--for で {ways/} を選んでください。"},
    {"mould.nothing_to_cast", "there is no foam to cast: the object takes every block; take a larger space",
     "対象物がすべてのブロックを占め、流し込む緩衝材がありません。空間を大きくしてください。"},
    {"mould.small_bed",
     "a bed of {bed} mm is smaller than a block of foam with the mould's walls, which takes {needed} mm "
     "on it; take a bed of at least that, smaller blocks or thinner walls",
     "{bed} mm のベッドは、型の壁を含めた緩衝材のブロック一つ（ベッド上で {needed} mm）より小さくなって"
     "います。それ以上のベッドか、小さいブロック、薄い壁を選んでください。"},
    {"print.small_bed",
     "a bed of {bed} mm is smaller than a block of foam, which lies {needed} mm on it; take a bed of at "
     "least that, or smaller blocks",
     "{bed} mm のベッドは、緩衝材のブロック一つ（ベッド上で {needed} mm）より小さくなっています。それ以"
     "上のベッドか、小さいブロックを選んでください。"},
    {"print.too_many_parts",
     "on a bed of {bed} mm the foams would come in more than {most} parts; take a larger bed, or blocks "
     "that make a smoother foam",
     "{bed} mm のベッドでは、緩衝材の部品が {most} 個を超えます。ベッドを大きくするか、緩衝材の凹凸が"
     "少なくなるブロックを選んでください。"},
};

}  // namespace

std::span<const Wording> words_of_printing() {
    return kWordsOfPrinting;
}

}  // namespace snug

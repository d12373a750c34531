#include "snug/words/catalogue.h"

// How moulds are printed, put together and poured.

namespace snug {
namespace {

constexpr Wording kWordsOfMouldPages[] = {
    {"mould.title", "{name}: mould guide", "{name}：型の手引き"},
    {"mould.subtitle",
     "Moulds to pour foam or silicone into · walls {wall} mm · rim {rim} mm · draft {draft} degrees",
     "発泡樹脂やシリコーンを注ぐ型 · 壁 {wall} mm · 縁 {rim} mm · 抜き勾配 {draft} 度"},
    {"mould.column_outside", "mould outside, mm", "型の外寸 (mm)"},
    {"mould.column_parts", "parts", "部品"},
    {"mould.column_pour", "to pour", "注ぐ量"},
    {"mould.column_plastic", "plastic, solid", "樹脂（中実）"},
    {"mould.beds", "On {beds} {beds|bed|beds}: mould/bed-01.3mf and on, or each part on its own as STL.",
     "印刷は {beds} 回：mould/bed-01.3mf から順に。部品ごとの STL もあります。"},
    {"mould.print",
     "Print each bed as it lies, without supports: nothing overhangs. Layers of 0.2 mm or finer, "
     "walls of at least three lines; the core may be filled sparsely. Write LOWER or LID on each "
     "mould.",
     "どのファイルもそのままの置き方で、サポートなしで印刷します。張り出しはありません。積層は 0.2 "
     "mm 以下、壁は 3 本以上とし、内部の充填は粗くてかまいません。型に LOWER（下）か LID（ふた）と書"
     "きます。"},
    {"mould.join",
     "Put the parts of a mould together on a flat board as its picture shows, and glue or clamp "
     "them. Seal every joint from inside with wax, modelling clay or tape: what is poured finds "
     "every gap.",
     "型の部品を、図のとおりに平らな板の上で組み、接着するか締め付けます。注いだものはどんなすきまに"
     "も入るので、継ぎ目はすべて内側から、ろう、粘土、テープでふさぎます。"},
    {"mould.join_dowels",
     "Put the parts of a mould together on a flat board as its picture shows, with the dowels in "
     "their bores, and glue or clamp them. Seal every joint from inside with wax, modelling clay or "
     "tape: what is poured finds every gap.",
     "型の部品を、図のとおりに、ダボを穴に入れて平らな板の上で組み、接着するか締め付けます。注いだも"
     "のはどんなすきまにも入るので、継ぎ目はすべて内側から、ろう、粘土、テープでふさぎます。"},
    {"mould.release",
     "Smooth what is rough, then brush all inner faces with the release agent that the foam's or "
     "silicone's maker names; printed layers hold foam fast without it.",
     "粗い所をならし、内側の面すべてに、発泡樹脂やシリコーンの製造元が指定する離型剤を塗ります。塗ら"
     "ないと、印刷の層に緩衝材が張り付きます。"},
    {"mould.pour",
     "Level the mould. Pour {pours;}. These are litres of what has set. Foams expand many times as "
     "they rise: weigh out by the maker's free-rise density, less at first, and close the top with a "
     "flat greased board that lets air out, so that the rise ends at the line.",
     "型を水平に置き、注ぎます。{pours;}。これは固まった後の量です。緩衝材は何倍にも膨らむので、製"
     "造元の自由発泡密度から量を計算し、初めは少なめにします。離型剤を塗った平らな板を、空気が抜ける"
     "ように載せ、膨らみが線で止まるようにします。"},
    {"mould.pour_to_ledge",
     "{half}: {litres}, to the narrow ledge that runs round below the rim, {mm} mm above the mould's "
     "floor",
     "{half}は {litres}（縁の下を回る細い段まで、型の底から {mm} mm）"},
    {"mould.pour_to_top", "{half}: {litres}, to the top of the walls, {mm} mm above the mould's floor",
     "{half}は {litres}（壁の上端まで、型の底から {mm} mm）"},
    {"mould.cure",
     "Let it cure as long as the maker says. Trim what stands above the line flat: that is the outer "
     "side of the foam.",
     "製造元の指定する時間をおいて硬化させます。線より上に出た所を平らに切り落とします。そこが緩衝材"
     "の外側になります。"},
    {"mould.mark",
     "Write LOWER or LID on that side, and BACK along the edge that the picture marks so, before it "
     "comes out.",
     "型から出す前に、その面に LOWER（下）か LID（ふた）と書き、図で BACK とある縁に BACK と書きます"
     "。"},
    {"mould.mark_rim",
     "Write LOWER or LID on that side, and BACK along the edge that the picture marks so, before it "
     "comes out; the corner of the mould without a rim is column A1 at BACK.",
     "型から出す前に、その面に LOWER（下）か LID（ふた）と書き、図で BACK とある縁に BACK と書きます"
     "。型の縁が欠けている角が、奥の A1 です。"},
    {"mould.pull",
     "Pull the foam straight up, loosening it along the walls first; or take the mould apart at its "
     "joints. Turn it over from front to back: it is the half, cavity up; BACK now lies away from "
     "you in the lower foam, towards you in the lid.",
     "壁に沿ってはがしてから、緩衝材をまっすぐ上に引き抜きます。型を継ぎ目で分けてもかまいません。"
     "前後に裏返すと、くぼみが上になります。BACK は、下の緩衝材では向こう側、ふたでは手前です。"},
    {"mould.close",
     "Close the empty halves once, lid over lower foam, BACK over BACK: the rims touch all round.",
     "空のまま一度、BACK どうしを合わせて、下の緩衝材にふたをかぶせます。縁が全周で触れれば合ってい"
     "ます。"},
    {"mould.heading", "{half}: the mould", "{half}の型"},
    {"mould.page_of", "{name} · from above, as it stands on the table · {size} mm · pour {litres}",
     "{name} · 台に置いて上から見た図 · {size} mm · 注ぐ量 {litres}"},
    {"mould.read_picture",
     "The foam lies in it cavity down: the core makes the cavity, and where it is white the foam's "
     "rim lies on the mould's floor. {numbers}{corner} Leaning faces are not drawn.",
     "緩衝材は、くぼみを下にして型に入っています。中子がくぼみを作り、白い所では緩衝材の縁が型の"
     "底に接します。{numbers}{corner}傾いた面は描いていません。"},
    {"mould.numbers", "Numbers are the core's height in blocks of {mm} mm. ",
     "数字は中子の高さ（{mm} mm のブロックの数）です。"},
    {"mould.corner", "The black corner is column A1.", "黒い角が A1 です。"},
    {"mould.corner_rim", "The black corner is column A1, where the mould has no rim.",
     "黒い角が A1 で、そこだけ型の縁がありません。"},
    {"mould.its_parts", "Its parts", "型の部品"},
    {"mould.where_parts",
     "Where the least corner of each stands: mm from the left, from the front and from the table.",
     "各部品の左手前下の角の位置：左から、手前から、台からの mm。"},
    {"mould.part", "part", "部品"},
    {"mould.left", "left", "左から"},
    {"mould.front", "front", "手前から"},
    {"mould.up", "up", "台から"},
    {"mould.size", "size", "大きさ"},
    {"mould.others", "The other {parts} are in mould/parts.csv.",
     "ほかの {parts} 個は mould/parts.csv にあります。"},
    {"mould.pour_here", "pour to here", "ここまで注ぐ"},
    {"mould.section", "section", "断面"},
    {"mould.core_scale", "Core above the floor", "底からの中子の高さ"},
};

}  // namespace

std::span<const Wording> words_of_mould_pages() {
    return kWordsOfMouldPages;
}

}  // namespace snug

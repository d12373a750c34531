#include "snug/words/catalogue.h"

// How the sheets are glued, and titles of their drawings.

namespace snug {
namespace {

constexpr Wording kWordsOfSheetsPages[] = {
    {"sheets.title", "{name}: how to glue the sheets", "{name}：シートの貼り合わせ方"},
    {"sheets.page_order", "{half}, order of work", "{half}、作業の手順"},
    {"sheets.page_pictures", "{half}, sheets in their order", "{half}、シートの順番"},
    {"sheets.heading_order", "{half}: {sheets} {sheets|sheet|sheets}, cavity facing you",
     "{half}：{sheets} 枚（くぼみ側から）"},
    {"sheets.heading_pictures", "{half}: sheets in their order, cavity facing you",
     "{half}：シート順（くぼみ側から）"},
    {"sheets.subtitle", "{name} - sheets of {mm} mm", "{name} - 厚さ {mm} mm のシート"},
    {"sheets.lay_lower",
     "Lay {first} on the table, the engraved side up and the arrow to BACK pointing away from you. "
     "{first} touches the case; the cavity grows upward, facing you.",
     "{first} を、刻印のある面を上に、BACK への矢印を向こう側に向けて台に置きます。{first} はケースに"
     "接するシートです。くぼみは上に向かってできていきます。"},
    {"sheets.lay_middle",
     "Lay {first} on the table, the engraved side up and the arrow to BACK pointing away from you. "
     "{first} is the underside, with the cavities of the layer below; those of the layer above grow upward, "
     "facing you.",
     "{first} を、刻印のある面を上に、BACK への矢印を向こう側に向けて台に置きます。{first} は下面で、下の段"
     "のくぼみがあります。上の段のくぼみは上に向かってできていきます。"},
    {"sheets.lay_lid",
     "Lay {first} on the table, the engraved side up and the arrow to BACK pointing towards you. "
     "{first} touches the case at the top: the lid is built upside down, its cavity facing you.",
     "{first} を、刻印のある面を上に、BACK への矢印を手前に向けて台に置きます。{first} はケースの上面"
     "に接するシートです。ふたは上下を逆にして、くぼみを上に向けて組み立てます。"},
    {"sheets.put_dowels",
     "Put {dowels} dowels of {mm} mm into its holes. They go through {first} to {last} and fit one "
     "way only: where they do not meet the holes, the sheet is turned or lies upside down.",
     "その穴に、直径 {mm} mm のダボを {dowels} 本差します。ダボは {first} から {last} までを通り、正"
     "しい向きにしか合いません。穴に合わないときは、シートの向きか表裏が逆です。"},
    {"sheets.glue_one",
     "Glue {sheet} on it one after the other, numbers upward, arrows to BACK, odd corners above each "
     "other. The line on each sheet shows where the next one ends.",
     "{sheet} を、番号を上に、矢印を BACK に向け、目印の角をそろえて、その上に接着します。シートの線"
     "は、次のシートの端の位置を示します。"},
    {"sheets.glue_all",
     "Glue {first} to {last} on it one after the other, numbers upward, arrows to BACK, odd corners "
     "above each other. The line on each sheet shows where the next one ends.",
     "{first} から {last} までを順に、番号を上に、矢印を BACK に向け、目印の角をそろえて、その上に接"
     "着します。シートの線は、次のシートの端の位置を示します。"},
    {"sheets.glue_islands", "Glue the islands ({islands}) where the sheet before shows their outlines.",
     "島（{islands}）は、前のシートに示された輪郭の位置に接着します。"},
    {"sheets.glue_hanging",
     "These lie on no sheet, glue each under the sheet after it, where its picture shows it: {islands}.",
     "次の部品はどのシートにも載りません。それぞれ図の位置で、次のシートの下面に接着します：{islands}"},
    {"sheets.glue_loose",
     "Held by no sheet: {islands}. Glue all pieces of {first} onto a backing sheet, as on its "
     "picture.",
     "支えるシートのない部品：{islands}。{first} の部品はすべて、図のとおりに台紙に接着します。"},
    {"sheets.colors", "{sheet} is of the first colour, all sheets below it of the second.",
     "{sheet} は一色目、その下のシートはすべて二色目です。"},
    {"sheets.slit",
     "Slit {sheet} along the lines of the layer {layer}, {mm} mm from the cavities, with a knife: about "
     "half "
     "through, never all the way. Lay the liner over the cavities, the smooth side to the object, and tuck "
     "its edges "
     "into the slits with a blunt blade.",
     "{sheet} を、くぼみから {mm} mm "
     "の所にある{layer} の層の線に沿ってナイフで切ります。深さは厚みの半分ほどで、貫通"
     "させません。内張りを滑らかな面を対象物側にしてくぼみに敷き、縁をへらで切れ目に差し込みます。"},
    {"sheets.lower_done", "The lower foam is done: it goes into the case with {first} below.",
     "これで下の緩衝材の完成です。{first} を下にしてケースに入れます。"},
    {"sheets.middle_done",
     "The middle foam is done: once the layer below is packed it goes onto it with {first} below, BACK on "
     "BACK.",
     "これで中間の緩衝材の完成です。下の段を収めたら、{first} を下に、BACK どうしを合わせて載せます。"},
    {"sheets.lid_done",
     "The lid is done: turn it over about its BACK edge onto the lower foam, BACK on BACK.",
     "これでふたの完成です。奥（BACK）の縁を軸に裏返し、BACK どうしを合わせて下の緩衝材にかぶせます"
     "。"},
    {"sheets.laser",
     "Ask the maker of the foam whether it may be cut by laser: never PVC (chlorine); polystyrene, "
     "polypropylene, polyethylene and polyurethane foams burn or give off poisonous gases, and many "
     "workshops forbid them. A knife or water jet cuts all.",
     "レーザーで切ってよいか、緩衝材の製造元に確かめてください。塩化ビニルは塩素が出るので、決して"
     "切らないでください。ポリスチレン、ポリプロピレン、ポリエチレン、ポリウレタンの緩衝材は燃えた"
     "り有毒なガスを出したりするため、多くの工房で禁じられています。ナイフやウォータージェットなら、"
     "どれでも切れます。"},
    {"sheets.measure",
     "All lengths in the cutter's files are millimetres; in a DXF file one unit is one millimetre. "
     "Measure before you cut: in {file} piece {piece} is {mm} mm wide from its leftmost to its "
     "rightmost edge. If the cutter's program says otherwise, open the file there again as "
     "millimetres.",
     "カッター用のファイルの長さは、すべてミリメートルです（DXF では 1 単位が 1 mm）。切る前に測って"
     "ください。{file} の部品 {piece} は、左端から右端までの幅が {mm} mm です。カッターのソフトの値が"
     "違うときは、ミリメートルとして開き直します。"},
    {"sheets.bar", "100 mm on paper printed at 100 %", "100 % で印刷した紙で 100 mm"},
    {"sheets.pieces", "{pieces} {pieces|piece|pieces}", "部品 {pieces} 個"},
    {"sheets.islands", "{islands} {islands|island|islands}", "島 {islands} 個"},
    {"sheets.layer_below", "layer below", "下の段"},
    {"sheets.case_below", "case, below", "ケース（下側）"},
    {"sheets.case_above", "case, above when closed (seen upside down)",
     "ケース（閉じると上側。逆さに見た図）"},
    {"sheets.stock_title", "{name}: stock sheet {sheet} of {sheets}, {mm} mm thick, lengths in mm",
     "{name}：材料シート {sheets} 枚中 {sheet} 枚目、厚さ {mm} mm、長さは mm"},
    {"sheets.stock_title/upper",
     "{name}: stock sheet {sheet} of {sheets}, {mm} mm thick, first colour (uppermost sheets), lengths in mm",
     "{name}：材料シート {sheets} 枚中 {sheet} 枚目、厚さ {mm} mm、一色目（いちばん上のシート）、長さは mm"},
    {"sheets.stock_title/below",
     "{name}: stock sheet {sheet} of {sheets}, {mm} mm thick, second colour (sheets below), lengths in mm",
     "{name}：材料シート {sheets} 枚中 {sheet} 枚目、厚さ {mm} mm、二色目（下のシート）、長さは mm"},
    {"sheets.fit_title", "{name}: fit test, lengths in mm", "{name}：試験片、長さは mm"},
};

}  // namespace

std::span<const Wording> words_of_sheets_pages() {
    return kWordsOfSheetsPages;
}

}  // namespace snug

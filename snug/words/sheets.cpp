#include "snug/words/catalogue.h"

// Foam of sheets.

namespace snug {
namespace {

constexpr Wording kWordsOfSheets[] = {
    {"sheets-lost",
     "Sheets as thick as {levels} blocks take {blocks} {blocks|block|blocks} more from the {foam} than "
     "the design: {mm3} mm3, {litres} litres. The object fits with more room.{lower}",
     "ブロック {levels} 個分の厚さのシートでは、{foam}から設計より {blocks} ブロック多く切り取られます（"
     "{mm3} mm3、{litres} リットル）。対象物はゆとりをもって収まります。{lower}"},
    {"sheets.ends_lower",
     " At its highest the half ends {mm} mm lower: choose blocks and a parting level that are multiples "
     "of {levels}, or thinner sheets.",
     "ただし最も高い所は {mm} mm 低くなります。ブロック数と分割の高さを {levels} の倍数にするか、薄いシー"
     "トを選んでください。"},
    {"sheets-loose",
     "In the {foam} the cut goes through to the case, and {pieces} {count|is|are} held by no "
     "sheet{falls_out}: glue the first sheet's pieces onto a backing sheet, or make the space deeper.",
     "{foam}の切り抜きがケースまで貫通し、{pieces} を支えるシートがありません{falls_out}。最初のシートの部"
     "品を台紙に接着するか、空間を深くしてください。"},
    {"sheets-loose/middle",
     "Pieces of the {foam} stand between cavities of the layer below and lie on no sheet; glue each under "
     "the "
     "sheet after it: {pieces}.",
     "{foam}には、下の段のくぼみの間にあって、どのシートにも載らない部品があります。それぞれ次のシートの下"
     "面に接着してください：{pieces}"},
    {"sheets.falls_out", " and would fall out when the lid is lifted", "（ふたを持ち上げると落ちます）"},
    {"sheets-islands",
     "Islands of the {foam} fall out of their sheets when cut; keep them and glue each onto the sheet "
     "before: {pieces}.",
     "{foam}の島は切るとシートから離れます。取っておき、それぞれ前のシートに接着してください：{pieces}"},
    {"sheets-overhang",
     "The case widens from the first sheet on, so {sheets} {sheets|sheet|sheets} of the {foam} reach over "
     "the sheet before: lay them by the dowels, or by the picture of each sheet within the dashed "
     "rectangle.",
     "ケースが最初のシートから広がるため、{foam}の {sheets} 枚のシートが前のシートからはみ出します。ダボに"
     "合わせるか、破線の四角の中の各シートの図に合わせて重ねてください。"},
    {"sheets-overhang/middle",
     "The {foam} has cavities below, so {sheets} {sheets|sheet|sheets} of it reach over the sheet before: "
     "lay "
     "them by the dowels, or by the picture of each sheet within the dashed rectangle.",
     "{foam}は下側にもくぼみがあるため、{sheets} 枚のシートが前のシートからはみ出します。ダボに合わせるか、"
     "破線の四角の中の各シートの図に合わせて重ねてください。"},
    {"sheets-dowels",
     "No two dowels of {dowel_mm} mm with {edge_mm} mm of foam around them go through the sheets of the "
     "{foam}: lay them by the marked outlines, or choose thinner dowels.",
     "{foam}のシートには、まわりに {edge_mm} mm の緩衝材を残して {dowel_mm} mm のダボを二本通す場所があ"
     "りません。記された輪郭に合わせて重ねるか、細いダボを選んでください。"},
    {"sheets-dowels/one",
     "Sheet {sheet} of the {foam} has no room for dowels: lay them by the outline that is marked on the "
     "sheet before.",
     "{foam}のシート {sheet} にはダボの余地がありません。前のシートに記された輪郭に合わせて重ねてください。"},
    {"sheets-dowels/several",
     "Sheets {first} to {last} of the {foam} have no room for dowels: lay them by the outline that is "
     "marked on the sheet before.",
     "{foam}のシート {first}～{last} にはダボの余地がありません。前のシートに記された輪郭に合わせて重ねて"
     "ください。"},
    {"sheets-dowels/fewer", "The sheets of the {foam} have room for {found} dowels instead of {wanted}.",
     "{foam}のシートには、ダボは {wanted} 本ではなく {found} 本しか入りません。"},
    {"sheets-unnumbered",
     "Too small for an engraved number, so number them by hand as they come off the cutter: {pieces}.",
     "小さくて番号を刻めないため、切り出しながら手で番号を書いてください：{pieces}"},
    {"sheets.names", "{names&}", "{names&}"},
    {"sheets.names_and_more", "{names,} and {more} more", "{names,}、ほか {more} 個"},
    {"sheets.too_many_pieces",
     "The foam falls into more than {most} pieces of sheet, which no one glues; choose larger blocks or a "
     "smoother object.",
     "緩衝材がシートの部品 {most} 個を超え、貼り合わせられません。ブロックを大きくするか、凹凸の少ない対"
     "象物にしてください。"},
    {"sheets.thickness",
     "Sheets of {thickness} do not make up this foam, whose blocks are {depth} deep and whose thickest "
     "half is {thickest}: a sheet must be a whole part or a multiple of a block. The nearest that work: "
     "{nearest}.",
     "厚さ {thickness} のシートではこの緩衝材を作れません。ブロックの深さは {depth}、厚い方の緩衝材は "
     "{thickest} です。シートの厚さは、ブロックの整数分の一か整数倍にしてください。最も近い厚さ：{nearest}"},
    {"sheets.no_foam", "The design leaves no foam to cut into sheets; make the space larger than the object.",
     "シートに切り分ける緩衝材がありません。対象物より大きい空間にしてください。"},
    {"sheets.kerf",
     "A kerf of {kerf_mm} mm cannot cut openings as narrow as one block, {block_mm} mm; choose a smaller "
     "kerf or larger blocks.",
     "切り幅 {kerf_mm} mm では、ブロック一つ分（{block_mm} mm）の狭い開口を切れません。切り幅を小さくする"
     "か、ブロックを大きくしてください。"},
    {"sheets.either", "{thinner} or {thicker}", "{thinner} か {thicker}"},
    {"sheets.too_large",
     "Sheet {sheet} does not fit on a stock sheet of {stock_mm} mm; with margins the stock must be at "
     "least {least_mm} mm.",
     "シート {sheet} が {stock_mm} mm の材料に収まりません。余白を含めて {least_mm} mm 以上の材料が必要で"
     "す。"},
};

}  // namespace

std::span<const Wording> words_of_sheets() {
    return kWordsOfSheets;
}

}  // namespace snug

#include "snug/words/catalogue.h"

// What is wrong with a design beyond the range of each option by itself; presets and cases.

namespace snug {
namespace {

constexpr Wording kWordsOfDesign[] = {
    {"clearance.most", "the clearance must be at most {most} mm",
     "クリアランスは {most} mm 以下にしてください。"},
    {"clearance.least",
     "the clearance must be {least} mm or more for these blocks (-0.4 of the smallest side), not {found}",
     "このブロックでは、クリアランスを {least} mm（最も短い辺の -0.4 "
     "倍）以上にしてください（指定：{found}）。"},
    {"parting.layers",
     "the design has {layers} layers of items and {found} parting levels: give one level for each layer, or "
     "auto",
     "段は {layers}、分割の高さは {found} 個です。段ごとに一つずつ指定するか、auto にしてください。"},
    {"parting.not_rising", "the parting levels must rise from layer to layer, the lowest layer's first",
     "分割の高さは、下の段から順に高くなるように指定してください。"},
    {"parting.range", "the parting level must be auto or 0 to {most} blocks, not {found}",
     "分割の高さは auto または 0～{most} ブロックにしてください（指定：{found}）。"},
    {"formats.none", "name at least one format: stl, ply",
     "stl、ply のうち一つ以上の形式を指定してください。"},
    {"case.not_widest",
     "the case must be widest at its parting line: {where} it may measure up to {most}, not {found}",
     "ケースは分割線で最も広くなければなりません。{where}の寸法は {most} "
     "以下にしてください（指定：{found}）。"},
    {"case.at_floor", "at its floor", "底"},
    {"case.at_roof", "at its roof", "上面"},
    {"case.nothing_left", "nothing of the case is left {where} within its play of {play} on each side",
     "ケースの{where}では、各面の遊び {play} を除くと何も残りません。"},
    {"case.no_inside", "nothing of the case of {inside} mm is left within its play of {play} on each side",
     "内寸 {inside} mm のケースから各面の遊び {play} を除くと、何も残りません。"},
    {"case.lid", "the lid must be 0 mm or more and less than the case's height of {height}, not {lid}",
     "ふたの高さは 0 mm 以上、ケースの高さ {height} 未満にしてください（指定：{lid}）。"},
    {"case.top_without_lid",
     "what the case measures at the roof of its lid needs the lid's height: give both (--case LxWxH:LID with "
     "--case-top), or leave it out",
     "ふたの上面の寸法には、ふたの高さも必要です。両方を指定する（--case LxWxH:LID と --case-top）か、どちら"
     "も省いてください。"},
    {"case.radius", "the corner radius must be 0 to {most} (half of the narrowest side), not {found}",
     "角の半径は 0～{most}（最も狭い辺の半分）にしてください（指定：{found}）。"},
    {"dowel.shorter_than_wide", "the dowel's length is {length} mm, but must be from {least} to 1000 mm",
     "ダボの長さが {length} mm になっています。使える範囲は {least}～1000 mm です。"},
    {"brick.no_size", "no brick is {size}: take sizes of {known,}",
     "{size} のブロックはありません。次の大きさから選んでください：{known,}"},
    {"brick.no_color", "no bricks are known in {color}: take {known,}",
     "{color} という色のブロックはありません。次から選んでください：{known,}"},
    {"sheet.margin",
     "A margin of {margin} mm leaves nothing of a stock sheet of {stock} mm; take larger sheets.",
     "余白が {margin} mm では、{stock} mm の材料に使える所が残りません。より大きなシートにしてください。"},
    {"sheet.kerf",
     "A dowel hole of {dowel} mm cannot be cut with a kerf of {kerf} mm; choose thicker dowels, or 0 dowels.",
     "切り幅 {kerf} mm では {dowel} mm のダボの穴を切れません。太いダボにするか、ダボを 0 本にしてくださ"
     "い。"},
    {"sheet.no_kind", "Choose SVG, DXF or both for the sheets.",
     "シートの形式を SVG、DXF、または両方から選んでください。"},
    {"price.currency", "the currency must be a short word such as EUR, not {found}",
     "通貨は EUR のような短い語にしてください（指定：{found}）。"},
    {"search.no_weight", "give at least one objective a weight above 0",
     "少なくとも一つの目的の重みを 0 より大きくしてください。"},
    {"clean.no_direction", "a cutting plane needs a direction x,y,z that is not 0, and a distance in mm",
     "切断面には、0 でない方向 x,y,z と距離（mm）が必要です。"},
    {"preset.no_list", "they must be a JSON list: {example}",
     "緩衝材の一覧は JSON のリスト {example} で書いてください。"},
    {"preset.unknown", "unknown preset {name}; known are: {known,}",
     "{name} という緩衝材はありません。次から選んでください：{known,}"},
    {"preset.division", "none, across or all", " none、across、all のどれか"},
    {"case.unknown",
     "no case is called {name}; give its inside as LENGTHxWIDTHxHEIGHT in mm, such as 425x284x155, or a name "
     "that `snug cases` lists",
     "{name} という名前のケースはありません。内寸を LENGTHxWIDTHxHEIGHT（長さ、幅、高さ、mm）の 425x284x155 "
     "のような形で指定するか、`snug cases` にある名前を指定してください。"},
    {"cases.column_must_be", "{column} must be {expected}, not {found}",
     "{column} に書けるのは{expected}です（記載：{found}）。"},
    {"cases.short_text", "a short text", "短い文字列"},
    {"cases.number", "a number from {least} to {most}", " {least}～{most} の数値"},
    {"cases.below_height", "less than the height", "高さより小さい数値"},
    {"cases.missing", "{column} is missing", "{column} がありません。"},
    {"cases.unknown_column", "a column is called {name}; known are {known,}",
     "{name} という列はありません。使える列：{known,}"},
    {"cases.no_column", "the first line must name the columns, and {name} is missing",
     "最初の行に列の名前が必要ですが、{name} がありません。"},
    {"cases.quotes", "a quotation mark is not closed, or something follows it",
     "引用符が閉じていないか、その後に余分な文字があります。"},
    {"cases.fields", "there are {fields} fields but {columns} columns",
     "列は {columns} 個ですが、値が {fields} 個あります。"},
    {"cases.more_lines", "and {lines} {lines|more line|more lines}", "ほか {lines} 行"},
    {"cases.other_lines", "{file}, {problem}; the other lines are used",
     "{file}、{problem}（ほかの行は使います）"},
};

}  // namespace

std::span<const Wording> words_of_design() {
    return kWordsOfDesign;
}

}  // namespace snug

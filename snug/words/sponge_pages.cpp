#include "snug/words/catalogue.h"

// Plan and maps of slit sponge.

namespace snug {
namespace {

constexpr Wording kWordsOfSpongePages[] = {
    {"sponge.title", "{name}: plan", "{name}：作業計画"},
    {"sponge.maps_title", "{name}: maps at true size", "{name}：原寸の図"},
    {"sponge.subtitle_tray",
     "Slit sponge · tray of {size} mm (x, y, z) · blocks of {block} mm · {blocks} {blocks|block|blocks} to "
     "pluck",
     "スリットスポンジ · トレイ {size} mm（x, y, z） · ブロック {block} mm · 抜く数 {blocks}"},
    {"sponge.subtitle",
     "Slit sponge · {size} mm closed (x, y, z) · blocks of {block} mm · {blocks} "
     "{blocks|block|blocks} to pluck",
     "スリットスポンジ · 閉じて {size} mm（x, y, z） · ブロック {block} mm · 抜く数 {blocks}"},
    {"sponge.stock",
     "{layers} {layers|layer|layers} of {width} x {depth} mm, each {mm} mm thick; {blocks} "
     "{blocks|block|blocks} to pluck",
     "{width} x {depth} mm、厚さ {mm} mm を {layers} 層。抜くブロック {blocks} 個"},
    {"sponge.no_stock", "no foam on this side; {blocks} {blocks|block|blocks} to pluck",
     "こちら側に緩衝材はありません。抜くブロック {blocks} 個"},
    {"sponge.from_cavity", "from the cavity", "くぼみ側から"},
    {"sponge.from_above", "from above", "上から"},
    {"sponge.in_each", "pluck in each", "1 層で抜く数"},
    {"sponge.together", "together", "合計"},
    {"sponge.nothing", "nothing", "なし"},
    {"sponge.leave_whole", "nothing: leave whole", "なし：そのまま使う"},
    {"sponge.layer", "layer {layer}", "{layer} 層目"},
    {"sponge.layers", "layers {first} to {last}", "{first}～{last} 層目"},
    {"sponge.layer_of", "layer {layer} of {layers}", "{layers} 層中 {layer} 層目"},
    {"sponge.layers_of", "layers {first} to {last} of {layers}", "{layers} 層中 {first}～{last} 層目"},
    {"sponge.blocks", "{blocks} {blocks|block|blocks}", "{blocks} 個"},
    {"sponge.high_layer",
     "{half}: layer 1 keeps less than half of its blocks, {blocks} {blocks|block|blocks}. Instead of "
     "plucking it, glue as many spare blocks on layer 2 where the map is white: that saves work and "
     "1 layer of foam.",
     "{half}：1 層目に残るブロックは半分未満（{blocks} 個）です。抜く代わりに、余ったブロックを同じ数"
     "だけ、図の白い所に合わせて 2 層目に接着すれば、手間と緩衝材 1 層を省けます。"},
    {"sponge.high_layers",
     "{half}: layers 1 to {last} keep less than half of their blocks, {blocks} {blocks|block|blocks}"
     " together. Instead of plucking them, glue as many spare blocks on layer {next} where the map "
     "is white: that saves work and {layers} layers of foam.",
     "{half}：1～{last} 層目に残るブロックは半分未満（合わせて {blocks} 個）です。抜く代わりに、余っ"
     "たブロックを同じ数だけ、図の白い所に合わせて {next} 層目に接着すれば、手間と緩衝材 {layers} "
     "層を省けます。"},
    {"sponge.try_fit",
     "Fit test first: print the map \"fit test\", make that ring from one layer, and pass the "
     "object's outline through it by hand. If it does not fit, go back to the design, before a whole "
     "block is spent.",
     "まず試験片ではめ合わせを確かめます。「試験片」の図を印刷し、1 層分の緩衝材でその枠を作って、"
     "対象物の輪郭を手で通します。通らないときは、緩衝材を丸ごと使う前に設計に戻ります。"},
    {"sponge.print_maps",
     "Print the maps at 100 %, check the square on the first page with a ruler, and join the tiles.",
     "図を 100 % で印刷し、最初のページの正方形を定規で確かめてから、紙をつなぎます。"},
    {"sponge.cut_layers",
     "Cut the layers to size. Write {marks/} and its number on each, and BACK on its back edge. "
     "Layer 1 is the one at the cavity.",
     "層を寸法どおりに切ります。それぞれに、どの緩衝材の層か（{marks/}）と層の番号を書き、奥の縁に "
     "BACK と書きます。1 層目はくぼみ側の層です。"},
    {"sponge.middle",
     "A MIDDLE piece has a cavity on each side; its layer 1 is the uppermost, and all its maps show it from "
     "above.",
     "MIDDLE の緩衝材は両面にくぼみがあります。1 層目は一番上の層で、図はすべて上から見たものです。"},
    {"sponge.trim",
     "Cut off each layer what its map shows in grey: the case has no room for it there. Some layers "
     "have a map for this alone.",
     "各層から、図の灰色の所を切り落とします。ケースに入らない所です。そのためだけの図がある層も"
     "あります。"},
    {"sponge.pluck",
     "Lay the map of a layer on it, cavity side up, BACK on BACK, the black corner on column A1. "
     "Pluck the shaded blocks. Keep them: they mend a mistake.",
     "層のくぼみ側を上にして、その層の図を重ねます。BACK どうしを合わせ、黒い角を A1 に合わせます。色"
     "のついたブロックを抜きます。間違えたときに戻せるよう、抜いたブロックは取っておきます。"},
    {"sponge.stack",
     "Stack each piece from its last layer up to layer 1, the BACK edges in one line, and check the "
     "depths against the overview. Then glue the layers, with an adhesive that the object's keeper "
     "allows.",
     "緩衝材ごとに、最後の層から 1 層目まで、BACK の縁をそろえて重ね、深さを全体図で確かめます"
     "。それから、対象物の管理者が認めた接着剤で層を接着します。"},
    {"sponge.close_layers",
     "Stand the empty pieces on each other once, from LOWER up to the LID, BACK over BACK: the black corners "
     "meet and the rims touch all round.",
     "空のまま一度、BACK をそろえて下から順に重ね、最後にふたをします。黒い角が重なり、縁が全周で触れれば"
     "合っています。"},
    {"sponge.close",
     "Close the empty halves once, lid over lower foam, BACK over BACK: the black corners meet and "
     "the rims touch all round.",
     "空のまま一度、BACK どうしを合わせて、下の緩衝材にふたをかぶせます。黒い角が重なり、縁が全周で"
     "触れれば合っています。"},
    {"sponge.test_leaves_out",
     "The fit test leaves out {islands} {islands|island|islands} of foam and its ring is in {pieces} "
     "{pieces|piece|pieces}.",
     "試験片では島になった緩衝材 {islands} 個を省いてあり、枠は {pieces} 個です。"},
    {"sponge.depths", "{half}: depths", "{half}：深さ"},
    {"sponge.how_to_read",
     "{name} · rows, then columns: blocks to remove from the cavity's side; columns that are not "
     "named stay whole",
     "{name} · 左に行、右に「列：くぼみ側から抜くブロックの数」。書かれていない列はそのままにします"},
    {"sponge.map", "{name}: {half}, {layers}", "{name}：{half}、{layers}"},
    {"sponge.overview", "{name}: {half}, overview", "{name}：{half}、全体図"},
    {"sponge.pluck_none", "Nothing to pluck.", "抜くブロックはありません。"},
    {"sponge.pluck_shaded", "Pluck {blocks} {blocks|block|blocks}: the shaded ones.",
     "色のついた {blocks} 個のブロックを抜きます。"},
    {"sponge.pluck_in_each", "Pluck {blocks} {blocks|block|blocks} in each: the shaded ones.",
     "どの層からも、色のついた {blocks} 個のブロックを抜きます。"},
    {"sponge.cut_off",
     " Cut off {blocks} {blocks|block|blocks}: the grey ones, for which the case has no room.",
     "灰色の {blocks} 個はケースに入らないので切り落とします。"},
    {"sponge.cut_off_in_each",
     " Cut off {blocks} {blocks|block|blocks} in each: the grey ones, for which the case has no room.",
     "どの層も、灰色の {blocks} 個はケースに入らないので切り落とします。"},
    {"sponge.map_task",
     "{pluck}{cut_off} Cavity facing you; layer 1 is the one at the cavity. True size. {name}",
     "{pluck}{cut_off}くぼみ側から見た図で、1 層目がくぼみ側です。原寸。{name}"},
    {"sponge.fit_test", "FIT TEST", "試験片"},
    {"sponge.fit_test_of", "FIT TEST, layer {layer}", "試験片（{layer} 段目）"},
    {"sponge.ring", "ring of one layer", "1 層分の枠"},
    {"sponge.ring_task",
     "Keep the shaded ring, pluck what is inside, cut off what is outside. Lies as the lower foam, "
     "cavity facing you. True size. {name}",
     "色のついた枠を残し、内側を抜き、外側を切り落とします。下の緩衝材をくぼみ側から見た向きです。"
     "原寸。{name}"},
    {"sponge.read_numbers",
     "Cavity facing you. The number says how many blocks to remove from this column, from the "
     "cavity's side; white columns stay whole. Not at true size.",
     "くぼみ側から見た図です。数字は、その列のくぼみ側からブロックをいくつ抜くかを示します。白い列は"
     "そのままにします。原寸ではありません。"},
    {"sponge.read_shades",
     "Cavity facing you. The shade says how many blocks to remove from a column, the table how many "
     "from which, from the cavity's side; white columns stay whole. Not at true size.",
     "くぼみ側から見た図です。色の濃さは、列のくぼみ側からブロックをいくつ抜くかを示します。どの列か"
     "らいくつ抜くかは表にあります。白い列はそのままにします。原寸ではありません。"},
    {"sponge.scale", "Blocks to remove", "抜くブロックの数"},
    {"sponge.to_remove", "{blocks} blocks to remove", "抜くブロック {blocks} 個"},
    {"sponge.from_layers", "from {layers} layers of {mm} mm", "厚さ {mm} mm の {layers} 層から"},
};

}  // namespace

std::span<const Wording> words_of_sponge_pages() {
    return kWordsOfSpongePages;
}

}  // namespace snug

#include "snug/words/catalogue.h"

// The set-up sheet for milling; the programs themselves speak English alone.

namespace snug {
namespace {

constexpr Wording kWordsOfMillPages[] = {
    {"mill.title", "{name}: milling", "{name}：切削"},
    {"mill.heading", "Milling", "切削"},
    {"mill.subtitle", "{name} · set-up sheet", "{name} · 段取り書"},
    {"mill.cutter", "Cutter", "刃"},
    {"mill.cutter_of", "flat, {cutter_mm} mm, flute {flute_mm} mm",
     "フラットエンドミル、直径 {cutter_mm} mm、刃長 {flute_mm} mm"},
    {"mill.feeds", "Feeds", "送り"},
    {"mill.feeds_of", "{feed} mm/min, down {plunge} mm/min, {rpm} rpm: starting values, try them on waste",
     "{feed} mm/分、下降 {plunge} mm/分、{rpm} 回転/分。目安なので端材で試すこと"},
    {"mill.pass", "One pass", "1 段"},
    {"mill.pass_of",
     "{step_mm} mm down, lines {apart_mm} mm apart, {safe_mm} mm above the stock between them",
     "深さ {step_mm} mm、線の間隔 {apart_mm} mm、移動は材料の上 {safe_mm} mm"},
    {"mill.cut_stock", "Cut each stock to its size. Write {marks/} and BACK on it.",
     "材料をそれぞれの寸法に切り、どの緩衝材か（{marks/}）と BACK（奥）を書きます。"},
    {"mill.fix_stock",
     "Fix it on the machine, the cavity's side up and BACK as drawn: double-sided tape or a vacuum, "
     "for screws tear foam. Keep {mm} mm free around it: strips at an edge are cleared from beside "
     "it.",
     "くぼみの側を上に、BACK を図の向きにして、機械に固定します。ねじは緩衝材を裂くので、両面テープ"
     "か真空で留めます。縁の細い所は外側から削るため、まわりを {mm} mm あけておきます。"},
    {"mill.set_zero",
     "Set X0 Y0 where it is drawn, Z0 on the top of the stock. Run the program once with Z0 {mm} mm "
     "higher, in the air.",
     "X0 Y0 を図の位置に、Z0 を材料の上面に合わせます。まず Z0 を {mm} mm 高くして、プログラムを一度"
     "空中で動かします。"},
    {"mill.pins",
     "Both cavity programs begin with two holes for pins of {mm} mm. The halves meet on them one way "
     "only: where they do not, one of them lay turned.",
     "くぼみのプログラムはどちらも、直径 {mm} mm のピンの穴を 2 つ開けてから始まります。下とふたは、"
     "正しい向きでだけピンで合います。合わなければ、どちらかを逆向きに置いて削っています。"},
    {"mill.pins_layers",
     "All sides on which pieces meet get two holes for pins of {mm} mm first. The pieces meet on them one "
     "way "
     "only: where they do not, one of them lay turned.",
     "緩衝材同士が合わさる面には、まず直径 {mm} mm のピンの穴を 2 つずつ開けます。正しい向きでだけピンで"
     "合います。合わなければ、どれかを逆向きに置いて削っています。"},
    {"mill.engrave",
     "Labels ({programs}): when the cavity is milled, leave the stock as it lies, change to a pointed cutter "
     "or one "
     "of 1 mm, keep X0 Y0, set Z0 on the top again, and run the label program: it goes at most {mm} mm deep.",
     "名前（{programs}）：くぼみを削り終えたら、材料はそのままに、先のとがった刃か 1 mm の刃に替えます。X0 "
     "Y0 は"
     "そのままに、Z0 を上面に合わせ直して、名前のプログラムを動かします。深さは {mm} mm 以内です。"},
    {"mill.programs", "{names&}", "{names&}"},
    {"mill.turn",
     "Outer sides ({programs}): after a half's cavity is milled, turn it over about the line from "
     "left to right, so that its near edge comes to lie far and its cavity down, line it up by its "
     "edges, set Z0 on its top again, and run its outside program.",
     "外側（{programs}）：くぼみを削り終えたら、左右の線を軸に裏返し、手前の縁を向こう側に、くぼみを"
     "下にします。縁で位置を合わせ、Z0 を上面に合わせ直して、外側のプログラムを動かします。"},
    {"mill.turn_on_pins",
     "Outer sides ({programs}): after a half's cavity is milled, run its board program ({board}) in "
     "the board and put pins in. Take the half, turn it over about the line from left to right, so "
     "that its near edge comes to lie far and its cavity down on the pins, keep X0 Y0, set Z0 on its "
     "top, and run its outside program. Each half has its own holes in the board.",
     "外側（{programs}）：くぼみを削り終えたら、捨て板用のプログラム（{board}）で板に穴を開け、ピンを"
     "差します。削った緩衝材を左右の線を軸に裏返し、手前の縁を向こう側に、くぼみを下にしてピンに載"
     "せます。X0 Y0 はそのままに、Z0 を上面に合わせ、外側のプログラムを動かします。板の穴は、下とふた"
     "で別々です。"},
    {"mill.close",
     "Close the empty halves once, BACK over BACK, and try the object's outline before it goes in.",
     "空のまま一度、BACK どうしを合わせて閉じます。対象物を納める前に、輪郭がくぼみに合うか確かめます"
     "。"},
    {"mill.close_layers",
     "Stand the empty pieces on each other once, BACK over BACK, and try each layer's outlines before "
     "anything "
     "goes in.",
     "空のまま一度、BACK どうしを合わせて重ねます。収める前に、段ごとに輪郭がくぼみに合うか確かめます。"},
    {"mill.under", "{half}, underside", "{half}、下面"},
    {"mill.outer", "{half}, outer side", "{half}、外側"},
    {"mill.from_above", "{name} · {file} · from above, as you stand before it",
     "{name} · {file} · 機械の前に立って上から見た図"},
    {"mill.lies", "Lies", "置き方"},
    {"mill.lies_so", "{side}, BACK {back}", "{side}、BACK は{back}"},
    {"mill.cavity_up", "cavity up", "くぼみが上"},
    {"mill.outer_up", "outer side up, cavity down", "外側が上、くぼみが下"},
    {"mill.under_up", "underside up, upper cavity down", "下面が上、上側のくぼみが下"},
    {"mill.away", "away from you", "向こう側"},
    {"mill.towards", "towards you", "手前"},
    {"mill.stock", "Stock", "材料"},
    {"mill.stock_of", "{size} mm (right, away from you, up)", "{size} mm（右へ、向こうへ、上へ）"},
    {"mill.deepest", "Deepest", "最も深い所"},
    {"mill.deepest_of", "{mm} mm; the darker, the deeper", "{mm} mm（色が濃いほど深い）"},
    {"mill.passes_of", "{passes}, {way} m, about {minutes} minutes", "{passes} 段、{way} m、約 {minutes} 分"},
    {"mill.pin", "Pin", "ピン"},
    {"mill.pin_at", "at {x}, {y} mm from the near left corner, {deep} mm deep",
     "左手前の角から {x}, {y} mm、深さ {deep} mm"},
};

}  // namespace

std::span<const Wording> words_of_mill_pages() {
    return kWordsOfMillPages;
}

}  // namespace snug

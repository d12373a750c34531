#include "snug/words/catalogue.h"

// What is gathered and built of bricks.

namespace snug {
namespace {

constexpr Wording kWordsOfBricksPages[] = {
    {"bricks.title", "{name}: bricks", "{name}：ブロック"},
    {"bricks.heading", "Bricks", "ブロック"},
    {"bricks.subtitle", "{name} · what to gather, and how to build it", "{name} · 集める部品と組み立て方"},
    {"bricks.pieces", "Pieces", "部品"},
    {"bricks.column_pieces", "pieces", "個数"},
    {"bricks.column_part", "part", "部品番号"},
    {"bricks.column_name", "name", "名前"},
    {"bricks.column_colour", "colour", "色"},
    {"bricks.named_brick", "Brick {size}", "ブロック {size}"},
    {"bricks.named_plate", "Plate {size}", "プレート {size}"},
    {"bricks.named_tile", "Tile {size}", "タイル {size}"},
    {"bricks.sort",
     "Sort the pieces by size. bricks/wanted.xml is the same list for a shop that takes BrickLink's.",
     "部品を大きさごとに分けます。bricks/wanted.xml は同じ一覧で、BrickLink の形式を受け付ける店で使"
     "えます。"},
    {"bricks.build",
     "Build each half on a flat table, course by course, its cavity facing you; bricks/foams.mpd "
     "shows the same steps in every LDraw viewer.",
     "下とふたをそれぞれ、平らな台の上で、くぼみを上にして一段ずつ組みます。bricks/foams.mpd を"
     " LDraw の閲覧ソフトで開くと、同じ手順を見られます。"},
    {"bricks.press",
     "Press each course down before the next: joints of neighbouring courses cross, and every piece "
     "stands on those before it.",
     "次の段に進む前に、段全体を押し込みます。上下の段の継ぎ目は互い違いになり、どの部品も前の段の上"
     "に載ります。"},
    {"bricks.studs",
     "Studs stand 1.8 mm into the cavity; the design has left room for them. Line the cavity where "
     "the object must not touch hard plastic.",
     "ポッチはくぼみに 1.8 mm 出ますが、設計ではその分をあけてあります。対象物を硬い樹脂に触れさせた"
     "くない所には、内張りをします。"},
    {"bricks.lid_gap",
     "The rims meet stud on stud, so the lid stands {mm} mm off. Build the rims with tiles where it "
     "must close.",
     "縁はポッチどうしが当たるため、ふたが {mm} mm 浮きます。すきまなく閉じたいときは、縁をタイルで組"
     "みます。"},
    {"bricks.close", "Close the empty halves once, BACK over BACK: the black corners meet.",
     "空のまま一度、BACK どうしを合わせて閉じます。黒い角が重なれば合っています。"},
    {"bricks.steps", "{half}: step by step", "{half}：組み立て手順"},
    {"bricks.how_to_read", "{name} · from above, cavity facing you; what is put on, above what stands",
     "{name} · 上から、くぼみ側から見た図。すでにある部品（灰色）の上に、色つきの部品を載せます"},
    {"bricks.step_bricks", "Step {step} of {steps}: bricks", "手順 {step}／{steps}：ブロック"},
    {"bricks.step_plates", "Step {step} of {steps}: plates", "手順 {step}／{steps}：プレート"},
    {"bricks.step_tiles", "Step {step} of {steps}: tiles", "手順 {step}／{steps}：タイル"},
    {"bricks.counts", "{counts,}", "{counts,}"},
    {"bricks.count", "{pieces} of {size}", "{size} を {pieces} 個"},
    {"color.black", "black", "黒"},
    {"color.blue", "blue", "青"},
    {"color.green", "green", "緑"},
    {"color.red", "red", "赤"},
    {"color.yellow", "yellow", "黄"},
    {"color.white", "white", "白"},
    {"color.tan", "tan", "タン"},
    {"color.orange", "orange", "オレンジ"},
    {"color.reddish_brown", "reddish brown", "赤茶"},
    {"color.light_gray", "light bluish gray", "明るい青灰"},
    {"color.dark_gray", "dark bluish gray", "濃い青灰"},
    {"color.dark_blue", "dark blue", "濃紺"},
    {"color.dark_brown", "dark brown", "焦げ茶"},
    {"color.dark_red", "dark red", "濃い赤"},
};

}  // namespace

std::span<const Wording> words_of_bricks_pages() {
    return kWordsOfBricksPages;
}

}  // namespace snug

#include "snug/words/catalogue.h"

// Toy bricks.

namespace snug {
namespace {

constexpr Wording kWordsOfBricks[] = {
    {"bricks.layers",
     "foams of several layers are not built of bricks yet: a middle foam would stand on its studs. Pack the "
     "layers as designs of their own, or take --for {ways/}",
     "複数の段の緩衝材は、まだブロックでは組めません（中間の緩衝材がポッチの上に立つため）。段ごとに別の"
     "設計にするか、--for で {ways/} を選んでください。"},
    {"brick_pieces",
     "the bricks of the {half} hold together in {pieces} pieces: foam that is one layer thick, or islands "
     "of it, cannot be joined by studs. Glue it, take plates (--brick-unit plate) or more walls",
     "{half}のブロックが {pieces} 個に分かれます。一段だけの緩衝材や島はポッチではつながりません。接着す"
     "るか、プレート（--brick-unit plate）を使うか、壁を厚くしてください。"},
    {"lid_gap",
     "the rims meet stud on stud, so the lid stands {mm} mm off and the whole is as much higher; "
     "--brick-rim tiles closes it",
     "合わせ面がポッチ同士で当たるため、ふたが {mm} mm 浮き、全体もその分高くなります。--brick-rim tiles "
     "ですきまがなくなります。"},
    {"rigid/bricks", "bricks hold the object but are no cushion: put foam between them and the outer box",
     "ブロックは対象物を支えますが、緩衝にはなりません。外箱との間に緩衝材を入れてください。"},
    {"many_steps",
     "the steps would fill more pages than anyone prints, so bricks-plan.pdf leaves the later ones out: "
     "build by bricks/foams.mpd",
     "手順のページ数が多すぎるため、bricks-plan.pdf では後半を省きました。bricks/foams.mpd を見て組み立て"
     "てください。"},
    {"bricks_overloaded",
     "the {half} comes apart {load}: its studs would have to hold {percent} of what they can. It gives "
     "first between a {lower} and the {upper} on it, {place}. Make floor and walls thicker, allow longer "
     "bricks, or glue that joint",
     "{half}は{load}に外れます。ポッチにかかる力は保持力の {percent} です。最初に外れるのは{lower}とその上"
     "の{upper}の間（{place}）です。底と壁を厚くするか、長いブロックを使うか、そこを接着してください。"},
    {"bricks_loose",
     "{bricks} {bricks|brick|bricks} of the {half} {bricks|falls|fall} out {load}, tied to nothing that "
     "is held: the first is a {first}, {place}. Glue them, or take a design whose floor and walls are at "
     "least two layers",
     "{half}のブロック {bricks} 個が、支えのある所につながっていないため、{load}に外れます。最初は"
     "{first}（{place}）です。接着するか、底と壁が二段以上の設計にしてください。"},
    {"bricks_fall",
     "the {half} tips over or falls apart {load}, whatever the studs hold: support it by hand, or make "
     "its rim level",
     "{half}は、ポッチの保持力にかかわらず、{load}"
     "に倒れるか崩れます。手で支えるか、縁を平らにしてください。"},
    {"bricks_unchecked",
     "how firmly the {half} holds {load} was not checked, since that takes a solver which is not here: "
     "`snug make --for bricks` on a computer has one",
     "{load}の{half}の強さは、計算に必要なソルバーがここにないため確認していません。コンピューター上の "
     "`snug make --for bricks` で確認できます。"},
    {"bricks_unchecked/too_large",
     "how firmly the {half} holds {load} was not checked: for its {bricks} bricks that would take too "
     "long. Lift it with both hands below",
     "{load}の{half}の強さは、ブロックが {bricks} 個あり時間がかかりすぎるため確認していません。両手で下か"
     "ら持ち上げてください。"},
    {"bricks_unchecked/unsolved",
     "how firmly the {half} holds {load} is not known: the check found no answer",
     "{load}の{half}の強さは、計算で答えが出なかったためわかりません。"},
    {"bricks.standing", "as it stands on the table", "台に置いたとき"},
    {"bricks.lifted", "when it is lifted by its rim", "縁で持ち上げたとき"},
    {"bricks.turned", "when it lies on its rim, cavity down", "縁で伏せたとき"},
    {"bricks.brick", "{size} brick", "{size} のブロック"},
    {"bricks.plate", "{size} plate", "{size} のプレート"},
    {"bricks.tile", "{size} tile", "{size} のタイル"},
    {"bricks.place",
     "{mm} mm above the half's floor, stud {column} from the left in row {row} from the far side",
     "底から {mm} mm の高さ、奥から {row} 列目、左から {column} 番目のポッチ"},
    {"bricks.below_one_percent", "less than 1 %", "1 % 未満"},
    {"bricks.too_many",
     "the {half} would take {studs} studs of bricks, more than anybody builds: choose fewer blocks",
     "{half}にはポッチ {studs} 個分のブロックが必要で、組み立てられる量を超えます。ブロック数を減らしてく"
     "ださい。"},
    {"bricks.too_narrow",
     "the chosen bricks cannot fill the foam: {where} are narrower than the smallest of them. Add 1x1 to "
     "--brick-sizes",
     "選んだブロックでは緩衝材を埋められません。{where}は、最も小さいブロックより幅が狭くなっています。"
     "--brick-sizes に 1x1 を加えてください。"},
    {"bricks.stock_too_small",
     "the bricks in stock do not suffice: {where} stay empty when they are used up. Add to the stock (1x1 "
     "fits everywhere), or leave sizes out of --brick-stock that do not run out",
     "手持ちのブロックが足りません。使い切っても{where}が空のままです。手持ちを増やすか（1x1 はどこにでも"
     "入ります）、足りなくならない大きさを --brick-stock から外してください。"},
    {"bricks.cannot_span",
     "the bricks cannot span what the case leaves without foam below: {where} would hang in the air. "
     "Longer bricks may span it where --brick-sizes leaves some out; otherwise take a case with upright "
     "walls and square corners, or let the bricks fill the largest box that lies in this one (--case with "
     "the sizes at its floor)",
     "下に緩衝材のない所をブロックで渡せません。{where}が宙に浮きます。--brick-sizes で除いた長いブロッ"
     "クを使うか、壁が垂直で角が四角いケースにするか、ケースに入る最大の箱（--case に底の寸法）に合わせて"
     "ください。"},
    {"bricks.no_bricks",
     "no bricks make blocks of {size} mm: along x they must be a multiple of {heights}, along y and z of "
     "8 mm; the nearest that work are {nearest} mm. Choose them with --block-size, or take --preset "
     "lego-brick",
     "{size} mm のブロックを作れるブロック玩具がありません。上下（x）は {heights} の倍数、前後（y）と左右"
     "（z）は 8 mm の倍数が必要です。最も近いのは {nearest} mm です。--block-size で指定するか、--preset "
     "lego-brick を選んでください。"},
    {"bricks.single_studs",
     "bricks of 1x1 alone stand side by side without a hold: add 1x2 or longer to --brick-sizes",
     "1x1 だけでは横につながりません。--brick-sizes に 1x2 以上を加えてください。"},
    {"bricks.high_bricks", "9.6 mm (bricks)", "9.6 mm（ブロック）"},
    {"bricks.high_plates", "3.2 mm (plates)", "3.2 mm（プレート）"},
    {"bricks.high_either", "9.6 mm (bricks) or 3.2 mm (plates)", "9.6 mm（ブロック）か 3.2 mm（プレート）"},
    {"bricks.where", "{studs} {studs|stud|studs} of the {half} at a height of {mm} mm",
     "{half}の高さ {mm} mm のポッチ {studs} 個分"},
};

}  // namespace

std::span<const Wording> words_of_bricks() {
    return kWordsOfBricks;
}

}  // namespace snug

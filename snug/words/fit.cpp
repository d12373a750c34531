#include "snug/words/catalogue.h"

// How the object lies in its foams, and what holds it.

namespace snug {
namespace {

constexpr Wording kWordsOfFit[] = {
    {"outside",
     "the object needs {needed} mm{clearance} and leaves the design space of {space} mm ({space_blocks} "
     "blocks). The smallest that would do here is {least_blocks} blocks ({least} mm) without any wall; "
     "--blocks auto adds walls",
     "対象物には{clearance}{needed} mm が必要で、設計空間 {space} mm（{space_blocks} ブロック）に収まりま"
     "せん。壁なしでも最小で {least_blocks} ブロック（{least} mm）が必要です。--blocks auto で壁を含めて決"
     "められます。"},
    {"outside/items",
     "it leaves the design space of {space} mm ({space_blocks} blocks): all items together take {needed} "
     "mm{clearance} as they lie, and the smallest that would do here is {least_blocks} blocks ({least} mm) "
     "without any wall. --blocks auto adds walls, or place the items yourself ({example})",
     "設計空間 {space} mm（{space_blocks} ブロック）に収まりません。このままの並びでは全部で{clearance}"
     "{needed} mm になり、壁なしでも最小で {least_blocks} ブロック（{least} mm）が必要です。--blocks auto で"
     "壁を含めて決めるか、自分で置いてください（{example}）。"},
    {"outside/items_in_case",
     "it leaves the foam of the case, which is {foam} mm: all items together take {needed} mm{clearance} as "
     "they lie. A case would do from {least} mm inside, or place the items yourself ({example})",
     "ケースの中の緩衝材 {foam} mm に収まりません。このままの並びでは全部で{clearance}{needed} mm になりま"
     "す。内寸 {least} mm 以上のケースにするか、自分で置いてください（{example}）。"},
    {"items_overlap",
     "{one} and {other} share a pocket, and the boxes around them overlap by {size} mm: look in the preview "
     "whether they run into each other",
     "{one} と {other} は同じくぼみに入り、外接する箱が {size} mm 重なっています。互いにぶつからないか、図で"
     "確かめてください。"},
    {"no_label",
     "no flat foam beside {name} is large enough for its name: its number stands in the packing sheet",
     "{name} の脇に、名前を書けるだけの平らな緩衝材がありません。番号は梱包指示書にあります。"},
    {"label_letters",
     "the letters that a cutter engraves lack some of {name}: its number {number} stands in their place",
     "{name} には刻めない文字があります。代わりに番号 {number} を刻みます。"},
    {"label_cut",
     "the label \"{label}\" would lie across a joint of printed parts, and is left out: write it by hand, or "
     "take a "
     "larger bed",
     "ラベル「{label}」は 3D "
     "プリントの部品の継ぎ目にかかるため、省きます。手で書くか、造形範囲の大きいプリンター"
     "を使ってください。"},
    {"no_pocket",
     "it lies on the tray without a pocket, since no block of foam is as thin as it is sunk: sink it deeper "
     "({option}), or take thinner blocks",
     "沈める深さがブロック一つに満たず、くぼみができません。もっと深く沈めるか（{option}"
     "）、薄いブロックを使って"
     "ください。"},
    {"sunk_less",
     "sunk {mm} mm only, and {wanted_mm} mm were asked for: the foam is too low, or its level was chosen "
     "(--parting)",
     "{mm} mm しか沈みません（指定は {wanted_mm} "
     "mm）。緩衝材の高さが足りないか、上面の高さが指定されています"
     "（--parting）。"},
    {"notches_shallow",
     "finger notches {depth_mm} mm deep are shallower than the {wanted_mm} mm that a finger wants: choose "
     "deeper ones",
     "指かけの深さ {depth_mm} mm は、指に要る {wanted_mm} mm より浅いため、もっと深くしてください。"},
    {"outside/tray",
     "the items do not fit: above {floor_mm} mm of foam they reach {height_mm} mm, and the case is "
     "{inside_mm} mm high "
     "where its foam begins; choose a thinner floor (--wall) or a higher case",
     "入りきりません。厚さ {floor_mm} mm の緩衝材の上に {height_mm} mm "
     "の高さが要りますが、ケースの高さは緩衝材の"
     "下面から {inside_mm} mm です。底を薄くするか（--wall）、もっと高いケースにしてください。"},
    {"tips_out",
     "rolls out over the rim of its pocket when the tray is tilted by {degrees} degrees: sink it deeper "
     "({option}), or carry the tray level",
     "トレイを {degrees} "
     "度傾けると、くぼみの縁を越えて転がり出ます。もっと深く沈めるか（{option}）、トレイを水平"
     "に運んでください。"},
    {"heavy_above", "{one} ({kg} kg) lies above {other} ({lighter_kg} kg): heavy items belong below",
     "{one}（{kg} kg）が {other}（{lighter_kg} kg）の上にあります。重いものは下の段に置いてください。"},
    {"mixed_up",
     "{one} and {other} are so alike in size that either may be laid into the other's pocket: mark both, or "
     "turn "
     "one",
     "{one} と {other} は大きさがほぼ同じで、互いのくぼみに入ってしまうおそれがあります。両方に印を付けるか、"
     "一方の向きを変えてください。"},
    {"items_near",
     "between {one} and {other} stand only {distance} mm of foam, and {between} mm are wanted: shift one of "
     "them by {shift} mm along y or z, give both one group if they may share a pocket, or ask for less "
     "(--between)",
     "{one} と {other} の間の緩衝材が {distance} mm しかありません（必要なのは {between} mm）。どちらかを "
     "y または z 方向に {shift} mm 動かすか、同じくぼみに入れてよければ同じグループにするか、--between を"
     "小さくしてください。"},
    {"items_near/meet",
     "{one} and {other} lie in the same columns ({distance} mm apart, and {between} mm of foam are wanted): "
     "shift one of them by {shift} mm along y or z, or give both one group if they may share a pocket and do "
     "not run into each other",
     "{one} と {other} が同じ列にあります（間は {distance} mm、必要な緩衝材は {between} mm）。どちらかを y "
     "または z 方向に {shift} mm 動かすか、ぶつからず同じくぼみに入れてよければ同じグループにしてください。"},
    {"items_near/layers",
     "between {one} and {other} in a layer above it stand only {distance} mm of foam, and {between} mm are "
     "wanted: move {other} {shift} mm up, shift one of them aside, or ask for less (--between)",
     "{one} と上の段の {other} の間の緩衝材が {distance} mm しかありません（必要なのは {between} mm）。"
     "{other} を {shift} mm 上げるか、どちらかを横に動かすか、--between を小さくしてください。"},
    {"object_same_name",
     "another object is called {name}, too, and is a different file: a project finds one alone beside it, so "
     "rename one of them before you rely on the project",
     "{name} という名前の別のファイルもあります。プロジェクトから作り直すときに区別できないため、どちらかの"
     "名前を変えてください。"},
    {"items.empty_layer",
     "nothing lies in layer {layer} of {layers}: give its items {example}, or number the layers above it "
     "one lower",
     "全 {layers} 段のうち {layer} 段目に何もありません。そこに置くものに {example} を付けるか、"
     "その上の段の番号を一つずつ下げてください。"},
    {"items.no_object", "there is an item of object {number}, but only {objects} of them, counted from 0",
     "対象物 {number} のものがありますが、対象物は {objects} 個しかありません（0 から数えます）。"},
    {"search.tray", "a search looks for foams that close, and this is a tray: place its items yourself",
     "探索は閉じる緩衝材を対象とします。トレイでは、置き方を自分で決めてください。"},
    {"search.objective_alone",
     "{option} says what a search or an arrangement looks for, and none is asked for: add {search} or "
     "{arrange}",
     "{option} は探索や配置の目標です。{search} か {arrange} を加えてください"},
    {"search.one_item",
     "a search takes one object, and here lie {items}: have them arranged (--arrange), or place them "
     "yourself "
     "({example})",
     "探索できる対象物は一つだけですが、ここには {items} 個あります。--arrange "
     "で並べるか、自分で置いてください"
     "（{example}）。"},
    {"with_clearance", " with its clearance", "クリアランスを含めて "},
    {"open",
     "the object is open, and foam would grow inside it: {blocks} {blocks|block|blocks} ({cm3} cm3) in "
     "{columns} {columns|column|columns}; close the holes with --cap, or repair the scan",
     "対象物に穴が開いていて、内側に緩衝材が残ります：{columns} 列に {blocks} ブロック（{cm3} cm3）。"
     "--cap で穴をふさぐか、スキャンを修復してください。"},
    {"uncut_part",
     "a part of the object ({size} mm) cuts no block, so foam would press on it: choose a larger "
     "clearance or smaller blocks, or move the object",
     "ブロックが一つも切り抜かれない部品（{size} mm）があり、緩衝材に押されます。クリアランスを大きくするか、"
     "ブロックを小さくするか、対象物を動かしてください。"},
    {"parts_not_checked",
     "whether {parts} {parts|part|parts} of the object, flush with the blocks, cut a block each was not "
     "checked: they are too many for so fine blocks. Look at them in the preview, or move the object by a "
     "part of a block",
     "ブロックの面にそろった {parts} 個の部品が切り抜かれるかどうかは、細かいブロックに対して数が多すぎる"
     "ため確認していません。プレビューで確かめるか、対象物をブロックの一部だけ動かしてください。"},
    {"no_lower", "the lower foam is empty: choose another parting level or {instead}",
     "下の緩衝材がありません。分割の高さを変えるか、{instead}。"},
    {"no_upper", "the upper foam is empty: choose another parting level or {instead}",
     "ふたがありません。分割の高さを変えるか、{instead}。"},
    {"no_lift",
     "no room at the edges of the {foam} for slots to lift it by: choose smaller ones or thicker walls, or "
     "lay two "
     "ribbons under it, their ends outside",
     "{foam}の縁に持ち上げ口を設ける場所がありません。小さくするか壁を厚くしてください。または、下にリボンを "
     "2 本、"
     "端を外に出して渡してください。"},
    {"no_middle",
     "middle foam {number} is empty: move the layers around it farther apart, or choose {instead}",
     "中間の緩衝材 {number} がありません。上下の段を離すか、{instead}。"},
    {"middle_pieces",
     "middle foam {number} falls into {pieces} pieces: move the layers around it farther apart, or {instead}",
     "中間の緩衝材 {number} が {pieces} 個に分かれます。上下の段を離すか、{instead}。"},
    {"lower_pieces", "the lower foam falls into {pieces} pieces: glue them to the case, or {instead}",
     "下の緩衝材が {pieces} 個に分かれます。ケースに接着するか、{instead}。"},
    {"upper_pieces", "the upper foam falls into {pieces} pieces: glue them to the case, or {instead}",
     "ふたが {pieces} 個に分かれます。ケースに接着するか、{instead}。"},
    {"pieces.higher_case", "a higher case", "もっと高いケースにしてください"},
    {"pieces.take_higher_case", "take a higher case", "もっと高いケースにしてください"},
    {"pieces.more_blocks", "more blocks", "ブロックを増やしてください"},
    {"pieces.more_blocks_up", "use more blocks along x", "上下（x）のブロックを増やしてください"},
    {"parts", "the object has {parts} separate parts ({sizes;} mm)",
     "対象物は離れた {parts} 個の部品からなります（{sizes;} mm）。"},
    {"specks",
     "the object has {parts} separate parts ({sizes;} mm), {specks} "
     "{specks|of them a speck|of them specks} away from the rest: clean the scan if they are dirt, they "
     "cut foam too",
     "対象物は離れた {parts} 個の部品からなり（{sizes;} mm）、そのうち {specks} 個は他から離れた小さなもの"
     "です。ごみであればスキャンから取り除いてください。緩衝材も切り取られます。"},
    {"no_bearing",
     "the {foam} does not hold the object: it would sink more than 5 mm before it lies on foam; choose a "
     "smaller clearance or smaller blocks, or fill what blocks leave: {fills/}",
     "{foam}が対象物を支えません。緩衝材に載るまでに 5 mm "
     "より深く沈みます。クリアランスかブロックを小さくするか、"
     "ブロックの残すすきまを埋めてください（{fills/}）。"},
    {"no_bearing/pads",
     "the {foam} by itself does not hold the object, which would sink more than 5 mm before it lies on foam: "
     "its "
     "pads are to, and what they carry is not counted here",
     "{foam}だけでは対象物を支えません（緩衝材に載るまでに 5 mm "
     "より深く沈みます）。支えるのは詰め板で、その面"
     "積はここでは数えていません。"},
    {"creep",
     "the object presses on the {foam} with {kpa} kPa, more than the {creep_kpa} kPa that it bears for "
     "long: turn the object so that it lies on a larger area, or take a firmer foam",
     "{foam}にかかる対象物の圧力は {kpa} kPa で、長く耐えられる {creep_kpa} kPa を超えます。広い面で載るよ"
     "うに対象物を回すか、硬めの緩衝材を選んでください。"},
    {"foam.lower", "lower foam", "下の緩衝材"},
    {"foam.upper", "upper foam", "ふた"},
    {"foam.middle", "middle foam {number}", "中間の緩衝材 {number}"},
    {"foam.lid", "lid", "ふた"},
    {"foam.lower_half", "lower half", "下の緩衝材"},
    {"no_relief/items", "no relief: items that may reach one another are not looked at on islands",
     "くり抜きはしません。互いに影響する複数のものは、島の上では計算できません。"},
    {"no_relief/foam",
     "no relief: slit sponge, cubes and what is printed, cast or built do not stand on islands; sheets or a "
     "milled block "
     "of polyethylene would",
     "くり抜きはしません。スリットスポンジ、キューブ、印刷や注型、ブロックの玩具では島が立ちません。ポリエチ"
     "レンの板か"
     "切削した塊なら可能です。"},
    {"no_relief/slender",
     "no relief: islands of {island_mm} mm would buckle where they stand {height_mm} mm free: take "
     "{least_mm} mm or more",
     "くり抜きはしません。{height_mm} mm の高さに対して {island_mm} mm の島では座屈します。{least_mm} mm "
     "以上にしてください。"},
    {"no_relief/nothing", "no relief: no foam below the object carries it",
     "くり抜きはしません。対象物を支える緩衝材が下にありません。"},
    {"no_relief/thin",
     "no relief: the {foam_mm} mm of foam below the object are too few blocks high for islands that stand "
     "nearly through them",
     "くり抜きはしません。下の緩衝材 {foam_mm} mm のブロック数が少なく、ほぼ貫く高さの島を作れません。"},
    {"no_relief/depth",
     "no relief: islands must stand nearly through the {foam_mm} mm of foam below the object, and "
     "{height_mm} mm is not "
     "that: take {least_mm} to {most_mm} mm",
     "くり抜きはしません。島は、下の緩衝材 {foam_mm} mm をほぼ貫く高さにします（{height_mm} mm ではなく "
     "{least_mm} から "
     "{most_mm} mm）。"},
    {"no_relief/room",
     "no relief: there is no room for three islands of {island_mm} mm under the object with the centre of "
     "its mass "
     "between them",
     "くり抜きはしません。重心を囲む {island_mm} mm の島を三つ置く場所が、対象物の下にありません。"},
    {"relief",
     "the object stands on {islands} islands of {size} mm that stand {height_mm} mm free; foam beneath them "
     "spreads its "
     "load, and the range on its floor takes in both that it gives way and that it does not",
     "対象物は {size} mm、周りが {height_mm} mm 空いた {islands} "
     "か所の島に載ります。島の下の緩衝材がたわむ場合とたわまない"
     "場合の両方を、底への落下の幅に含めています。"},
    {"relief_bottoms",
     "its islands may bottom with a fifth more mass from a quarter higher: wider ones, or none, would do",
     "質量が 2 割、高さが 2 割 5 "
     "分大きいと、島が底つきするおそれがあります。島を広げるか、くり抜きをやめてください。"},
    {"relief_creep",
     "its islands carry {kpa} kPa at rest, more than half of what the foam bears for long ({most_kpa}): "
     "wider ones "
     "would do",
     "島には静置時に {kpa} kPa "
     "がかかり、緩衝材が長く耐える圧力の半分（{most_kpa}）を超えます。島を広げてください。"},
    {"relief_creep_unknown",
     "what its foam bears for long is not known, so that nothing says whether its islands sag in a long "
     "store",
     "緩衝材が長く耐える圧力が分からないため、長く置いたときに島が沈むかどうかは分かりません。"},
    {"relief_offer",
     "less foam under it would do on its floor: {flag} lets it stand on {islands} islands, about {range}, "
     "where "
     "you asked for {asked}",
     "下の緩衝材を減らすと、底への落下の衝撃が足りる値になります。{flag} とすれば {islands} "
     "か所の島に載り、およそ {range} です（希望 {asked}）。"},
    {"relief_offer/over",
     "less foam under it would help on its floor, and still not be shown to be enough: {flag} lets it stand "
     "on "
     "{islands} islands, about {range}, where you asked for {asked}",
     "下の緩衝材を減らすと、底への落下の衝撃は下がりますが、まだ足りません。{flag} とすれば {islands} "
     "か所の島に載り、およそ {range} です（希望 {asked}）。"},
    {"settled_none", "nothing was lowered: foam below, a lock or its group holds each thing where it is",
     "下の緩衝材、固定、またはグループのため、何も下げませんでした"},
    {"pads",
     "{pads} {pads|pad fills|pads fill} what block steps leave around what is packed: the packing sheet "
     "shows where they "
     "lie. No adhesive near the object",
     "ブロックの段が残すすきまを {pads} "
     "枚の詰め板で埋めます。場所は梱包指示書にあります。対象物の近くに接着剤を"
     "使わないでください。"},
    {"pads_left_out", "{pads} smaller {pads|pad is|pads are} not listed",
     "小さい詰め板 {pads} 枚は載せていません。"},
    {"pads_press",
     "the pads above press on it with about {newton} N once the lid is closed, the weight of {kg} kg, with "
     "the "
     "foam's curve as it is given",
     "ふたを閉じると、上の詰め板が約 {newton} N（{kg} kg の重さ）で押します（緩衝材の曲線による計算）。"},
    {"pads_press_unknown",
     "the pads above press on it, and how hard is not known: name the foam by {flag}, or do without the "
     "squeeze",
     "上の詰め板が対象物を押しますが、その強さは分かりません。{flag} "
     "で緩衝材を指定するか、押し込みをやめてください。"},
    {"no_notches/floor",
     "finger notches {depth_mm} mm deep would not leave the floor that is wanted: the foam below the "
     "parting level is {high_mm} mm high; choose a smaller depth or a higher parting level",
     "深さ {depth_mm} mm の指かけでは、希望の底の厚さが残りません。分割の高さより下の緩衝材は {high_mm} "
     "mm です。深さを小さくするか、分割の高さを上げてください。"},
    {"no_notches/blocks",
     "there is no room for finger notches of {width_mm} x {depth_mm} mm with {room_mm} mm for the "
     "fingers: {blocks} {blocks|block more|blocks more} on each side would do, or smaller notches",
     "{width_mm} x {depth_mm} mm、奥行き {room_mm} mm の指かけの場所がありません。両側に {blocks} ブロック"
     "ずつ増やすか、指かけを小さくしてください。"},
    {"no_notches",
     "there is no room for finger notches of {width_mm} x {depth_mm} mm with {room_mm} mm for the "
     "fingers: choose smaller ones or another place beside the object",
     "{width_mm} x {depth_mm} mm、奥行き {room_mm} mm の指かけの場所がありません。小さくするか、対象物の別"
     "の所に置いてください。"},
};

}  // namespace

std::span<const Wording> words_of_fit() {
    return kWordsOfFit;
}

}  // namespace snug

#include "snug/words/catalogue.h"

// The sheet that travels with the box.

namespace snug {
namespace {

constexpr Wording kWordsOfPackingSheet[] = {
    {"packing.title", "{name}: packing sheet", "{name}：梱包指示書"},
    {"packing.subtitle", "Packing sheet · travels with the box · {size} mm",
     "梱包指示書 · 箱に添えてください · {size} mm"},
    {"packing.subtitle_items", "Packing sheet · travels with the box · {items} {items|item|items}",
     "梱包指示書 · 箱に添えてください · {items} 点"},
    {"packing.item", "Item {number}", "{number} 点目"},
    {"packing.picture_items", "2  Items in the lower foam", "2　下の緩衝材に納めたもの"},
    {"packing.lay_items",
     "Lower the items straight down into their cavities, as in picture 2 and in the order of the list "
     "below, without turning or pressing. Where one does not go in by its own weight, take it out and look "
     "why. Count them: none may be left over.",
     "図 2 のように、下の一覧の順に、回したり押し込んだりせず、それぞれのくぼみへまっすぐに下ろします。"
     "自重で収まらないものがあれば、いったん取り出して原因を調べます。数を数え、残りがないことを確かめま"
     "す。"},
    {"packing.picture_lower", "1  Lower foam, cavity up", "1　下の緩衝材（くぼみが上）"},
    {"packing.picture_object", "2  Object in the lower foam", "2　下の緩衝材に納めた対象物"},
    {"packing.picture_lid", "3  Lid, here turned over its BACK edge", "3　ふた（奥の縁を軸に裏返した図）"},
    {"packing.picture_below", "{number}  {piece}, cavity up", "{number}　{piece}（くぼみが上）"},
    {"packing.picture_layer", "{number}  Items of layer {layer}", "{number}　{layer} 段目に納めたもの"},
    {"packing.picture_above", "{number}  {piece}, here turned over its BACK edge",
     "{number}　{piece}（奥の縁を軸に裏返した図）"},
    {"packing.numbered", "{number} {name}", "{number} {name}"},
    {"packing.in_layer", "{item}; layer {layer}", "{item}、{layer} 段目"},
    {"packing.lay_layer",
     "Layer {layer}: lower {items;} straight down into their cavities, as in picture {picture}, without "
     "turning "
     "or pressing. Where one does not go in by its own weight, take it out and look why. Count them: none "
     "may "
     "be left over.",
     "{layer} 段目：{items;} を、図 {picture} のように、回したり押し込んだりせず、それぞれのくぼみへまっすぐ"
     "に下ろします。自重で収まらないものがあれば、いったん取り出して原因を調べます。数を数え、残りがないこと"
     "を確かめます。"},
    {"packing.put_middle_ribbons",
     "Lay two ribbons across, their ends outside, to lift the next piece by later. Lower {piece} straight "
     "down onto "
     "that, the side with its mark up, BACK over BACK, the marked corners together. Its rim must lie on the "
     "foam "
     "below all round without force.",
     "後で次の緩衝材を持ち上げるために、リボンを 2 本、端を外に出して渡します。その上に {piece} "
     "を、印のある面を"
     "上に、BACK "
     "どうし、印のある角どうしを合わせて、まっすぐに下ろします。力を入れなくても、縁は全周で下の緩衝材"
     "に載るはずです。"},
    {"packing.put_middle",
     "Lower {piece} straight down onto that, the side with its mark up, BACK over BACK, the marked corners "
     "together. Its rim must lie on the foam below all round without force.",
     "その上に {piece} を、印のある面を上に、BACK どうし、印のある角どうしを合わせて、まっすぐに下ろします。"
     "力を入れなくても、縁は全周で下の緩衝材に載るはずです。"},
    {"packing.unpack_layers",
     "To unpack go the other way round, layer by layer: lift the lid straight up, then each item of the "
     "uppermost layer by hand where the list below says that fingers fit beside it, and the foam under them "
     "only when it is empty, by its lift slots or by two ribbons that were laid under it. Where fingers fit "
     "nowhere, lay two ribbons across the cavity before the item, "
     "their ends outside, and lift by them. Never by a thin or projecting part. Slit sponge is lifted on a "
     "board that does not bend.",
     "取り出すときは逆の順に、段ごとに行います。まずふたをまっすぐ上に持ち上げ、一番上の段のものを一つずつ、"
     "下の一覧で指の入る所から手で取り出します。その下の緩衝材は、空になってから、持ち上げ口か、下に渡して"
     "おいた 2 本のリボンで持ち上げます。指の入る所が"
     "ないものは、納める前にくぼみへリボンを 2 "
     "本、端を外に出して渡しておき、それを持って取り出します。細い所や突き出た所"
     "を持たないでください。スリットスポンジは、曲がらない板に載せて持ち上げます。"},
    {"packing.pads", "Pads", "詰め板"},
    {"packing.pads_how",
     "Cut them from sheets of the same foam and stack them; seen into the cavity, as on every picture. Hold "
     "them by "
     "their fit, or by pins or stitches from the far side: no adhesive near the object.",
     "同じ緩衝材の板から切り出し、重ねて使います。図はどれも、くぼみを覗いた向きです。はめ込むか、反対側か"
     "ら"
     "ピンや糸で留めます。対象物の近くに接着剤を使わないでください。"},
    {"packing.pads_stock", "They take {cm2} cm2 of sheet {mm} mm thick, without waste.",
     "厚さ {mm} mm の板を {cm2} 平方センチ使います（切りくずを除く）。"},
    {"packing.pads_on", "{piece}, cavity facing you", "{piece}（くぼみを手前にした向き）"},
    {"packing.lay_pads", "Put the pads in their places, as drawn below.",
     "詰め板を、下の図の場所に置きます。"},
    {"pad.text",
     "{piece}, {left} mm from the left and {back} mm from BACK: {size} mm ({sheets} "
     "{sheets|sheet|sheets} of {sheet_mm} mm)",
     "{piece}、左から {left} mm、奥から {back} mm：{size} mm（{sheet_mm} mm の板 {sheets} 枚）"},
    {"packing.how", "How to lay it in", "納め方"},
    {"packing.stand",
     "Stand the case with the lower foam in it, cavity up, the edge marked BACK away from you. The "
     "cavity must be empty and free of crumbs.",
     "下の緩衝材を、くぼみを上にしてケースに入れ、奥（BACK と書いた縁）を向こう側にして置きます。く"
     "ぼみは空で、緩衝材のくずが残っていないことを確かめます。"},
    {"packing.lay",
     "Lower the object straight down into its cavity, as in picture 2, without turning or pressing. "
     "Where it does not go in by its own weight, take it out and look why.",
     "図 2 のように、対象物を回したり押し込んだりせず、くぼみへまっすぐに下ろします。自重で収まらない"
     "ときは、いったん取り出して原因を調べます。"},
    {"packing.close",
     "Put the lid on by hand, cavity down, BACK over BACK, the marked corners together. The rims "
     "must meet all round without force. Never press the lid with the case's cover.",
     "ふたのくぼみを下に向け、BACK どうし、印のある角どうしを合わせて、手でかぶせます。力を入れなくて"
     "も、縁は全周で合うはずです。ケースのふたで押さえつけないでください。"},
    {"packing.close/pressing",
     "Put the lid on by hand, cavity down, BACK over BACK, the marked corners together. Its pads press on "
     "what "
     "is packed: the rims may stand up to {mm} mm apart until the case or the carton is closed over them. "
     "Where more than that stays open, take the lid off and look why.",
     "ふたのくぼみを下に向け、BACK どうし、印のある角どうしを合わせて、手でかぶせます。詰め板が対象物を押す"
     "ため、ケースや箱を閉じるまで縁が {mm} mm "
     "まで開くことがあります。それより開いているときは、ふたを外して原因を調べます。"},
    {"packing.leave_open",
     "This is a tray: no foam lies on it, and it protects nothing when it is turned over or dropped. Carry "
     "it "
     "level, and keep what covers it off the items.",
     "これはふたのないトレイです。上に緩衝材はなく、裏返したり落としたりすると中のものを守れません。水平に"
     "運び、覆うものが中のものに触れないようにしてください。"},
    {"packing.unpack_open",
     "To unpack, lift it out by hand where fingers fit beside it: {places,}. Never by a thin or projecting "
     "part.",
     "取り出すときは、脇に指の入る所（{places,}）から手で取り出します。細い所や突き出た所を持たないで"
     "ください。"},
    {"packing.unpack_open_items",
     "To unpack, lift each item by hand where the list below says that fingers fit beside it, or where it "
     "stands out of the foam. Where neither will do, lay two ribbons across its cavity before the item, "
     "their "
     "ends outside, and lift by them. Never by a thin or projecting part.",
     "取り出すときは、一つずつ、下の一覧で指の入る所か、緩衝材から出ている所を手で持って取り出します。どち"
     "らもないものは、納める前にくぼみへリボンを 2 本、端を外に出して渡しておき、それを持って取り出します。"
     "細い所や突き出た所を持たないでください。"},
    {"packing.unpack_open_layers",
     "To unpack go the other way round, layer by layer: lift each item of the uppermost layer by hand where "
     "the list below says that fingers fit beside it or where it stands out of the foam, and the foam under "
     "them only when it is empty, by its lift slots or by two ribbons that were laid under it. Where fingers "
     "fit nowhere, lay two ribbons across the cavity before the "
     "item, their ends outside, and lift by them. Never by a thin or projecting part. Slit sponge is lifted "
     "on "
     "a board that does not bend.",
     "取り出すときは逆の順に、段ごとに行います。一番上の段のものを一つずつ、下の一覧で指の入る所か、緩衝材"
     "から出ている所を手で持って取り出します。その下の緩衝材は、空になってから、持ち上げ口か、下に渡してお"
     "いた 2 本のリボンで持ち上げます。指の入る所がな"
     "い"
     "ものは、納める前にくぼみへリボンを 2 "
     "本、端を外に出して渡しておき、それを持って取り出します。細い所や突き出た所"
     "を持たないでください。スリットスポンジは、曲がらない板に載せて持ち上げます。"},
    {"packing.unpack_open_ribbons",
     "To unpack, take hold of it where it stands out of the foam. No side leaves the {mm} mm that a finger "
     "wants (widest: {widest}): where it stands out too little, lay two ribbons across the tray before the "
     "object, their ends outside, and lift by them.",
     "取り出すときは、緩衝材から出ている所を持ちます。指を入れるのに要る {mm} mm のすきまは、どの側にもあ"
     "りません（最も広い所：{widest}）。出ている所が少ないときは、対象物を納める前に、リボンを 2 本、端を外"
     "に出してトレイに渡しておき、それを持って取り出します。"},
    {"packing.unpack",
     "To unpack, lift the lid straight up first. Lift out by hand where fingers fit beside the "
     "object: {places,}. Never by a thin or projecting part.",
     "取り出すときは、まずふたをまっすぐ上に持ち上げます。対象物は、脇に指の入る所（{places,}）から手"
     "で取り出します。細い所や突き出た所を持たないでください。"},
    {"packing.unpack_items",
     "To unpack, lift the lid straight up first, then each item by hand where the list below says that "
     "fingers fit beside it. Where they fit nowhere, lay two ribbons across its cavity before the item, "
     "their ends outside, and lift by them. Never by a thin or projecting part.",
     "取り出すときは、まずふたをまっすぐ上に持ち上げ、次に一つずつ、下の一覧で指の入る所から手で取り出し"
     "ます。指の入る所がないものは、納める前にくぼみへリボンを 2 本、端を外に出して渡しておき、それを持っ"
     "て取り出します。細い所や突き出た所を持たないでください。"},
    {"packing.with_fingers", "{item}; fingers fit: {places,}", "{item}。指の入る所：{places,}"},
    {"packing.without_fingers", "{item}; no room for fingers: ribbons",
     "{item}。指の入る所なし：リボンを使う"},
    {"packing.place", "{side} {mm} mm at {column}", "{column} の{side} {mm} mm"},
    {"packing.unpack_ribbons",
     "To unpack, lift the lid straight up first. No side leaves the {mm} mm that a finger wants "
     "(widest: {widest}). Lay two ribbons across the lower foam before the object, their ends "
     "outside, and lift by them.",
     "取り出すときは、まずふたをまっすぐ上に持ち上げます。指を入れるのに要る {mm} mm のすきまは、どの"
     "側にもありません（最も広い所：{widest}）。対象物を納める前に、リボンを 2 本、端を外に出して下の"
     "緩衝材に渡しておき、それを持って取り出します。"},
    {"packing.widest", "{side}, {mm} mm at {column}", "{column} の{side} {mm} mm"},
    {"packing.what", "What it is", "内容"},
    {"packing.object_of", "{name}, {size} mm, {kg} kg", "{name}、{size} mm、{kg} kg"},
    {"packing.object_unweighed", "{name}, {size} mm, weight not given", "{name}、{size} mm、重さの指定なし"},
    {"packing.tray", "Tray", "トレイ"},
    {"packing.walls_of_tray", "floor {floor} · back {back} · front {front} · left {left} · right {right} mm",
     "底 {floor} · 奥 {back} · 手前 {front} · 左 {left} · 右 {right} mm"},
    {"packing.closed", "Foam, closed", "閉じた大きさ"},
    {"packing.closed_of", "{size} mm (x upward, y from BACK, z across)",
     "{size} mm（x：上へ、y：奥から手前へ、z：左右）"},
    {"packing.walls_of",
     "floor {floor} · lid {lid} · back {back} · front {front} · left {left} · right {right} mm",
     "底 {floor} · ふた {lid} · 奥 {back} · 手前 {front} · 左 {left} · 右 {right} mm"},
    {"packing.any_case", "none was chosen: one of {size} mm inside (length, width, height), with little more",
     "指定なし：内寸 {size} mm（長さ、幅、高さ）より少し大きいもの"},
    {"packing.foam_weighs", "{litres} litres, {kg} kg", "{litres} リットル、{kg} kg"},
    {"packing.foam_and_object", "{litres} litres, {kg} kg; with its content {all_kg} kg, without the case",
     "{litres} リットル、{kg} kg。対象物を含めて {all_kg} kg（ケースを除く）"},
    {"packing.pieces", "To lift", "持ち上げる重さ"},
    {"packing.pieces_of", "{pieces,}", "{pieces,}"},
    {"packing.piece_weighs", "{piece} {kg} kg", "{piece} {kg} kg"},
    {"packing.material", "Material", "材料"},
    {"packing.material_of", "{litres} litres, {cost}", "{litres} リットル、{cost}"},
    {"packing.know", "What to know", "注意点"},
    {"packing.nothing_found", "Nothing was found in the shape of the foam.",
     "緩衝材の形に問題は見つかりませんでした。"},
    {"packing.unchecked", "What was not checked", "確かめていないこと"},
    {"packing.unchecked_drops",
     "Drops and shocks: neither the foam's thickness nor its stiffness was matched to the object's "
     "weight and fragility.",
     "落下と衝撃：緩衝材の厚さと硬さは、対象物の重さと壊れやすさに合わせて決めたものではありません"
     "。"},
    {"packing.drops", "What it meets in a drop", "落下のときの衝撃"},
    {"packing.drops_enough", "On all six sides no more than that is met, by the high end of each range.",
     "六つの面のどれでも、範囲の上端はこの値を超えません。"},
    {"packing.drops_over", "Not shown to be enough: {sides;}.", "足りるとはいえない面：{sides;}。"},
    {"packing.drops_source", "The foam's curve is from: {source}.", "緩衝材の曲線の出典：{source}"},
    {"packing.drops_claim",
     "An estimate for the first drop, flat on one side, at 23 C; confirm it by a drop test.",
     "最初の落下、一つの面で平らに落ちた場合、23 ℃ での推定値です。落下試験で確かめてください。"},
    {"packing.unchecked_other_drops",
     "Drops on corners and edges, later drops, rebound, other temperatures than 23 C, what the case gives, "
     "the object's own resonance, ageing of the foam.",
     "角や稜からの落下、二度目以降の落下、はね返り、23 ℃ "
     "以外の温度、ケースのたわみ、対象物自体の共振、緩衝材の劣化。"},
    {"packing.unchecked_pressure",
     "Pressure: whether the foam dents where the object rests on a small area, or sags in a long "
     "store.",
     "圧力：対象物が小さな面で載る所で緩衝材がへこまないか、長期の保管で沈まないか。"},
    {"packing.unchecked_material",
     "The material near collections: gases, plasticisers, dust, colour, flammability. Ask a "
     "conservator; put tissue or film between where in doubt.",
     "収蔵品のそばに置く材料：ガス、可塑剤、粉、色移り、燃えやすさ。保存の専門家に相談し、不安があれ"
     "ば薄葉紙やフィルムを間に挟んでください。"},
    {"packing.record", "To fill in by hand", "記入欄"},
    {"packing.record_in", "Packed", "梱包時"},
    {"packing.record_out", "Unpacked", "開梱時"},
    {"packing.record_count", "Items counted, of {items}", "点数（全 {items} 点）"},
    {"packing.record_condition", "Condition, damage", "状態・損傷"},
    {"packing.record_name", "Name", "氏名"},
    {"packing.record_date", "Date", "日付"},
    {"packing.record_accession", "Accession or order number", "登録番号・注文番号"},
    {"packing.record_gross", "Gross mass with the case, kg", "総重量（ケースを含む）、kg"},
    {"packing.record_gross_of", "Gross mass with the case, kg (content {kg})",
     "総重量（ケースを含む）、kg（中身 {kg}）"},
    {"packing.record_parts", "Parts taken off, and where they are", "外した部品と、その置き場所"},
    {"packing.record_carrier", "Batteries, liquids (carrier rules not checked)",
     "電池・液体（運送会社の規則は確かめていません）"},
    {"packing.record_spare", "Spare foam in the case", "ケースに入れた予備の緩衝材"},
    {"packing.record_up", "Mark the case like this on two sides: the lower foam lies below.",
     "下の緩衝材が下になる向きで、ケースの二つの面にこの印を付けてください。"},
    {"packing.unchecked_model",
     "The model itself: whether it is the object's true size and shape, as it is today.",
     "モデル自体：対象物の現在の大きさと形に合っているか。"},
};

}  // namespace

std::span<const Wording> words_of_packing_sheet() {
    return kWordsOfPackingSheet;
}

}  // namespace snug

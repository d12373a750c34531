#include "snug/words/catalogue.h"

// Foams that push back, what an item meets in a drop, and what of that is not known.

namespace snug {
namespace {

constexpr Wording kWordsOfProtection[] = {
    {"foam/ld33", "cross-linked polyethylene foam of closed cells, Plastazote LD33",
     "独立気泡の架橋ポリエチレンフォーム、Plastazote LD33"},
    {"foam/ethafoam-200lc", "polyethylene foam of closed cells, Ethafoam 200LC",
     "独立気泡のポリエチレンフォーム、Ethafoam 200LC"},
    {"foam/ethafoam-220", "polyethylene foam of closed cells, Ethafoam 220",
     "独立気泡のポリエチレンフォーム、Ethafoam 220"},
    {"foam/ethafoam-nova", "polyethylene foam of closed cells, Ethafoam Nova",
     "独立気泡のポリエチレンフォーム、Ethafoam Nova"},
    {"foam/ethafoam-select", "polyethylene foam of closed cells, Ethafoam Select",
     "独立気泡のポリエチレンフォーム、Ethafoam Select"},
    {"foam/ethafoam-hs-45", "polyethylene foam of closed cells, Ethafoam HS-45",
     "独立気泡のポリエチレンフォーム、Ethafoam HS-45"},
    {"foam/ethafoam-hs-600", "polyethylene foam of closed cells, Ethafoam HS-600",
     "独立気泡のポリエチレンフォーム、Ethafoam HS-600"},
    {"foam_status.measured", "measured", "測定値"},
    {"foam_status.sheet", "maker's sheet", "メーカー資料"},
    {"foam_status.model", "a model", "計算モデル"},
    {"foam_status.unverified", "unverified", "未確認"},
    {"list.bears", "bears, kPa", "長期 kPa"},
    {"list.curve", "curve", "曲線"},
    {"list.curve_of_drops", "to {percent} %, from drops", "{percent} % まで、落下試験"},
    {"list.curve_of_pressing", "to {percent} %, pressed slowly", "{percent} % まで、静的"},
    {"list.data", "data", "データ"},
    {"list.own_foams",
     "A curve says what the foam pushes back with where it is squeezed by a share of its thickness. Add your "
     "own\n"
     "in {file}: a curve of strain and kPa, or at least five points of a\n"
     "cushion curve (static kPa, G, thickness mm, drop mm):",
     "曲線は、厚さに対する割合で押されたときに緩衝材が押し返す圧力です。自分の緩衝材は\n{file} "
     "に加えてください。ひずみと kPa の曲線か、\n緩衝曲線の五つ以上の点（静的応力 kPa、G、厚さ mm、落下高さ "
     "mm）を書きます："},
    {"help.foams", "List foams whose data are known: how they push back in a drop, what they bear for long",
     "データの分かっている緩衝材を一覧します：落下のときの押し返し方と、長く耐える圧力"},
    {"help.foams.json", "Print them as foams.json has them", "foams.json の形で出力します"},
    {"curve.two_points", "two or more points", "二つ以上の点"},
    {"curve.many", "at most {most} points", "{most} 個以下の点"},
    {"curve.strains", "points whose strains rise between 0 and 1", "ひずみが 0 と 1 の間で増えていく点"},
    {"curve.falls", "points whose stresses are above 0 and never fall", "応力が 0 より大きく、下がらない点"},
    {"curve.must_be", "the stress-strain curve must be {what}",
     "応力ひずみ曲線は、{what}でなければなりません"},
    {"json.curve", "a list of [strain, kPa]", "[ひずみ, kPa] のリスト"},
    {"takes.curve", "strain:kPa pairs such as {example}", "{example} のような、ひずみ:kPa の組"},
    {"takes.number_or_word", "a number such as {example}, none, {words;}",
     "{example} のような数値、none、{words;} のいずれか"},
    {"foam.thickness", "the least tested thickness is above the greatest",
     "試験した厚さの最小が最大を超えています"},
    {"foam.curve_or_points", "give a curve or points, not both", "曲線か点のどちらか一つにしてください"},
    {"foam.twice", "two foams are called {name}: give each a name of its own",
     "{name} という緩衝材が二つあります。別の名前にしてください"},
    {"foam.unknown", "no foam is called {name}; known are {known;}",
     "{name} という緩衝材はありません。使えるのは {known;} です"},
    {"cushion.points", "points must be a list of [static kPa, G, thickness mm, drop mm]",
     "点は [静的応力 kPa, G, 厚さ mm, 落下高さ mm] のリストでなければなりません"},
    {"cushion.few", "a cushion curve needs at least {least} points, not {found}",
     "緩衝曲線には {least} 点以上が必要です（{found} 点しかありません）"},
    {"cushion.many", "a cushion curve may have {most} points, not {found}",
     "緩衝曲線の点は {most} 個までです（{found} 個あります）"},
    {"cushion.above_0", "every number of a cushion curve's point must be above 0",
     "緩衝曲線の点の数値はすべて 0 より大きくなければなりません"},
    {"cushion.residuals",
     "no curve gives these points back: they are off by {residuals;} %, more than {most} %; look for a "
     "mistyped "
     "point or enter points of one thickness and height",
     "これらの点に合う曲線がありません。ずれは {residuals;} % で、{most} % "
     "を超えます。打ち間違いを探すか、一つの厚さと高さの点だけにしてください"},
    {"protection.height_or_rule", "choose a height or a rule for the drop, not both",
     "落下高さは、数値か規格のどちらか一つにしてください"},
    {"protection.g_or_class", "choose a number of G or a class for the fragility, not both",
     "壊れやすさは、G の数値か区分のどちらか一つにしてください"},
    {"protection.tray", "a tray has no lid and is not dropped: leave out the drop's height, or {option}",
     "トレイにはふたがなく、落下の対象になりません。落下高さか {option} を外してください"},
    {"protect.lacking", "{wish} need {what&}", "{wish}、{what&}が必要です"},
    {"protect.lacks/mass", "the mass of every item (--mass)", "すべてのものの質量（--mass）"},
    {"protect.lacks/drop", "the drop (--drop-height)", "落下高さ（--drop-height）"},
    {"protect.lacks/borne", "what every item bears (--fragility)", "すべてのものが耐える衝撃（--fragility）"},
    {"protect.lacks/foam", "a foam whose curve is known (--foam)", "曲線の分かっている緩衝材（--foam）"},
    {"protect.wish/walls", "walls that protect", "保護する壁を決めるには"},
    {"protect.wish/shock", "searches that weigh shocks", "衝撃を重視して探すには"},
    {"protect.not_fitted",
     "walls that protect are chosen where the space fits itself to what lies in it: leave out the case and "
     "say "
     "{option}",
     "保護する壁を決められるのは、空間を中身に合わせるときだけです。ケースの指定を外し、{option} "
     "としてください"},
    {"protect.too_thick",
     "from {cm} cm {fallen} it may bottom through any wall up to {most} mm: take a stiffer foam, one with "
     "data of "
     "drops, less height, or a way to lie on a larger side",
     "{cm} cm から{fallen}を下に落とすと、{most} mm "
     "までのどの壁でも底づきのおそれがあります。硬い緩衝材、落下試"
     "験のデータがある緩衝材、低い落下高さ、広い面で載る置き方のどれかにしてください"},
    {"protect.too_stiff",
     "from {cm} cm {fallen} this foam is too stiff for it, with any wall up to {most} mm: take a softer "
     "foam, one "
     "with data of drops, less height, or a way to lie on a smaller side",
     "{cm} cm から{fallen}を下に落とす場合、この緩衝材は硬すぎ、{most} mm "
     "までのどの壁でも足りません。軟らかい緩衝材"
     "、落下試験のデータがある緩衝材、低い落下高さ、狭い面で載る置き方のどれかにしてください"},
    {"protect.stand_in",
     "walls that protect are not chosen for what is read in pieces or as points: its drops are computed with "
     "a "
     "copy that stands outside it, and might hide a side that bottoms. Give the walls in mm, or read a mesh "
     "whole "
     "({option})",
     "分割して読むものや点群には、保護する壁を決められません。落下は外側にあるコピーで計算するため、底づきす"
     "る"
     "面を"
     "見落とすおそれがあります。壁を mm で指定するか、メッシュの全体を読み込んでください（{option}）"},
    {"protect.fit_case", "walls that protect fit the space to them: leave out {option}",
     "保護する壁に合わせて空間を決めます。{option} を外してください"},
    {"falls_less",
     "{foam_kg} kg of foam make it fall from {low} mm instead of {high} by the height of {rule}: by their "
     "own mass "
     "the items would fall from {high} mm",
     "緩衝材 {foam_kg} kg の重さのため、{rule} の高さは {high} mm ではなく {low} mm "
     "です（中身だけの質量なら {high} mm）"},
    {"protect.items_meet",
     "from {cm} cm {fallen} items may meet through the foam between them, whatever the walls: put more foam "
     "between them (--between), or lay them into layers of their own",
     "{cm} cm から{fallen}を下に落とすと、壁の厚さにかかわらず、隣のものとぶつかるおそれがあります。間の"
     "緩衝材（--between）を増やすか、別の段に置いてください"},
    {"protect.between",
     "dropped from {cm} cm items may meet through the foam between them, even where {most} mm of it are: "
     "take a "
     "stiffer foam or less height, or lay them into layers of their own",
     "{cm} cm から落とすと、間の緩衝材が {most} mm "
     "あっても隣のものとぶつかるおそれがあります。硬い緩衝材にするか、落下高さを下げるか、別の段に置いてく"
     "ださい"},
    {"moved_apart",
     "items lie farther apart than was asked, so that they do not meet through the foam between them in a "
     "drop",
     "落としたときに間の緩衝材越しにぶつからないよう、指定より離して並べました"},
    {"protect.too_heavy",
     "with foam as thick as that would take the pack would weigh {kg} kg, more than the rule of the drop "
     "goes "
     "to: take another foam, or give the height in mm",
     "必要な厚さの緩衝材では全体が {kg} kg "
     "になり、落下高さの規則の範囲を超えます。緩衝材を変えるか、高さを mm で指定してください"},
    {"protect.none", "no walls were found with which every item meets no more than it bears",
     "すべてのものの衝撃が耐えられる値に収まる壁が見つかりませんでした"},
    {"status.walls", "Choosing walls", "壁の厚さを決めています"},
    {"status.drops", "Estimating drops", "落下を計算中"},
    {"fall.floor", "on its floor", "底"},
    {"fall.roof", "on its lid", "ふた"},
    {"fall.back", "on its back", "奥の面"},
    {"fall.front", "on its front", "手前の面"},
    {"fall.left", "on its left side", "左の面"},
    {"fall.right", "on its right side", "右の面"},
    {"drop.deep", "{mm} mm deep", "{mm} mm 沈む"},
    {"drop.range", "{low} to {high} G", "{low} から {high} G"},
    {"drop.g", "from {cm} cm {fallen}: about {range}", "{cm} cm から{fallen}を下に落とすと約 {range} です"},
    {"drop.over", "{drop}; you asked for {asked}: not shown to be enough",
     "{drop}。求められた {asked} G で足りるとは示せません"},
    {"drop.within", "{drop}; you asked for {asked}: no more than that, as far as is estimated",
     "{drop}。計算した範囲では、求められた {asked} G を超えません"},
    {"drop.bottoms",
     "from {cm} cm {fallen} the foam may be squeezed beyond its data or the case be met: no shock can "
     "be told",
     "{cm} cm から{fallen}を下に落とすと、緩衝材がデータの範囲を超えてつぶれるか、ケースに当たるお"
     "それがあり、衝撃を示せません"},
    {"drop.thin",
     "from {cm} cm {fallen} over a tenth of the energy would be taken by foam thinner than its data "
     "({mm} mm): no shock can be told",
     "{cm} cm から{fallen}を下に落とすと、データの厚さ（{mm} mm）より薄い緩衝材がエネルギーの一割以"
     "上を受けるため、衝撃を示せません"},
    {"drop.items_meet",
     "from {cm} cm {fallen} the foam to another item may be squeezed beyond its data, or they meet",
     "{cm} cm から{fallen}を下に落とすと、隣のものとの間の緩衝材がデータの範囲を超えてつぶれるか、ぶ"
     "つかるおそれがあります"},
    {"shock", "{drop}{more}. {advice}", "{drop}{more}。{advice}"},
    {"bottoms", "{drop}{more}. {advice}", "{drop}{more}。{advice}"},
    {"thin_pads", "{drop}{more}. {advice}", "{drop}{more}。{advice}"},
    {"shock.thicker_walls", "Thicker walls there would do", "その側の壁を厚くしてください"},
    {"shock.others", " ({items} more {items|item|items} likewise)", "（ほか {items} 個も同様）"},
    {"shock.more_foam", "{mm} mm more foam behind it would do",
     "後ろの緩衝材をあと {mm} mm 厚くすれば足ります"},
    {"shock.more_foam_or_data", "{mm} mm more foam behind it, or a foam with data of drops, would do",
     "後ろの緩衝材をあと {mm} mm 厚くするか、落下試験のデータがある緩衝材を選んでください"},
    {"shock.other_foam", "Less height or another foam may do",
     "落下高さを下げるか、ほかの緩衝材を選んでください"},
    {"shock.other_foam_or_data", "A foam with data of drops, less height or another way to lie may do",
     "落下試験のデータがある緩衝材にするか、落下高さや置き方を変えてください"},
    {"no_shock/foam",
     "what it meets in a drop is not estimated: nothing is known of how this foam pushes back; name it by "
     "--foam "
     "(`snug foams` lists those with data and where to add one's own)",
     "落下の衝撃は計算していません。この緩衝材の押し返し方が分からないためです。--foam "
     "で指定してください（`snug foams` で一覧と、自分の緩衝材の加え方を示します）"},
    {"no_shock/mass", "what it meets in a drop is not estimated without its mass (--mass)",
     "質量（--mass）がないため、落下の衝撃は計算していません"},
    {"no_shock/height",
     "what it meets in a drop is not estimated: the rule needs the mass of every item, and the pack must not "
     "be "
     "heavier than the rule goes; or give the height in mm",
     "落下の衝撃は計算していません。規格にはすべてのものの質量が必要で、規格の範囲より重い梱包には使えません"
     "。"
     "高さを mm で指定することもできます"},
    {"items_meet", "{drop}{more}. {advice}", "{drop}{more}。{advice}"},
    {"shock.more_between", "Put more foam between them (--between), or lay them into layers of their own",
     "間の緩衝材（--between）を増やすか、別の段に置いてください"},
    {"no_shock/unsettled",
     "what items meet in a drop is not estimated: they reach one another through foam, and their motion "
     "does not come to an end in the steps that are allowed",
     "落下の衝撃は計算していません。緩衝材を介して押し合うものの動きが、許された計算の段階では収まらな"
     "いためです"},
    {"shock_of_stand_in",
     "drops were computed with a copy of what is read in pieces or as points, which stands a little outside "
     "it: it is held "
     "by more foam than the thing itself, so that the figures differ and a side that bottoms may be missed. "
     "Read it "
     "whole, as a mesh, to be sure",
     "分割して読むものや点群の落下は、少し外側にあるコピーで計算しました。実物より多くの緩衝材に支えられるた"
     "め、値が変わり、"
     "底つきする面を見落とすことがあります。確かめるには、メッシュとして全体を読み込んでください"},
    {"foam_of_rigid",
     "these drops are of the foam that is named, {foam}: what is printed or built here holds and does not "
     "cushion, so none "
     "of them is true of it",
     "落下の計算は、指定した緩衝材 {foam} "
     "のものです。印刷や組み立てで作るものは支えるだけで緩衝せず、この値は当てはまりません"},
    {"no_shock/open", "a tray is not dropped: no shock is estimated", "トレイは落下の対象にしていません"},
    {"rest.unknown/foam", "how it rests is not estimated: nothing is known of how this foam pushes back",
     "この緩衝材の押し返し方が分からないため、静止時の圧力は計算していません"},
    {"rest.unknown/mass", "how it rests is not estimated without its mass",
     "質量がないため、静止時の圧力は計算していません"},
    {"rest.unknown/bottoms",
     "already at rest the foam below would be squeezed beyond its data, or there is none of it",
     "静止するだけで、下の緩衝材がデータの範囲を超えてつぶれるか、下に緩衝材がありません"},
    {"near_collections", "near collections:{known}", "収蔵品の近くで：{known}"},
    {"near.ethafoam",
     " Ethafoam, one interlaboratory Oddy test: permanent in 5 laboratories, temporary in 2; Oddy judges "
     "metals "
     "only.",
     "Ethafoam は、ある共同 Oddy 試験で 5 か所が永続使用可、2 か所が一時使用可としました。Oddy "
     "試験が見るのは金属だけです。"},
    {"near.plastazote", " White Plastazote LD45 degraded cellulose in ageing.",
     "白い Plastazote LD45 は、劣化試験でセルロースを傷めました。"},
    {"near.printed", " One PLA filament was unsuitable in 7 of 7 laboratories.",
     "ある PLA フィラメントは 7 か所中 7 か所で不適でした。"},
    {"near.unknown", " Unknown sponge: no contact, no storage.",
     "素性の分からないスポンジは、触れさせず、保管にも使わないでください。"},
    {"near.name_it", " Name product, batch and colour, and have it tested.",
     "製品名、ロット、色を記録し、試験を受けてください。"},
    {"near.liner", " Cut faces are abrasive: lay a liner between.",
     "切断面は擦れます。間に布などを敷いてください。"},
    {"not_computed.rim", "friction and shear at the rim", "縁での摩擦とせん断"},
    {"not_computed.air", "trapped air", "閉じ込められた空気"},
    {"not_computed.case", "what the case gives, and its play", "ケースのたわみと遊び"},
    {"not_computed.rebound", "rebound and later drops", "はね返りと二回目以降の落下"},
    {"not_computed.corners", "drops on corners and edges", "角や辺からの落下"},
    {"not_computed.cold", "temperatures other than 23 C", "23 ℃ 以外の温度"},
    {"not_computed.resonance", "the object's own resonance", "対象物そのものの共振"},
    {"not_computed.ageing", "ageing", "経年変化"},
    {"summary.drop", "Drop", "落下"},
    {"summary.drop_from", "from {height} mm{rule}, in {foam} ({status}, {curve}):",
     "{height} mm から{rule}、{foam}（{status}、{curve}）："},
    {"summary.borne_by_all", "taken to bear: {g} G", "耐えられるとした衝撃：{g} G"},
    {"summary.borne_by", "{item} {g} G", "{item} {g} G"},
    {"summary.borne", "taken to bear: {items,}", "耐えられるとした衝撃：{items,}"},
    {"summary.drop_rule", ", height from {rule}; not a test of it", "、{rule} の高さ（試験ではありません）"},
    {"summary.drop_rule/unverified",
     ", height as {rule} is said to have it, which is not verified; not a test of it",
     "、{rule} によるとされる高さ（規格では未確認、試験ではありません）"},
    {"summary.drop_face", "{fallen} {what}", "{fallen}：{what}"},
    {"summary.drop_face/item", "{fallen} {what} ({item})", "{fallen}：{what}（{item}）"},
    {"summary.drop_g", "{range}, {deep}", "{range}、{deep}"},
    {"summary.drop_bottoms", "may bottom", "底づきのおそれ"},
    {"summary.drop_none", "not estimated", "計算なし"},
    {"summary.drop_claim",
     "an estimate, first drop, flat on one side, at 23 C; confirm by a drop test. docs/protection.md tells "
     "what is "
     "not computed",
     "推定値です（最初の落下、一つの面で平らに、23 "
     "℃）。落下試験で確かめてください。計算していないことは docs/protection.md にあります"},
};

}  // namespace

std::span<const Wording> words_of_protection() {
    return kWordsOfProtection;
}

}  // namespace snug

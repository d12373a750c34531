#include "snug/words/catalogue.h"

// Proposals: `snug plan`.

namespace snug {
namespace {

constexpr Wording kWordsOfPlan[] = {
    {"plan.kind/smallest", "Smallest", "最も小さい"},
    {"plan.kind/most-margin", "Most margin", "最も余裕がある"},
    {"plan.kind/cheapest", "Cheapest", "最も安い"},
    {"plan.same", "as {other}", "「{other}」と同じ"},
    {"plan.foam", "Foam", "緩衝材"},
    {"plan.foam_of", "{preset}; its shocks reckoned as those of {foam}",
     "{preset}。衝撃は {foam} のデータで計算"},
    {"plan.case", "Case", "ケース"},
    {"plan.case_known", "{name}, {size} mm inside, {litres} litres",
     "{name}、内寸 {size} mm、{litres} リットル"},
    {"plan.case_given", "the one that is there, {size} mm inside, {litres} litres",
     "手元のもの、内寸 {size} mm、{litres} リットル"},
    {"plan.case_made", "made to measure, {size} mm inside, {litres} litres",
     "寸法に合わせて作る、内寸 {size} mm、{litres} リットル"},
    {"plan.costs", "Costs", "費用"},
    {"plan.money", "{cost}, billed as {kg} kg", "{cost}、請求重量 {kg} kg"},
    {"plan.billed", "no price known, billed as {kg} kg", "価格不明、請求重量 {kg} kg"},
    {"plan.drop", "Drop", "落下"},
    {"plan.drop_meets", "meets at most {worst} G of {asked} G on its worst side: does what was asked",
     "最も悪い面で {worst} G 以下（求めた値 {asked} G）：満たします"},
    {"plan.drop_above", "may meet {worst} G of {asked} G on its worst side: does not meet it",
     "最も悪い面で {worst} G になりえます（求めた値 {asked} G）：満たしません"},
    {"plan.drop_bottoms", "the foam may be squeezed flat on its worst side: does not meet it",
     "最も悪い面で緩衝材が底づきするおそれがあります：満たしません"},
    {"plan.drop_untold", "not told on every side: see what stands below",
     "すべての面では計算できません：下の注意を見てください"},
    {"plan.drop_alone", "meets at most {worst} G on its worst side; say what it bears to have that judged",
     "最も悪い面で {worst} G 以下。耐えられる値を指定すると判定します"},
    {"plan.drop_no_mass", "not known: say what it weighs", "不明：質量を指定してください"},
    {"plan.drop_no_data", "not known: nothing is known of how this foam pushes back",
     "不明：この緩衝材の押し返し方のデータがありません"},
    {"plan.drop_none", "nothing is claimed: it stays where it is kept", "評価なし：保管場所から動かしません"},
    {"plan.walls_of", "{thinnest} to {thickest} mm around it", "周囲に {thinnest}～{thickest} mm"},
    {"plan.walls_same", "{mm} mm all around it", "周囲に {mm} mm"},
    {"plan.work", "Work", "作業"},
    {"plan.work_of", "{pieces} {pieces|piece|pieces}, about {hours} hours at {seconds} s each",
     "{pieces} 個、1 個 {seconds} 秒で約 {hours} 時間"},
    {"plan.make", "Make it", "作る"},
    {"plan.written", "In {folder}: a project and a drawing of each",
     "{folder} に：それぞれのプロジェクトと図"},
    {"plan.folder", "FOLDER", "フォルダー"},
    {"plan.one_kind", "{option} takes {names/}, not {word}",
     "{option} に指定できるのは {names/} です（{word} は不可）。"},
    {"status.planning", "Planning", "計画中"},
    {"help.plan", "Three whole proposals for objects: the smallest, the one with most margin, the cheapest",
     "対象物に対する三つの提案：最も小さいもの、最も余裕があるもの、最も安いもの"},
    {"help.plan.output", "Folder for a project and a drawing of each; without it they are only told",
     "それぞれのプロジェクトと図を書き出すフォルダー。なければ表示だけします"},
    {"help.plan.carrier",
     "Who moves it, which says how high it may fall: {names/}; a store claims nothing about drops, by hand "
     "it "
     "is 760 mm, "
     "else ISTA 2A",
     "だれが運ぶか（落下高さが決まります）：{names/}。`store`（保管）では落下を評価せず、`hand`（手持ち）は "
     "760 "
     "mm、ほかは ISTA "
     "2A です"},
    {"help.plan.ways", "Ways of working that may be chosen, where `--for` names none: {names/}",
     "`--for` がないときに選んでよい作り方：{names/}"},
    {"help.plan.cases",
     "Cases that may be chosen: {names/}. Cartons beside one that is made to measure, a hard case in its "
     "place",
     "選んでよいケース：{names/"
     "}。`cartons`（段ボール箱）は寸法に合わせて作るものと比べ、`hard-cases`"
     "（ハードケース）はその代わりに使います"},
    {"help.plan.seconds", "Seconds of work for each piece, where you have timed it",
     "1 個あたりの作業時間（秒）、計ったことがあるとき"},
    {"help.plan.json", "Print the proposals as JSON", "提案を JSON で表示します"},
};

}  // namespace

std::span<const Wording> words_of_plan() {
    return kWordsOfPlan;
}

}  // namespace snug

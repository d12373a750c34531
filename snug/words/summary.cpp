#include "snug/words/catalogue.h"

// What the command line says of a design that was made.

namespace snug {
namespace {

constexpr Wording kWordsOfSummary[] = {
    {"severity.danger", "DANGER", "危険"},
    {"severity.warning", "Warning", "警告"},
    {"severity.note", "Note", "参考"},
    {"summary.object", "Object", "対象物"},
    {"summary.named", "{name}: {what}", "{name}：{what}"},
    {"summary.mesh",
     "{vertices} {vertices|vertex|vertices}, {triangles} {triangles|triangle|triangles}, {size} mm, "
     "{closed}",
     "頂点 {vertices} 個、三角形 {triangles} 個、{size} mm、{closed}"},
    {"summary.cloud", "{points} {points|point|points}, {size} mm, a cloud",
     "点 {points} 個、{size} mm、点群"},
    {"summary.streamed", "{triangles} {triangles|triangle|triangles}, {size} mm, read in pieces",
     "三角形 {triangles} 個、{size} mm、分割して読み込み"},
    {"summary.closed", "closed", "閉じている"},
    {"summary.open", "open ({holes} {holes|hole|holes})", "開いている（穴 {holes} 個）"},
    {"summary.wound", "closed, but wound both ways", "閉じているが、面の向きが不揃い"},
    {"summary.space", "Space", "空間"},
    {"summary.blocks", "{blocks} blocks of {block} mm = {size} mm",
     "{block} mm のブロック {blocks} 個 = {size} mm"},
    {"summary.case", "Case", "ケース"},
    {"summary.case_of", "{name}{inside} inside, {play} mm of play on each side{lid}",
     "{name}内寸 {inside}、遊び 各面 {play} mm{lid}"},
    {"summary.lid", ", lid {mm} mm", "、ふた {mm} mm"},
    {"summary.fillers", "Fillers", "詰め物"},
    {"summary.filler", "{side}, {half}: {size}", "{side}、{half}：{size}"},
    {"wall.floor", "floor", "底"},
    {"wall.roof", "roof", "上"},
    {"wall.back", "back", "奥"},
    {"wall.front", "front", "手前"},
    {"wall.left", "left", "左"},
    {"wall.right", "right", "右"},
    {"summary.foam", "Foam", "フォーム"},
    {"summary.foam_of",
     "lower {lower} {lower|block|blocks}, lid {lid} {lid|block|blocks}, together {litres} litres; F {f}",
     "下 {lower} ブロック、ふた {lid} ブロック、合計 {litres} リットル、F {f}"},
    {"summary.foam_of_layers", "{pieces,}, together {litres} litres; F {f}",
     "{pieces,}、合計 {litres} リットル、F {f}"},
    {"summary.piece_of", "{foam} {blocks} {blocks|block|blocks}", "{foam} {blocks} ブロック"},
    {"summary.remove", "Remove", "切り取り"},
    {"summary.removed", "{blocks} {blocks|block|blocks} ({litres} litres)",
     "{blocks} ブロック（{litres} リットル）"},
    {"summary.parting", "Parting", "分割"},
    {"summary.parting_after", "after block {level} of {blocks}, counted from below",
     "下から {level} ブロック目の上（全 {blocks} ブロック）"},
    {"summary.walls", "Walls", "壁"},
    {"summary.walls_of",
     "floor {floor}, roof {roof}, back {back}, front {front}, left {left}, right {right} mm",
     "底 {floor}、上 {roof}、奥 {back}、手前 {front}、左 {left}、右 {right} mm"},
    {"summary.walls_of_tray", "floor {floor}, back {back}, front {front}, left {left}, right {right} mm",
     "底 {floor}、奥 {back}、手前 {front}、左 {left}、右 {right} mm"},
    {"summary.lift", "Lift slot", "持ち手"},
    {"summary.lift_at", "{piece}, {side}", "{piece}、{side}"},
    {"summary.notch", "Notch", "指かけ"},
    {"summary.notch_at", "{side} at {axis} = {at} mm, {deep} deep",
     "{side}、{axis} = {at} mm、深さ {deep} mm"},
    {"summary.gaps", "Gaps", "すきま"},
    {"summary.gap", "widest {widest} mm; {step} litres lost to the blocks' steps{undercut}",
     "最大 {widest} mm、段差で余分に切る量 {step} リットル{undercut}"},
    {"summary.undercut", ", {litres} litres to undercuts", "、陰になる部分 {litres} リットル"},
    {"summary.bears", "Bears", "載る面"},
    {"summary.bears_on",
     "below {below}, above {above} once it sank 1, 3, 5 mm{at_rest}. Drops were not checked",
     "1, 3, 5 mm 沈んだとき、下 {below}、上 {above}{at_rest}。落下は確かめていません。"},
    {"summary.bears_in_tray", "below {below} once it sank 1, 3, 5 mm{at_rest}",
     "1, 3, 5 mm 沈んだとき、下 {below}{at_rest}"},
    {"summary.at_rest", "; at rest {kpa} kPa", "、静止時の圧力 {kpa} kPa"},
    {"summary.creep", " of {kpa} kPa that the foam bears for long",
     "（このフォームが長く耐えるのは {kpa} kPa まで）"},
    {"summary.creep_unknown", " (what this foam bears for long is not known)",
     "（このフォームが長く耐える圧力は不明）"},
    {"summary.files", "Files", "ファイル"},
    {"summary.in_folder", "in {folder}: look at preview.svg first",
     "{folder} の中。まず preview.svg をご覧ください。"},
    {"summary.dry", "none are written: a dry run", "書き出していません（試し）"},
    {"summary.workshop", "For the workshop ({work}):", "作るもの（{work}）："},
};

}  // namespace

std::span<const Wording> words_of_summary() {
    return kWordsOfSummary;
}

}  // namespace snug

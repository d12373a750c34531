#include "snug/words/catalogue.h"

// The preview: its legend, caption and maps of the gap.

namespace snug {
namespace {

constexpr Wording kWordsOfPreview[] = {
    {"mark.lower", "LOWER", "下（LOWER）"},
    {"mark.middle", "MIDDLE {number}", "中間 {number}（MIDDLE {number}）"},
    {"mark.middle_from_above", "MIDDLE {number}, from above", "中間 {number}（MIDDLE {number}）上から"},
    {"mark.middle_from_below", "MIDDLE {number}, from below", "中間 {number}（MIDDLE {number}）下から"},
    {"mark.lid", "LID", "ふた（LID）"},
    {"mark.back", "BACK", "奥（BACK）"},
    {"preview.caption",
     "{name} · {blocks} blocks of {block} mm · thinnest wall {wall} mm · foam {litres} litres",
     "{name} · {block} mm のブロック {blocks} 個 · 最も薄い壁 {wall} mm · 緩衝材 {litres} リットル"},
    {"preview.lower", "foam, seen into its cavity", "くぼみを上にして置いた緩衝材"},
    {"preview.middle", "seen from both sides", "両側から見たところ"},
    {"preview.lid", "turned over its BACK edge", "奥（BACK）の縁を軸に裏返したところ"},
    {"preview.object", "OBJECT", "対象物"},
    {"preview.object_lies", "as it lies in the lower foam", "下の緩衝材に収まる位置"},
    {"preview.closed", "closed: {size} mm (x, y, z)", "閉じたとき：{size} mm（x, y, z）"},
    {"preview.tray", "tray: {size} mm (x, y, z)", "トレイ：{size} mm（x, y, z）"},
    {"gap.lower", "Gap of the LOWER foam{ring}", "下（LOWER）のすきま{ring}"},
    {"gap.middle", "Gap of {piece}{ring}", "{piece}のすきま{ring}"},
    {"gap.lid", "Gap of the LID{ring}", "ふた（LID）のすきま{ring}"},
    {"gap.ring", " · the ring: a ball of {mm} mm fits in", " · 丸印：直径 {mm} mm の球が入ります"},
    {"gap.steps", "0 to {mm} mm deep where blocks are larger than the object",
     "深さ 0～{mm} mm：ブロックの段差によるすきま"},
    {"gap.undercut", "0 to {mm} mm deep where it is undercut", "深さ 0～{mm} mm：陰になる所のすきま"},
    {"gap.undercut_unknown", "Undercuts are unknown: the object is open",
     "陰になる所は不明です：対象物が閉じていません"},
};

}  // namespace

std::span<const Wording> words_of_preview() {
    return kWordsOfPreview;
}

}  // namespace snug

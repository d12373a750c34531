#include "snug/words/catalogue.h"

// Places on an item that foam keeps away from.

namespace snug {
namespace {

constexpr Wording kWordsOfZones[] = {
    {"takes.zones", "a place and mm to keep off, such as {example} or {other} (X,Y,Z,R of the file, then mm)",
     "場所と離す距離（mm）、たとえば {example} または {other}（ファイルの X,Y,Z,R、続けて mm）"},
    {"json.zones",
     "a list of zones, each with balls as [x, y, z, r] or a part, keep_off_mm, press_kpa or loose",
     "場所のリスト（それぞれ球 [x, y, z, r] か部品番号と、離す距離か耐える圧力）"},
    {"zone_reached",
     "from {cm} cm {fallen} zone {zone} would be reached: the item travels up to {travel} mm, and {room} mm "
     "are free "
     "there. Keep {mm} mm off it or more, so that {least} mm stay free, and look again: less foam then "
     "carries the item, "
     "which may travel farther",
     "{cm} cm から{fallen}を下に落とすと、場所 {zone} に届きます。最大 {travel} mm 動きますが、空きは {room} "
     "mm です。"
     "{least} mm 残すには {mm} mm "
     "以上離し、もう一度確かめてください。支える緩衝材が減り、さらに動くことがあります"},
    {"zone_pressed",
     "foam would press on zone {zone} with up to {kpa} kPa, as a mean over 1 cm2; it bears {asked} kPa. Keep "
     "foam off it, or take a softer foam; ridges see more",
     "緩衝材が場所 {zone} を最大 {kpa} kPa（1 cm2 の平均）で押します。耐える圧力は {asked} kPa "
     "です。緩衝材を離すか、柔らかい緩衝材にしてください。突起にはそれ以上の圧力がかかります"},
    {"zone_free",
     "zones that foam keeps away from stand free. Free is not protected: what such a part meets through its "
     "own "
     "inertia is not computed",
     "離しておく場所は宙に浮いています。それは保護されているという意味ではなく、その場所自身の慣性による力は"
     "計算していません"},
    {"zone.told", "{parts;}", "{parts;}"},
    {"zone.kept_off", "kept off by {mm} mm, {blocks} {blocks|block|blocks} cut for it{left}",
     "{mm} mm 離す（そのために {blocks} ブロック切る）{left}"},
    {"zone.left", ", and {mm} mm stay free in a drop {fallen}", "、{fallen}を下に落としても {mm} mm 残る"},
    {"zone.left_unknown", ", and what stays free {fallen,} is not known",
     "、{fallen,}を下に落としたときの残りは不明"},
    {"zone.pressed", "pressed with {kpa} kPa at most, of {asked} kPa that it bears",
     "最大 {kpa} kPa で押される（耐える圧力 {asked} kPa）"},
    {"zone.press_unknown", "bears {asked} kPa; what foam presses with is not known",
     "耐える圧力 {asked} kPa（緩衝材の押す圧力は不明）"},
    {"zone.loose", "loose: nothing may touch it", "剝がれやすいため、触れてはならない"},
    {"summary.zone", "Zone {zone}", "場所 {zone}"},
    {"packing.zones", "Places to keep off", "触れない場所"},
    {"packing.zones_claim",
     "Free is not protected: what such a part meets through its own inertia is not computed.",
     "空いていることは、保護されていることではありません。その場所自身の慣性による力は計算していません。"},
    {"zone.numbered", "zone {zone}: {why}", "場所 {zone}：{why}"},
    {"zone.no_place", "zone {zone} must have a place: a part from 1 upward, or balls such as {example}",
     "場所 {zone} には、1 以上の部品番号か {example} のような球が必要です"},
    {"zone.many", "there may be {most} zones on an item at most",
     "一つのものに置ける場所は {most} 個までです"},
    {"zone.many_balls", "zone {zone} may have {most} balls at most: paint with a larger brush",
     "場所 {zone} の球は {most} 個までです。大きなブラシで塗ってください"},
    {"zone.ball", "a ball of zone {zone} must have a radius above 0, and lie within 100,000 km",
     "場所 {zone} の球は、半径が 0 より大きく、10 万キロメートル以内になければなりません"},
    {"zone.keep_off", "zone {zone} must be kept off by 0 to {most} mm",
     "場所 {zone} から離す距離は 0～{most} mm でなければなりません"},
    {"zone.press", "what zone {zone} bears must be above 0 kPa",
     "場所 {zone} が耐える圧力は 0 kPa より大きくなければなりません"},
    {"zone.loose_pressed",
     "zone {zone} is loose, so nothing may press on it: keep foam off it, without a pressure",
     "場所 {zone} は剝がれやすいため、押してはなりません。圧力を指定せず、緩衝材を離してください"},
    {"zone.no_rule", "zone {zone} says neither how far foam keeps off nor what it bears: add mm",
     "場所 {zone} に、離す距離も耐える圧力もありません"},
    {"zone.no_surface",
     "no surface lies in it. Its place counts in the file's coordinates in mm, where the object reaches from "
     "{from} to {to}",
     "この場所に表面がありません。位置はファイルの座標（mm）で、対象物は {from} から {to} までにあります"},
    {"zone.all", "the whole object lies in it, so nothing could carry it: make it smaller",
     "対象物全体が入っており、支える所がありません。小さくしてください"},
    {"zone.no_part", "there is no part {part}; the object has {parts} {parts|part|parts}, the largest is 1",
     "部品 {part} はありません。対象物の部品は {parts} 個で、最大のものが 1 です"},
    {"zone.parts_unknown",
     "of clouds, and of what is read in pieces, the parts are not known: give a place as X,Y,Z,R",
     "点群や分割して読むファイルでは部品が分かりません。場所を座標と半径で指定してください"},
};

}  // namespace

std::span<const Wording> words_of_zones() {
    return kWordsOfZones;
}

}  // namespace snug

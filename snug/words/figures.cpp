#include "snug/words/catalogue.h"

// Figures of a pack, as lines under its heading.

namespace snug {
namespace {

constexpr Wording kWordsOfFigures[] = {
    {"figure.none", "none", "なし"},
    {"figure.litres", "{litres} litres", "{litres} リットル"},
    {"figure.material", "Material", "材料の量"},
    {"figure.weight", "Weight of the foams", "フォームの重さ"},
    {"figure.no_density", "not known: the preset names no density", "不明：フォームの密度がわかりません"},
    {"figure.cost", "Cost", "費用"},
    {"figure.cost_of", "{cost} at {price} a litre", "{cost}（1 リットル {price}）"},
    {"figure.cost_of/copies", "{cost} for {copies} copies at {price} a litre, {each} each",
     "{copies} 組で {cost}（1 リットル {price}）、1 組あたり {each}"},
    {"figure.no_price", "not known without the price of a litre", "リットル単価がないため不明"},
    {"figure.pluck_lower", "Blocks to pluck, lower", "抜くブロック（下）"},
    {"figure.pluck_middle", "Blocks to pluck, middle {number}", "抜くブロック（中間 {number}）"},
    {"figure.pluck_lid", "Blocks to pluck, lid", "抜くブロック（ふた）"},
    {"figure.nothing_to_pluck", "none ({layers} {layers|layer|layers})", "なし（{layers} 層）"},
    {"figure.blocks_of_layers", "{blocks} of {layers} {layers|layer|layers}",
     "{layers} 層のうち {blocks} ブロック"},
    {"figure.maps", "Maps at true size", "原寸の図"},
    {"figure.maps_on_pages", "{maps} on {pages} pages of {paper}", "{maps} 枚、{paper} で {pages} ページ"},
    {"figure.sheets", "Sheets", "シート"},
    {"figure.sheets_of", "{sheets} of {mm} mm", "{mm} mm を {sheets} 枚"},
    {"figure.pieces", "Pieces", "部品"},
    {"figure.stock", "Stock", "材料のシート"},
    {"figure.stock_of", "{sheets} {sheets|sheet|sheets} of {size} mm", "{size} mm を {sheets} 枚"},
    {"figure.stock_of/colors", "{sheets} of the first colour, {others} of the second, of {size} mm",
     "{size} mm を一色目 {sheets} 枚、二色目 {others} 枚"},
    {"figure.foam_in_pieces", "Foam in the pieces", "部品のフォーム"},
    {"figure.foam_of_stock", "{litres} litres, {percent} % of the stock",
     "{litres} リットル、材料の {percent} %"},
    {"figure.cutting", "Cutting", "切断の長さ"},
    {"figure.parts_lower", "Parts, lower", "部品（下）"},
    {"figure.parts_middle", "Parts, middle {number}", "部品（中間 {number}）"},
    {"figure.parts_lid", "Parts, lid", "部品（ふた）"},
    {"figure.dowels", "Dowels", "ダボ"},
    {"figure.dowels_of", "{dowels} of {diameter_mm} x {length_mm} mm",
     "{diameter_mm} x {length_mm} mm を {dowels} 本"},
    {"figure.beds", "Beds to print", "印刷の回数"},
    {"figure.fit_test", "Fit test", "はめ合わせの試験片"},
    {"figure.flat_parts", "{parts} {parts|flat part|flat parts}, layer {layer} from below",
     "平らな部品 {parts} 個、下から {layer} 層目"},
    {"figure.plastic", "Plastic, printed solid", "樹脂の量（中実）"},
    {"figure.pour_lower", "To pour, lower", "注ぐ量（下）"},
    {"figure.pour_lid", "To pour, lid", "注ぐ量（ふた）"},
    {"figure.stock_lower", "Stock, lower", "材料（下）"},
    {"figure.stock_middle", "Stock, middle {number}", "材料（中間 {number}）"},
    {"figure.stock_lid", "Stock, lid", "材料（ふた）"},
    {"figure.deepest_pocket", "Deepest pocket", "最も深いくぼみ"},
    {"figure.passes", "Passes", "切削の段数"},
    {"figure.way_of_cutter", "Way of the cutter", "刃の移動距離"},
    {"figure.time", "Time at these feeds", "この送りでの時間"},
    {"figure.minutes", "about {minutes} minutes", "約 {minutes} 分"},
    {"figure.corners", "Extra gap in corners", "角の余分なすきま"},
    {"figure.corner_gap", "up to {widest_mm} mm wide, {taken_cm3} cm3 together",
     "幅最大 {widest_mm} mm、合わせて {taken_cm3} cm3"},
    {"figure.bricks_lower", "Bricks, lower", "ブロック（下）"},
    {"figure.bricks_lid", "Bricks, lid", "ブロック（ふた）"},
    {"figure.bricks_in_pieces", "{bricks} in {pieces} {pieces|piece|pieces}",
     "{bricks} 個、つながりは {pieces} 個"},
    {"figure.kinds", "Kinds of pieces", "部品の種類"},
    {"figure.lower_standing", "Lower half, standing", "下、置いたとき"},
    {"figure.lower_lifted", "Lower half, lifted by its rim", "下、縁で持ち上げたとき"},
    {"figure.lower_turned", "Lower half, cavity down on its rim", "下、縁で伏せたとき"},
    {"figure.lid_standing", "Lid, standing", "ふた、置いたとき"},
    {"figure.lid_lifted", "Lid, lifted by its rim", "ふた、縁で持ち上げたとき"},
    {"figure.lid_turned", "Lid, cavity down on its rim", "ふた、縁で伏せたとき"},
    {"figure.holds_by_itself", "holds without any grip", "保持力なしで持ちます"},
    {"figure.holds", "holds, with {percent} of the studs' grip", "持ちます（ポッチの保持力の {percent}）"},
    {"figure.holds_at_most", "holds, with at most {percent} of the studs' grip",
     "持ちます（ポッチの保持力の {percent} 以下）"},
    {"figure.overloaded", "asks for {percent} of the studs' grip", "ポッチの保持力の {percent} が必要です"},
    {"figure.loose", "{bricks} {bricks|brick falls|bricks fall} out", "ブロックが {bricks} 個外れます"},
    {"figure.falls", "tips over or falls apart", "倒れるか崩れます"},
    {"figure.not_checked", "not checked", "未確認"},
};

}  // namespace

std::span<const Wording> words_of_figures() {
    return kWordsOfFigures;
}

}  // namespace snug

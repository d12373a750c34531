#pragma once

#include <optional>
#include <string>

#include "snug/base/vec2.h"
#include "snug/design/option.h"

namespace snug {

/// Foam cut into sheets that are glued on each other. Lengths in mm.
struct SheetOptions {
    std::optional<double> thickness_mm;  ///< of a sheet; none: a block's depth along x
    Vec2d stock_mm{1000, 600};           ///< a sheet of stock as it is sold, either way round
    double margin_mm = 5;                ///< left uncut along the edges of the stock, 0 or more
    double spacing_mm = 3;               ///< between two cuts of different pieces, 0 or more
    double kerf_mm = 0;                  ///< width that a cut takes away; 0: the cutter makes up for it
    double dowel_mm = 6;                 ///< diameter
    int dowels = 3;                      ///< holes in a half's sheets: 0, or 2 to 8
    double dowel_edge_mm = 6;            ///< least foam between a dowel hole and an edge
    /// From a cavity to the slit that a liner's edges are tucked into; 0: none
    double liner_slit_mm = 0;
    int copies = 1;             ///< so many cases are fitted out alike, from common stock
    bool second_color = false;  ///< the uppermost sheet of a piece is of another colour than those below
    bool svg = true;
    bool dxf = true;
    friend bool operator==(const SheetOptions&, const SheetOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, SheetOptions& sheets) {
    constexpr Range kLength{0, 1e5};
    visit.option(sheets.thickness_mm, {.json = "thickness_mm",
                                       .flag = "--sheet",
                                       .takes = "MM",
                                       .unit = "mm",
                                       .range = {0.1, 1e5},
                                       .step = 0.5,
                                       .label = {"a sheet's thickness", "シートの厚さ"},
                                       .help = {"Sheets: their thickness", "シート：厚さ"},
                                       .usual = {"a block's depth", "ブロックの深さ"}});
    visit.option(sheets.stock_mm,
                 {.json = "stock_mm",
                  .flag = "--stock",
                  .takes = "LxW",
                  .unit = "mm",
                  .range = {1, 1e5},
                  .step = 10,
                  .label = {"a side of the stock", "材料の辺"},
                  .help = {"Sheets: size of a sheet as it is sold", "シート：販売されている大きさ"}});
    visit.option(sheets.margin_mm, {.json = "margin_mm",
                                    .flag = "--sheet-margin",
                                    .takes = "MM",
                                    .unit = "mm",
                                    .range = kLength,
                                    .step = 1,
                                    .label = {"the stock's margin", "材料の余白"},
                                    .help = {"Sheets: margin left uncut along the edges of the stock",
                                             "シート：材料の縁に切らずに残す幅"}});
    visit.option(sheets.spacing_mm, {.json = "spacing_mm",
                                     .flag = "--sheet-spacing",
                                     .takes = "MM",
                                     .unit = "mm",
                                     .range = kLength,
                                     .step = 0.5,
                                     .label = {"the spacing between pieces", "部品の間隔"},
                                     .help = {"Sheets: least distance between cuts of different pieces",
                                              "シート：別の部品の切り線どうしの最小の間隔"}});
    visit.option(sheets.kerf_mm,
                 {.json = "kerf_mm",
                  .flag = "--kerf",
                  .takes = "MM",
                  .unit = "mm",
                  .range = kLength,
                  .step = 0.05,
                  .label = {"the kerf (lasers take 0.1 to 0.3 mm; 0: the cutter makes up for it)",
                            "切り幅（レーザーは 0.1～0.3 mm、カッターが補正するなら 0）"},
                  .help = {"Sheets: width that a cut takes away", "シート：切断で失われる幅"}});
    visit.option(sheets.dowel_mm, {.json = "dowel_mm",
                                   .flag = "--dowel",
                                   .unit = "mm",
                                   .range = {.least = 0.5, .most = 1000, .or_zero = true},
                                   .step = 0.5,
                                   .label = {"a dowel's diameter", "ダボの直径"},
                                   .help = {"Diameter of the dowels that hold sheets in place",
                                            "シートの位置を決めるダボの直径"}});
    visit.option(
        sheets.dowels,
        {.json = "dowels",
         .flag = "--dowels",
         .takes = "N",
         .range = {.least = 2, .most = 8, .or_zero = true},
         .step = 1,
         .label = {"the number of dowels in a half's sheets", "片側のシートのダボの数"},
         .help = {"Sheets: how many dowels a half has; 0: none", "シート：片側のダボの数。0 ならなし"}});
    visit.option(sheets.dowel_edge_mm,
                 {.json = "dowel_edge_mm",
                  .flag = "--dowel-edge",
                  .takes = "MM",
                  .unit = "mm",
                  .range = kLength,
                  .step = 0.5,
                  .label = {"the foam between a dowel hole and an edge", "ダボの穴と縁の間の緩衝材"},
                  .help = {"Sheets: least foam between a dowel hole and an edge",
                           "シート：ダボの穴と縁の間に残す緩衝材の最小の幅"}});
    visit.option(
        sheets.liner_slit_mm,
        {.json = "liner_slit_mm",
         .flag = "--liner-slit",
         .takes = "MM",
         .unit = "mm",
         .range = {.least = 10, .most = 1000, .or_zero = true},
         .step = 1,
         .often = 50,
         .label = {"the liner's slit", "内張り用の切れ目"},
         .help = {"Sheets: so far from each cavity a blind slit that the edges of a liner are tucked into",
                  "シート：内張りの端を差し込む切れ目（貫通させない）の、くぼみからの距離"},
         .usual = {"0: none", "0：なし"}});
    visit.option(sheets.copies, {.json = "copies",
                                 .flag = "--copies",
                                 .takes = "N",
                                 .range = {1, 1000},
                                 .step = 1,
                                 .often = 100,
                                 .label = {"the number of copies", "組数"},
                                 .help = {"Sheets: so many times the same foam, cut from common stock",
                                          "シート：同じ緩衝材を何組作るか。材料はまとめて切り出します"}});
    visit.option(
        sheets.second_color,
        {.json = "second_color",
         .flag = "--second-color",
         .label = {"the second colour", "二色目"},
         .help = {"Sheets: the uppermost sheet in another colour than those below it, so that an empty "
                  "place is seen",
                  "シート：いちばん上のシートだけ色を変え、空いている場所が目立つようにします"}});
    visit.option(sheets.svg,
                 {.json = "svg",
                  .label = {"SVG", "SVG の書き出し"},
                  .help = {"Whether sheets are written as SVG", "シートを SVG で書き出すかどうか"}});
    visit.option(sheets.dxf,
                 {.json = "dxf",
                  .label = {"DXF", "DXF の書き出し"},
                  .help = {"Whether sheets are written as DXF", "シートを DXF で書き出すかどうか"}});
}

/// Of a sheet of a foam whose blocks are so deep along x.
[[nodiscard]] double wanted_thickness_mm(const SheetOptions& options, double block_depth_mm);

/// What is out of range whatever the foam is; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const SheetOptions& options);

}  // namespace snug

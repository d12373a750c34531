#pragma once

#include "snug/design/option.h"

namespace snug {

/// Printed boxes to pour foam or silicone into. The printer's bed and dowels are those of PrintOptions.
struct MouldOptions {
    double wall_mm = 3;    ///< of the box's walls and floor, 0.4 to 100
    double rim_mm = 5;     ///< by which the walls stand above what is poured, 0 to 200
    double draft_deg = 2;  ///< by which upright faces lean so that the foam lets go, 0 to 15
    friend bool operator==(const MouldOptions&, const MouldOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, MouldOptions& mould) {
    visit.option(mould.wall_mm, {.json = "wall_mm",
                                 .flag = "--mould-wall",
                                 .takes = "MM",
                                 .unit = "mm",
                                 .range = {0.4, 100},
                                 .step = 0.5,
                                 .label = {"the mould's wall", "型の壁"},
                                 .help = {"Mould: thickness of walls and floor", "型：壁と底の厚さ"}});
    visit.option(mould.rim_mm, {.json = "rim_mm",
                                .flag = "--mould-rim",
                                .takes = "MM",
                                .unit = "mm",
                                .range = {0, 200},
                                .step = 1,
                                .label = {"the mould's rim", "型の縁"},
                                .help = {"Mould: height of the walls above what is poured",
                                         "型：流し込む面より上に立つ壁の高さ"}});
    visit.option(mould.draft_deg, {.json = "draft_deg",
                                   .flag = "--draft",
                                   .takes = "DEGREES",
                                   .unit = {"degrees", "度"},
                                   .range = {0, 15},
                                   .step = 0.5,
                                   .label = {"the mould's draft", "型の抜き勾配"},
                                   .help = {"Mould: lean of upright faces, so that the foam lets go",
                                            "型：緩衝材が抜けるように立ち面に付ける傾き"}});
}

}  // namespace snug

#pragma once

#include <optional>
#include <string>

#include "snug/base/vec.h"
#include "snug/design/option.h"

namespace snug {

struct PrintOptions {
    Vec3d bed_mm{250, 210, 210};       ///< of the printer: to the right, to the back, upwards; 10 to 2000
    bool dowels = true;                ///< hold the parts of a half together that is larger than the bed
    double dowel_diameter_mm = 6;      ///< 1 to 100
    double dowel_length_mm = 24;       ///< from its diameter to 1000
    double joint_clearance_mm = 0.15;  ///< left around a dowel on every side, 0 to 5
    bool rigid = true;                 ///< the material holds, but does not cushion
    friend bool operator==(const PrintOptions&, const PrintOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, PrintOptions& print) {
    visit.option(print.bed_mm, {.json = "bed_mm",
                                .flag = "--bed",
                                .takes = "XxYxZ",
                                .unit = "mm",
                                .range = {10, 2000},
                                .step = 10,
                                .label = {"the bed's width, depth or height", "造形範囲の横、奥または高さ"},
                                .help = {"Print, mould: the printer's bed, and how high it prints",
                                         "3D プリント・型：プリンターの造形範囲と高さ"}});
    visit.option(print.dowels,
                 {.json = "dowels",
                  .flag = "--dowel",
                  .label = {"the print's dowels", "3D プリントのダボ"},
                  .help = {"Whether dowels hold the parts of a half that is larger than the bed",
                           "造形範囲より大きい半分の部品をダボでつなぐかどうか"}});
    visit.option(print.dowel_diameter_mm,
                 {.json = "dowel_diameter_mm",
                  .flag = "--dowel",
                  .unit = "mm",
                  .range = {1, 100},
                  .step = 0.5,
                  .label = {"the dowel's diameter", "ダボの直径"},
                  .help = {"Diameter of the dowels of prints and moulds", "3D プリントと型のダボの直径"}});
    visit.option(print.dowel_length_mm,
                 {.json = "dowel_length_mm",
                  .flag = "--dowel-length",
                  .takes = "MM",
                  .unit = "mm",
                  .range = {1, 1000},
                  .step = 1,
                  .label = {"the dowel's length", "ダボの長さ"},
                  .help = {"Print, mould: length of the dowels, at least their diameter",
                           "3D プリント・型：ダボの長さ（直径以上）"}});
    visit.option(print.joint_clearance_mm,
                 {.json = "joint_clearance_mm",
                  .flag = "--dowel-clearance",
                  .takes = "MM",
                  .unit = "mm",
                  .range = {0, 5},
                  .step = 0.05,
                  .label = {"the clearance around a dowel", "ダボのまわりのクリアランス"},
                  .help = {"Print, mould: room left around a dowel on every side",
                           "3D プリント・型：ダボのまわりに残すクリアランス"}});
}

/// What is out of range; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const PrintOptions& options);

}  // namespace snug

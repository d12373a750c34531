#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "snug/design/option.h"

namespace snug {

/// What of a raw scan is no part of the object. Nothing is dropped without a finding that says so.
struct CleanOptions {
    /// Numbers of separate parts as `snug inspect` lists them, from 1, the largest first.
    std::vector<int> drop_parts;
    double drop_below_mm = 0;  ///< parts whose longest side is shorter; 0: none
    /// A plinth or table: what lies behind the plane is cut off, and the cut closed. The first three numbers
    /// point to what is kept, the fourth is how far along them the plane lies from the file's origin, in mm.
    std::optional<std::array<double, 4>> cut_plane;
    friend bool operator==(const CleanOptions&, const CleanOptions&) = default;

    [[nodiscard]] bool none() const { return drop_parts.empty() && drop_below_mm == 0 && !cut_plane; }
};

template <class Visit>
void visit_options(Visit& visit, CleanOptions& clean) {
    visit.option(clean.drop_parts, {.json = "drop_parts",
                                    .flag = "--drop",
                                    .takes = "2,5-9",
                                    .range = {1, 2147483647},
                                    .label = {"the number of a part", "部品の番号"},
                                    .help = {"Leave out separate parts, by their numbers in `snug inspect`",
                                             "離れた部品を、`snug inspect` の番号で除きます"},
                                    .scope = Scope::object});
    visit.option(
        clean.drop_below_mm,
        {.json = "drop_below_mm",
         .flag = "--drop-below",
         .takes = "MM",
         .unit = "mm",
         .range = {0, 1e6},
         .step = 0.5,
         .label = {"the size below which parts are dropped", "除く部品の大きさ"},
         .help = {"Leave out separate parts that are shorter than this", "これより短い離れた部品を除きます"},
         .usual = {"0: none", "0：なし"},
         .scope = Scope::object});
    visit.option(
        clean.cut_plane,
        {.json = "cut_plane",
         .flag = "--cut-plane",
         .takes = "X,Y,Z,MM",
         .label = {"the cutting plane", "切断面"},
         .help = {"Cut off what lies behind a plane, such as a table: the direction to keep, and how "
                  "far the plane lies along it (0,0,1,12 keeps what is above z = 12 mm)",
                  "机などの平面より裏側を切り落とします：残す方向と、その方向での平面までの距離（0,0,1,12 "
                  "なら z = 12 mm より上を残します）"},
         .separator = ',',
         .scope = Scope::object});
}

/// What is out of range; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const CleanOptions& options);

}  // namespace snug

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/base/vec.h"
#include "snug/design/option.h"

// The case that the foam is made for. Its height runs along x, its width along y and its length along z, as
// the foam lies in it: floor at -x, lid at +x, BACK at -y.

namespace snug {

/// How a material may be divided. What has a fixed pitch leaves a rest in a case.
enum class Division {
    none,    ///< blocks of one size: slit sponge, cubes, bricks
    across,  ///< sheets of a fixed thickness (x), cut to any contour in y and z
    all,     ///< printed, milled or moulded to any size
};

template <>
struct Names<Division> {
    static constexpr std::string_view list[] = {"none", "across", "all"};
};

/// Width (y) and length (z) of a cross-section, mm.
struct CrossSection {
    double width = 0;
    double length = 0;
    friend bool operator==(const CrossSection&, const CrossSection&) = default;
};

struct CaseOptions {
    std::string name;                      ///< of a case in the list (cases.h), for people; may be empty
    std::optional<Vec3d> inside_mm;        ///< height, width, length inside; none: the design space is free
    double play_mm = 3;                    ///< air on each of the six sides, 0 or more
    std::optional<double> lid_mm;          ///< of the inside height, what belongs to the lid; none: not known
    double corner_radius_mm = 0;           ///< of the four upright edges
    std::optional<CrossSection> base_mm;   ///< inside at the floor, where the walls lean; none: upright
    std::optional<CrossSection> top_mm;    ///< inside at the roof of the lid; none: upright
    std::optional<double> divisor = 5000;  ///< cm3 for one kg of volumetric weight; none: a flat rate
    Division division = Division::none;    ///< of the material, as its preset says
    friend bool operator==(const CaseOptions&, const CaseOptions&) = default;
};

/// --case with sizes, "425x284x155:45"; names are for who knows the cases (flags.h).
[[nodiscard]] SharedFlag<CaseOptions> case_size_flag();

template <class Visit>
void visit_options(Visit& visit, CaseOptions& options) {
    constexpr Range kCase{0, 20000};
    visit.option(options.name, {.json = "name",
                                .flag = "--case",
                                .label = {"the case's name", "ケースの名前"},
                                .help = {"Name of the case in `snug cases`, for people",
                                         "`snug cases` にあるケースの名前（表示用）"}});
    visit.option(options.inside_mm,
                 {.json = "inside_mm",
                  .flag = "--case",
                  .unit = "mm",
                  .range = {1, 20000},
                  .step = 1,
                  .label = {"a side of the case's inside", "ケースの内寸"},
                  .help = {"Height, width and length inside the case", "ケースの内側の高さ、幅、長さ"}});
    visit.flag(options, case_size_flag());
    visit.option(options.play_mm,
                 {.json = "play_mm",
                  .flag = "--case-play",
                  .takes = "MM",
                  .unit = "mm",
                  .range = kCase,
                  .step = 0.5,
                  .label = {"the play", "遊び"},
                  .help = {"Air between foam and case on each side", "緩衝材とケースの間の遊び（各面）"}});
    visit.option(options.lid_mm, {.json = "lid_mm",
                                  .flag = "--case",
                                  .unit = "mm",
                                  .range = kCase,
                                  .step = 1,
                                  .label = {"the lid's height", "ふたの高さ"},
                                  .help = {"How much of the height inside belongs to the lid",
                                           "内側の高さのうち、ふたの分"}});
    visit.option(options.corner_radius_mm,
                 {.json = "corner_radius_mm",
                  .flag = "--case-radius",
                  .takes = "MM",
                  .unit = "mm",
                  .range = kCase,
                  .step = 1,
                  .label = {"the corner radius", "角の半径"},
                  .help = {"Radius of the case's upright edges", "ケースの縦の角の半径"}});
    visit.option(options.base_mm, {.json = "base_mm",
                                   .flag = "--case-base",
                                   .takes = "LxW",
                                   .unit = "mm",
                                   .range = kCase,
                                   .step = 1,
                                   .label = {"a side of the case's floor", "ケースの底の寸法"},
                                   .help = {"Length and width inside at the floor, where the walls lean",
                                            "壁が傾いているときの、底での内側の長さと幅"}});
    visit.option(options.top_mm,
                 {.json = "top_mm",
                  .flag = "--case-top",
                  .takes = "LxW",
                  .unit = "mm",
                  .range = kCase,
                  .step = 1,
                  .label = {"a side of the case's roof", "ケースの上面の寸法"},
                  .help = {"Length and width inside at the roof of the lid, where its walls lean",
                           "ふたの壁が傾いているときの、上面での内側の長さと幅"}});
    visit.option(options.divisor, {.json = "divisor",
                                   .flag = "--case-divisor",
                                   .takes = "CM3",
                                   .unit = "cm3",
                                   .range = {1, 1e6},
                                   .step = 100,
                                   .label = {"the divisor of the volumetric weight", "容積重量の除数"},
                                   .help = {"cm3 for one kg of volumetric weight; none: a flat rate",
                                            "容積重量 1 kg あたりの cm3。none なら一律料金"}});
    visit.option(options.division, {.json = "division",
                                    .label = {"the division", "緩衝材の分割の可否"},
                                    .help = {"How the foam may be divided to fill a case",
                                             "ケースを満たすために緩衝材をどこで切り分けてよいか"},
                                    .usual = {"the preset's", "選んだ緩衝材の値"}});
}

/// What is out of range: sizes that are not above the play, a lid as high as the case, corners
/// rounder than the case is wide, a case that widens away from the parting line.
[[nodiscard]] std::optional<OptionProblem> problem_of(const CaseOptions& options);

}  // namespace snug

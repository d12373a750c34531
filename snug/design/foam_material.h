#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec2.h"
#include "snug/design/option.h"
#include "snug/design/stress_curve.h"

namespace snug {

/// Where a foam's figures are from.
enum class FoamStatus { measured, makers_sheet, model, unverified };
template <>
struct Names<FoamStatus> {
    static constexpr std::string_view list[] = {"measured", "maker's sheet", "model", "unverified"};
};

/// One named product, and what is known of it. What nobody has published of it stays empty.
struct FoamMaterial {
    std::string name;   ///< what --foam takes
    std::string title;  ///< one line for people
    /// How it pushes back, in compression through its thickness; empty: not known, so no shock is estimated.
    std::vector<StressPoint> curve;
    std::optional<double> density_kg_m3;
    std::optional<Vec2d> thickness_mm;  ///< least and greatest that the curve was measured at
    std::optional<double> creep_kpa;    ///< pressure that it bears for long
    /// Of a curve from drops, how many fell on the same foam; none: it was pressed slowly.
    std::optional<int> impacts;
    FoamStatus status = FoamStatus::unverified;
    std::string source;
    friend bool operator==(const FoamMaterial&, const FoamMaterial&) = default;

    /// Whether its curve is from drops.
    [[nodiscard]] bool dynamic() const { return impacts.has_value(); }
    /// Pads below this do not follow the curve: the least that it was measured at, or 25 mm (Clemson thesis
    /// 839).
    [[nodiscard]] double least_thickness_mm() const { return thickness_mm ? thickness_mm->x : 25; }
};

template <class Visit>
void visit_options(Visit& visit, FoamMaterial& foam) {
    visit.option(foam.name, {.json = "name",
                             .flag = "--foam",
                             .takes = "NAME",
                             .label = {"the foam's data", "緩衝材のデータ"},
                             .help = {"A foam that `snug foams` lists: how it pushes back in a drop",
                                      "`snug foams` にある緩衝材：落下のときの押し返し方が決まります"}});
    visit.option(foam.title, {.json = "title",
                              .label = {"the foam's title", "緩衝材の説明"},
                              .help = {"What it is, in one line", "緩衝材の一行の説明"}});
    visit.option(foam.curve, {.json = "curve",
                              .unit = "kPa",
                              .label = {"the stress-strain curve", "応力ひずみ曲線"},
                              .help = {"Strain and the stress at it, straight lines between them",
                                       "ひずみとそのときの応力。間は直線で結びます"}});
    visit.option(foam.density_kg_m3, {.json = "density_kg_m3",
                                      .unit = "kg/m3",
                                      .range = kAbove0,
                                      .label = {"the foam's density", "緩衝材の密度"},
                                      .help = {"Its density", "密度"}});
    visit.option(foam.thickness_mm, {.json = "thickness_mm",
                                     .unit = "mm",
                                     .range = {.least = 0, .most = 10000, .above = true},
                                     .label = {"the thickness that was tested", "試験した厚さ"},
                                     .help = {"Least and greatest thickness that the curve was measured at",
                                              "曲線を測定した厚さの最小と最大"}});
    visit.option(foam.creep_kpa,
                 {.json = "creep_kpa",
                  .unit = "kPa",
                  .range = {.least = 0, .most = 1e6, .above = true},
                  .label = {"the pressure that the foam bears for long", "緩衝材が長く耐える圧力"},
                  .help = {"Pressure that it bears for long", "長く耐える圧力"}});
    visit.option(foam.impacts, {.json = "impacts",
                                .range = {1, 1000},
                                .label = {"the number of drops", "落下の回数"},
                                .help = {"How many drops on the same foam the curve is of",
                                         "同じ緩衝材への何回の落下による曲線か"},
                                .usual = {"pressed slowly", "ゆっくり押した"}});
    visit.option(foam.status, {.json = "status",
                               .label = {"where the data are from", "データの種類"},
                               .help = {"Where the figures are from", "数値の由来"}});
    visit.option(foam.source, {.json = "source",
                               .label = {"the source", "出典"},
                               .help = {"Who published the figures", "数値の出典"}});
}

/// What is wrong with it; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const FoamMaterial& foam);

}  // namespace snug

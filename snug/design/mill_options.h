#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/design/option.h"

namespace snug {

/// Where the program's X0 Y0 lies on the stock; Z0 is always its top.
enum class MillOrigin { corner, centre };
template <>
struct Names<MillOrigin> {
    static constexpr std::string_view list[] = {"corner", "centre"};
};

/// Foam milled with a flat cutter. Lengths in mm. Feeds and speeds are starting values: no maker's table
/// covers soft foams.
struct MillOptions {
    double cutter_mm = 6;                ///< diameter, 0.5 to 100
    double flute_mm = 60;                ///< how deep the cutter can go, 1 to 1000
    std::optional<double> step_down_mm;  ///< the most that one pass goes down; none: half the cutter
    double stepover = 0.4;               ///< between neighbouring paths, share of the diameter, 0.05 to 0.9
    double feed_mm_min = 1500;           ///< 1 to 50,000
    double plunge_mm_min = 400;          ///< 1 to 50,000
    double spindle_rpm = 16000;          ///< 1 to 100,000
    double safe_mm = 5;                  ///< above the stock, for rapid moves; 0.5 to 200
    double pin_mm = 6;                   ///< diameter of the registration pins, 1 to 50; 0: none
    MillOrigin origin = MillOrigin::corner;
    friend bool operator==(const MillOptions&, const MillOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, MillOptions& mill) {
    visit.option(mill.cutter_mm, {.json = "cutter_mm",
                                  .flag = "--cutter",
                                  .takes = "MM",
                                  .unit = "mm",
                                  .range = {0.5, 100},
                                  .step = 0.5,
                                  .label = "the cutter's diameter",
                                  .help = "Mill: the flat cutter's diameter"});
    visit.option(mill.flute_mm, {.json = "flute_mm",
                                 .flag = "--flute",
                                 .takes = "MM",
                                 .unit = "mm",
                                 .range = {1, 1000},
                                 .step = 1,
                                 .label = "the flute's length",
                                 .help = "Mill: how deep the cutter can go"});
    visit.option(mill.step_down_mm, {.json = "step_down_mm",
                                     .flag = "--step-down",
                                     .takes = "MM",
                                     .unit = "mm",
                                     .range = {0.05, 1000},
                                     .step = 0.5,
                                     .label = "the depth of a pass",
                                     .help = "Mill: the most that a pass goes down",
                                     .usual = "half the cutter"});
    visit.option(mill.stepover, {.json = "stepover",
                                 .flag = "--stepover",
                                 .takes = "SHARE",
                                 .range = {0.05, 0.9},
                                 .step = 0.05,
                                 .label = "the stepover (a share of the cutter's diameter)",
                                 .help = "Mill: between paths, in diameters"});
    visit.option(mill.feed_mm_min, {.json = "feed_mm_min",
                                    .flag = "--feed",
                                    .takes = "MM/MIN",
                                    .unit = "mm/min",
                                    .range = {1, 50000},
                                    .step = 50,
                                    .label = "the feed",
                                    .help = "Mill: feed"});
    visit.option(mill.plunge_mm_min, {.json = "plunge_mm_min",
                                      .flag = "--plunge",
                                      .takes = "MM/MIN",
                                      .unit = "mm/min",
                                      .range = {1, 50000},
                                      .step = 50,
                                      .label = "the plunge feed",
                                      .help = "Mill: feed downwards"});
    visit.option(mill.spindle_rpm, {.json = "spindle_rpm",
                                    .flag = "--spindle",
                                    .takes = "RPM",
                                    .unit = "rpm",
                                    .range = {1, 100000},
                                    .step = 500,
                                    .label = "the spindle's speed",
                                    .help = "Mill: the spindle's speed"});
    visit.option(mill.safe_mm, {.json = "safe_mm",
                                .flag = "--safe-height",
                                .takes = "MM",
                                .unit = "mm",
                                .range = {0.5, 200},
                                .step = 0.5,
                                .label = "the safe height above the stock",
                                .help = "Mill: of rapid moves above the stock"});
    visit.option(mill.pin_mm, {.json = "pin_mm",
                               .flag = "--pin",
                               .takes = "MM",
                               .unit = "mm",
                               .range = {.least = 1, .most = 50, .or_zero = true},
                               .step = 0.5,
                               .label = "the registration pins' diameter",
                               .help = "Mill: diameter of the registration pins; 0: none"});
    visit.option(mill.origin, {.json = "origin",
                               .flag = "--origin",
                               .takes = "corner|centre",
                               .label = "the origin",
                               .help = "Mill: where X0 Y0 lies on the stock"});
}

/// What is out of range whatever the foam is; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const MillOptions& options);

}  // namespace snug

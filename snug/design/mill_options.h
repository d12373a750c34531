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
    visit.option(mill.cutter_mm,
                 {.json = "cutter_mm",
                  .flag = "--cutter",
                  .takes = "MM",
                  .unit = "mm",
                  .range = {0.5, 100},
                  .step = 0.5,
                  .label = {"the cutter's diameter", "刃の直径"},
                  .help = {"Mill: the flat cutter's diameter", "切削：フラットエンドミルの直径"}});
    visit.option(mill.flute_mm, {.json = "flute_mm",
                                 .flag = "--flute",
                                 .takes = "MM",
                                 .unit = "mm",
                                 .range = {1, 1000},
                                 .step = 1,
                                 .label = {"the flute's length", "刃長"},
                                 .help = {"Mill: how deep the cutter can go", "切削：刃が届く深さ"}});
    visit.option(mill.step_down_mm,
                 {.json = "step_down_mm",
                  .flag = "--step-down",
                  .takes = "MM",
                  .unit = "mm",
                  .range = {0.05, 1000},
                  .step = 0.5,
                  .label = {"the depth of a pass", "切込み"},
                  .help = {"Mill: the most that a pass goes down", "切削：一回に下がる最大の深さ"},
                  .usual = {"half the cutter's diameter", "刃の直径の半分"}});
    visit.option(mill.stepover, {.json = "stepover",
                                 .flag = "--stepover",
                                 .takes = "SHARE",
                                 .range = {0.05, 0.9},
                                 .step = 0.05,
                                 .label = {"the stepover (a share of the cutter's diameter)",
                                           "経路の間隔（刃の直径に対する割合）"},
                                 .help = {"Mill: distance between paths, as a share of the cutter's diameter",
                                          "切削：経路の間隔（刃の直径に対する割合）"}});
    visit.option(mill.feed_mm_min, {.json = "feed_mm_min",
                                    .flag = "--feed",
                                    .takes = "MM/MIN",
                                    .unit = "mm/min",
                                    .range = {1, 50000},
                                    .step = 50,
                                    .label = {"the feed", "送り"},
                                    .help = {"Mill: feed sideways", "切削：横方向の送り"}});
    visit.option(mill.plunge_mm_min, {.json = "plunge_mm_min",
                                      .flag = "--plunge",
                                      .takes = "MM/MIN",
                                      .unit = "mm/min",
                                      .range = {1, 50000},
                                      .step = 50,
                                      .label = {"the plunge feed", "下向きの送り"},
                                      .help = {"Mill: feed downwards", "切削：下向きの送り"}});
    visit.option(mill.spindle_rpm, {.json = "spindle_rpm",
                                    .flag = "--spindle",
                                    .takes = "RPM",
                                    .unit = "rpm",
                                    .range = {1, 100000},
                                    .step = 500,
                                    .label = {"the spindle's speed", "主軸の回転数"},
                                    .help = {"Mill: the spindle's speed", "切削：主軸の回転数"}});
    visit.option(mill.safe_mm, {.json = "safe_mm",
                                .flag = "--safe-height",
                                .takes = "MM",
                                .unit = "mm",
                                .range = {0.5, 200},
                                .step = 0.5,
                                .label = {"the safe height above the stock", "材料の上の安全高さ"},
                                .help = {"Mill: height of rapid moves above the stock",
                                         "切削：早送りで材料の上を通る高さ"}});
    visit.option(mill.pin_mm, {.json = "pin_mm",
                               .flag = "--pin",
                               .takes = "MM",
                               .unit = "mm",
                               .range = {.least = 1, .most = 50, .or_zero = true},
                               .step = 0.5,
                               .label = {"the registration pins' diameter", "位置決めピンの直径"},
                               .help = {"Mill: diameter of the registration pins; 0: none",
                                        "切削：位置決めピンの直径。0 ならなし"}});
    visit.option(mill.origin,
                 {.json = "origin",
                  .flag = "--origin",
                  .label = {"the origin", "原点"},
                  .help = {"Mill: where X0 Y0 lies on the stock", "切削：X0 Y0 の材料上の位置"}});
}

/// The most that one pass goes down.
[[nodiscard]] double wanted_step_down_mm(const MillOptions& options);

}  // namespace snug

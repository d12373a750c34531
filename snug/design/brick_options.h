#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/design/option.h"

namespace snug {

/// How high a layer is: bricks of 9.6 mm or plates of 3.2; automatic: bricks where the blocks allow it.
enum class BrickUnit { automatic, brick, plate };
template <>
struct Names<BrickUnit> {
    static constexpr std::string_view list[] = {"auto", "brick", "plate"};
};

/// Where the halves meet: studs against studs, which hold the lid off, or tiles, which have none.
enum class BrickRim { studs, tiles };
template <>
struct Names<BrickRim> {
    static constexpr std::string_view list[] = {"studs", "tiles"};
};

/// Pieces of one size that there are, in both halves together. Plates and tiles count as pieces of their own.
struct BrickStock {
    std::string size;  ///< "2x4"
    int pieces = 0;    ///< 0 or more
    friend bool operator==(const BrickStock&, const BrickStock&) = default;
};

/// Foams built of bricks on an 8 mm pitch.
struct BrickOptions {
    BrickUnit unit = BrickUnit::automatic;
    std::vector<std::string> family;   ///< sizes to build with ("1x2", "2x4"); empty: all that are known
    std::string lower_color = "blue";  ///< as brick_colors() names them
    std::string lid_color = "orange";
    std::vector<BrickStock> stock;  ///< sizes that are not named do not run out
    BrickRim rim = BrickRim::studs;
    double capacity_n = 0.7;  ///< newtons that one contact point of a stud holds, 0.01 to 100
    friend bool operator==(const BrickOptions&, const BrickOptions&) = default;
};

/// Height of a stud, which stands into the cavity of either half, in mm.
constexpr double kStudHeight = 1.8;

/// --brick-colors
[[nodiscard]] SharedFlag<BrickOptions> brick_color_flag();

template <class Visit>
void visit_options(Visit& visit, BrickOptions& bricks) {
    visit.option(bricks.unit, {.json = "unit",
                               .flag = "--brick-unit",
                               .label = {"the height of a layer", "段の高さ"},
                               .help = {"Bricks: layers of bricks or of plates",
                                        "ブロック玩具：段をブロックにするか、薄いプレートにするか"}});
    visit.option(bricks.family, {.json = "family",
                                 .flag = "--brick-sizes",
                                 .takes = "2x4,1x2,...",
                                 .label = {"the sizes of bricks", "ブロック玩具の大きさ"},
                                 .help = {"Bricks: the sizes to build with", "ブロック玩具：使う大きさ"},
                                 .usual = {"all", "すべて"}});
    visit.option(bricks.lower_color, {.json = "lower_color",
                                      .flag = "--brick-colors",
                                      .label = {"the lower half's colour", "下の色"},
                                      .help = {"Colour of the lower half's bricks", "下のブロック玩具の色"}});
    visit.option(bricks.lid_color, {.json = "lid_color",
                                    .flag = "--brick-colors",
                                    .label = {"the lid's colour", "ふたの色"},
                                    .help = {"Colour of the lid's bricks", "ふたのブロック玩具の色"}});
    visit.flag(bricks, brick_color_flag());
    visit.option(bricks.stock, {.json = "stock",
                                .flag = "--brick-stock",
                                .takes = "2x4=100,1x1=40",
                                .unit = {"pieces", "個"},
                                .range = {0, 10'000'000},
                                .label = {"the stock of a brick", "ブロック玩具の手持ちの数"},
                                .help = {"Bricks: how many pieces of each size there are",
                                         "ブロック玩具：大きさごとの手持ちの数"},
                                .usual = {"no limit", "制限なし"}});
    visit.option(bricks.rim, {.json = "rim",
                              .flag = "--brick-rim",
                              .label = {"the rim", "合わせ面"},
                              .help = {"Bricks: whether the halves meet with studs or with tiles",
                                       "ブロック玩具：合わせ面をポッチにするか、タイルにするか"}});
    visit.option(bricks.capacity_n,
                 {.json = "capacity_n",
                  .flag = "--brick-capacity",
                  .takes = "N",
                  .unit = {"newtons", "ニュートン"},
                  .range = {0.01, 100},
                  .step = 0.1,
                  .label = {"what a contact point of a stud holds", "ポッチの接点の保持力"},
                  .help = {"Bricks: newtons that a contact point of a stud holds",
                           "ブロック玩具：ポッチの接点一つが支える力（ニュートン）"}});
}

/// What is out of range whatever the foam is; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const BrickOptions& options);

}  // namespace snug

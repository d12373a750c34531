#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snug {

/// How high a layer is: bricks of 9.6 mm or plates of 3.2; automatic: bricks where the blocks allow it.
enum class BrickUnit { automatic, brick, plate };
[[nodiscard]] std::string_view brick_unit_name(BrickUnit unit);  ///< auto, brick, plate
[[nodiscard]] std::optional<BrickUnit> brick_unit_from_name(std::string_view name);

/// Where the halves meet: studs against studs, which hold the lid off, or tiles, which have none.
enum class BrickRim { studs, tiles };
[[nodiscard]] std::string_view brick_rim_name(BrickRim rim);  ///< studs, tiles
[[nodiscard]] std::optional<BrickRim> brick_rim_from_name(std::string_view name);

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

/// What is out of range whatever the foam is, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const BrickOptions& options);

}  // namespace snug

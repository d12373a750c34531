#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

// The bricks that exist: sizes, part numbers and colours as LDraw and BrickLink know them.

namespace snug {

constexpr double kBrickPitch = 8;     ///< mm between studs
constexpr double kPlateHeight = 3.2;  ///< mm
constexpr int kPlatesInBrick = 3;

enum class BrickKind { brick, plate, tile };

/// A piece that can be bought. LDraw and BrickLink use the same number.
struct BrickPart {
    BrickKind kind;
    int width, length;        ///< in studs, width <= length
    std::string_view number;  ///< "3001"
    double mass_g;  ///< bricks as Luo et al. weighed them; plates and tiles by their share of material

    [[nodiscard]] int studs() const { return width * length; }
    [[nodiscard]] int plates_high() const { return kind == BrickKind::brick ? kPlatesInBrick : 1; }
};

/// Of each kind from the largest to the smallest.
[[nodiscard]] std::span<const BrickPart> brick_parts();
[[nodiscard]] const BrickPart* brick_part(BrickKind kind, int width, int length);

/// "2x4" (either way round) as width and length; none where no brick, plate or tile has that size.
struct BrickSize {
    int width, length;
    friend bool operator==(const BrickSize&, const BrickSize&) = default;
};
[[nodiscard]] std::optional<BrickSize> brick_size(std::string_view text);

struct BrickColor {
    std::string_view name;  ///< "dark blue"
    int ldraw, bricklink;
    std::uint8_t red, green, blue;
};
[[nodiscard]] std::span<const BrickColor> brick_colors();
[[nodiscard]] const BrickColor* brick_color(std::string_view name);

}  // namespace snug

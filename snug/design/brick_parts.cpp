#include "snug/design/brick_parts.h"

#include <algorithm>
#include <array>

#include "snug/base/text.h"

namespace snug {
namespace {

// Masses of bricks: Luo et al., Legolization (2015), table of the supplement; 1 x 10 and 2 x 10 carry on from
// them. A plate has about 0.45 of its brick's material, a tile the same without its studs.
constexpr double kPlateShare = 0.45, kTileShare = 0.4;

constexpr BrickPart brick(int width, int length, std::string_view number, double mass_g) {
    return {BrickKind::brick, width, length, number, mass_g};
}
constexpr BrickPart plate(int width, int length, std::string_view number, double brick_g) {
    return {BrickKind::plate, width, length, number, brick_g * kPlateShare};
}
constexpr BrickPart tile(int width, int length, std::string_view number, double brick_g) {
    return {BrickKind::tile, width, length, number, brick_g * kTileShare};
}

constexpr std::array kParts{
    brick(2, 10, "3006", 5.5), brick(2, 8, "3007", 4.4),  brick(2, 6, "2456", 3.28),
    brick(2, 4, "3001", 2.2),  brick(1, 8, "3008", 3.08), brick(2, 3, "3002", 1.78),
    brick(1, 6, "3009", 2.23), brick(2, 2, "3003", 1.18), brick(1, 4, "3010", 1.74),
    brick(1, 3, "3622", 1.18), brick(1, 2, "3004", 0.78), brick(1, 1, "3005", 0.44),
    plate(2, 10, "3832", 5.5), plate(2, 8, "3034", 4.4),  plate(2, 6, "3795", 3.28),
    plate(2, 4, "3020", 2.2),  plate(1, 8, "3460", 3.08), plate(2, 3, "3021", 1.78),
    plate(1, 6, "3666", 2.23), plate(2, 2, "3022", 1.18), plate(1, 4, "3710", 1.74),
    plate(1, 3, "3623", 1.18), plate(1, 2, "3023", 0.78), plate(1, 1, "3024", 0.44),
    tile(2, 4, "87079", 2.2),  tile(1, 8, "4162", 3.08),  tile(2, 3, "26603", 1.78),
    tile(1, 6, "6636", 2.23),  tile(2, 2, "3068b", 1.18), tile(1, 4, "2431", 1.74),
    tile(1, 3, "63864", 1.18), tile(1, 2, "3069b", 0.78), tile(1, 1, "3070b", 0.44),
};

constexpr std::array kColors{
    BrickColor{"black", 0, 11, 0x1B, 0x2A, 0x34},
    BrickColor{"blue", 1, 7, 0x1E, 0x5A, 0xA8},
    BrickColor{"green", 2, 6, 0x00, 0x85, 0x2B},
    BrickColor{"red", 4, 5, 0xB4, 0x00, 0x00},
    BrickColor{"yellow", 14, 3, 0xFA, 0xC8, 0x0A},
    BrickColor{"white", 15, 1, 0xF4, 0xF4, 0xF4},
    BrickColor{"tan", 19, 2, 0xB0, 0xA0, 0x6F},
    BrickColor{"orange", 25, 4, 0xD6, 0x79, 0x23},
    BrickColor{"reddish brown", 70, 88, 0x5F, 0x31, 0x09},
    BrickColor{"light bluish gray", 71, 86, 0x96, 0x96, 0x96},
    BrickColor{"dark bluish gray", 72, 85, 0x64, 0x64, 0x64},
    BrickColor{"dark blue", 272, 63, 0x19, 0x32, 0x5A},
    BrickColor{"dark brown", 308, 120, 0x35, 0x21, 0x00},
    BrickColor{"dark red", 320, 59, 0x72, 0x00, 0x12},
};

/// One or two digits.
std::optional<int> small_number(std::string_view text) {
    if (text.empty() || text.size() > 2) return {};
    int value = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return {};
        value = value * 10 + (c - '0');
    }
    return value;
}

}  // namespace

std::span<const BrickPart> brick_parts() {
    return kParts;
}

const BrickPart* brick_part(BrickKind kind, int width, int length) {
    const auto found = std::find_if(kParts.begin(), kParts.end(), [&](const BrickPart& part) {
        return part.kind == kind && part.width == width && part.length == length;
    });
    return found == kParts.end() ? nullptr : &*found;
}

std::optional<BrickSize> brick_size(std::string_view text) {
    const std::size_t cross = text.find_first_of("xX");
    if (cross == std::string_view::npos) return {};
    const auto a = small_number(text.substr(0, cross)), b = small_number(text.substr(cross + 1));
    if (!a || !b) return {};
    const BrickSize size{std::min(*a, *b), std::max(*a, *b)};
    const bool known = std::any_of(kParts.begin(), kParts.end(), [&](const BrickPart& part) {
        return part.width == size.width && part.length == size.length;
    });
    return known ? std::optional(size) : std::nullopt;
}

std::span<const BrickColor> brick_colors() {
    return kColors;
}

const BrickColor* brick_color(std::string_view name) {
    const auto found = std::find_if(kColors.begin(), kColors.end(),
                                    [&](const BrickColor& color) { return color.name == name; });
    return found == kColors.end() ? nullptr : &*found;
}

}  // namespace snug

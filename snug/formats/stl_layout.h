#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "snug/base/result.h"
#include "snug/base/vec.h"

// Binary STL: 80 bytes of anything, a count, and 50 bytes a triangle: a normal, three corners, an attribute.

namespace snug {

constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlFacet = 50;

[[nodiscard]] inline std::uint32_t read_u32(const std::byte* at) {
    return std::to_integer<std::uint32_t>(at[0]) | std::to_integer<std::uint32_t>(at[1]) << 8 |
           std::to_integer<std::uint32_t>(at[2]) << 16 | std::to_integer<std::uint32_t>(at[3]) << 24;
}

[[nodiscard]] inline float read_f32(const std::byte* at) {
    const std::uint32_t bits = read_u32(at);
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// The three corners, each three floats, as they are in memory on every machine that Snug runs on.
inline void copy_stl_corners(const std::byte* facet, std::array<Vec3f, 3>& corners) {
    static_assert(std::endian::native == std::endian::little && sizeof corners == 36);
    std::memcpy(corners.data(), facet + 12, sizeof corners);
}

/// Whether every corner is usable() (left_out.h). Bits instead of floats, which the compiler turns into
/// vector instructions.
[[nodiscard]] inline bool all_usable(std::span<const std::array<Vec3f, 3>> corners) {
    constexpr std::uint32_t kMagnitude = 0x7fff'ffff;
    constexpr std::uint32_t kGreatest = 0x7149'f2c9;  // of the last float below kGreatestCoordinate
    std::uint32_t wrong = 0;
    for (const std::array<Vec3f, 3>& triangle : corners) {
        std::array<std::uint32_t, 9> bits;
        static_assert(sizeof bits == sizeof triangle);
        std::memcpy(bits.data(), &triangle, sizeof bits);
        for (const std::uint32_t each : bits) wrong |= (each & kMagnitude) > kGreatest;
    }
    return wrong == 0;
}

/// Moves the usable ones to the front, in their order, and counts them.
[[nodiscard]] inline std::size_t usable_first(std::span<std::array<Vec3f, 3>> corners) {
    if (all_usable(corners)) return corners.size();
    const auto end = std::remove_if(corners.begin(), corners.end(), [](const std::array<Vec3f, 3>& each) {
        return !all_usable(std::span(&each, 1));
    });
    return static_cast<std::size_t>(end - corners.begin());
}

[[nodiscard]] inline Error stl_cut_off(std::uint64_t count, std::uint64_t held) {
    return {ErrorKind::input, say("stl.cut_off", {{"triangles", count}, {"held", held}})};
}

}  // namespace snug

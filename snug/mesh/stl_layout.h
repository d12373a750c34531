#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "snug/base/result.h"
#include "snug/base/text.h"
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

/// False where a coordinate is not finite.
[[nodiscard]] inline bool read_stl_corners(const std::byte* facet, std::array<Vec3f, 3>& corners) {
    const std::byte* at = facet + 12;  // behind the normal
    for (Vec3f& p : corners) {
        p = {read_f32(at), read_f32(at + 4), read_f32(at + 8)};
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
        at += 12;
    }
    return true;
}

/// Whether no exponent is full. Bits instead of floats, which the compiler turns into vector instructions.
[[nodiscard]] inline bool all_finite(std::span<const std::array<Vec3f, 3>> corners) {
    constexpr std::uint32_t kExponent = 0x7f80'0000;
    std::uint32_t wrong = 0;
    for (const std::array<Vec3f, 3>& triangle : corners) {
        std::array<std::uint32_t, 9> bits;
        static_assert(sizeof bits == sizeof triangle);
        std::memcpy(bits.data(), &triangle, sizeof bits);
        for (const std::uint32_t each : bits) wrong |= (each & kExponent) == kExponent;
    }
    return wrong == 0;
}

[[nodiscard]] inline Error stl_cut_off(std::uint64_t count, std::uint64_t held) {
    return {ErrorKind::input, "the file is cut off: it says " + counted(count, "triangle", "triangles") +
                                  " but holds " + grouped(held) + "; copy or export it again"};
}

[[nodiscard]] inline Error stl_not_finite(std::uint64_t triangle, std::uint64_t count) {
    return {ErrorKind::input, "triangle " + grouped(triangle + 1) + " of " + grouped(count) +
                                  " has a coordinate that is not a finite number: repair or export the mesh "
                                  "again"};
}

}  // namespace snug

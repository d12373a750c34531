#include <cstring>

#include "snug/mesh/measure.h"

namespace snug {
namespace {

struct PositionBits {
    std::uint32_t x, y, z;
    friend bool operator==(const PositionBits&, const PositionBits&) = default;
};

std::uint32_t bits_of(float value) {
    const float unsigned_zero = value + 0.0f;  // -0 + 0 = 0
    std::uint32_t bits;
    std::memcpy(&bits, &unsigned_zero, sizeof bits);
    return bits;
}

PositionBits bits_of(Vec3f p) {
    return {bits_of(p.x), bits_of(p.y), bits_of(p.z)};
}

/// Scans have neighbouring vertices whose low bits are alike, so every bit must reach the high ones.
std::uint64_t hash_of(PositionBits p) {
    std::uint64_t h = (static_cast<std::uint64_t>(p.x) << 32 | p.y) * 0x9e3779b97f4a7c15u;
    h = (h ^ h >> 32 ^ p.z) * 0xd6e8feb86659fd93u;
    return h ^ h >> 32;
}

}  // namespace

std::vector<std::uint32_t> welded(const Mesh& mesh) {
    constexpr std::uint32_t kFree = 0xffffffff;
    const std::size_t count = mesh.vertices.size();
    std::size_t slots = 16;
    while (slots < 2 * count) slots *= 2;
    std::vector<std::uint32_t> first_at(slots, kFree);  // open addressing, linear probing
    std::vector<std::uint32_t> weld(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        const PositionBits position = bits_of(mesh.vertices[v]);
        std::size_t slot = hash_of(position) & (slots - 1);
        while (first_at[slot] != kFree && !(bits_of(mesh.vertices[first_at[slot]]) == position))
            slot = (slot + 1) & (slots - 1);
        if (first_at[slot] == kFree) first_at[slot] = v;
        weld[v] = first_at[slot];
    }
    return weld;
}

}  // namespace snug

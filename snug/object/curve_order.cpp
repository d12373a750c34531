#include "snug/object/curve_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "snug/base/parallel.h"

namespace snug {
namespace {

constexpr std::size_t kKeysATask = std::size_t{1} << 15;  // that one task treats

/// A place on the curve above the number of a triangle.
using Key = std::uint64_t;
constexpr int kPlaceShift = 32;
constexpr int kCurveBits = 10;
constexpr double kCellsPerAxis = 1 << kCurveBits;

template <class Work>
void for_each_chunk(std::size_t count, Work work) {
    parallel_for((count + kKeysATask - 1) / kKeysATask, [&](std::size_t chunk) {
        work(chunk, chunk * kKeysATask, std::min(count, (chunk + 1) * kKeysATask));
    });
}

/// The lowest ten bits, two zeros between each.
std::uint64_t spread(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ff;
    v = (v | v << 8) & 0x0300f00f;
    v = (v | v << 4) & 0x030c30c3;
    v = (v | v << 2) & 0x09249249;
    return v;
}

std::vector<Key> keys_of(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    const Box3d box = bounds(mesh);
    const double side = box.longest_side();
    const double cells_per_mm = side > 0 ? kCellsPerAxis / side : 0;
    const auto cell = [cells_per_mm](double offset) {
        return static_cast<std::uint32_t>(std::clamp(offset * cells_per_mm, 0.0, kCellsPerAxis - 1));
    };
    std::vector<Key> keys(triangles.size());
    for_each_chunk(keys.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec3d centroid;
            for (const std::uint32_t v : mesh.triangles[triangles[i]])
                centroid = centroid + vec_cast<double>(mesh.vertices[v]) * (1.0 / 3);
            const Vec3d offset = centroid - box.min;
            const Key place =
                spread(cell(offset.x)) | spread(cell(offset.y)) << 1 | spread(cell(offset.z)) << 2;
            keys[i] = place << kPlaceShift | triangles[i];
        }
    });
    return keys;
}

/// Stable radix sort by the place on the curve.
std::vector<Key> sorted(std::vector<Key> keys) {
    constexpr int kDigitBits = 10;
    constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
    std::vector<Key> other(keys.size());
    std::vector<std::array<std::uint32_t, kDigits>> places((keys.size() + kKeysATask - 1) / kKeysATask);
    for (int shift = kPlaceShift; shift < kPlaceShift + 3 * kCurveBits; shift += kDigitBits) {
        const auto digit = [shift](Key key) {
            return static_cast<std::size_t>(key >> shift) & (kDigits - 1);
        };
        for_each_chunk(keys.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            places[chunk].fill(0);
            for (std::size_t i = begin; i < end; ++i) ++places[chunk][digit(keys[i])];
        });
        std::uint32_t place = 0;
        for (std::size_t d = 0; d < kDigits; ++d)
            for (auto& of_chunk : places) place += std::exchange(of_chunk[d], place);
        for_each_chunk(keys.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) other[places[chunk][digit(keys[i])]++] = keys[i];
        });
        keys.swap(other);
    }
    return keys;
}

}  // namespace

std::vector<std::uint32_t> curve_order(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    const std::vector<Key> keys = sorted(keys_of(mesh, triangles));
    std::vector<std::uint32_t> order(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<std::uint32_t>(keys[i]);
    return order;
}

}  // namespace snug

#include "snug/foam/prepared_surface.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "snug/base/box.h"
#include "snug/base/parallel.h"

namespace snug {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 15;  // triangles that one task treats

std::size_t chunks_of(std::size_t count) {
    return (count + kChunk - 1) / kChunk;
}

/// A place on the Morton curve above the number of a triangle: sorting sorts by both.
using CurveKey = std::uint64_t;
constexpr int kCurveBits = 10;  // per axis

std::uint64_t spread(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ff;
    v = (v | v << 8) & 0x0300f00f;
    v = (v | v << 4) & 0x030c30c3;
    v = (v | v << 2) & 0x09249249;
    return v;
}

std::vector<CurveKey> curve_keys(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    const Box3d box = bounds(mesh);
    const double side = box.longest_side();
    const float scale = static_cast<float>(side > 0 ? ((1 << kCurveBits) - 1) / side / 3 : 0);
    const Vec3f low = vec_cast<float>(box.min * 3.0);
    std::vector<CurveKey> keys(triangles.size());
    parallel_for(chunks_of(keys.size()), [&](std::size_t chunk) {
        const std::size_t end = std::min(keys.size(), (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i) {
            const auto& [a, b, c] = mesh.triangles[triangles[i]];
            const Vec3f sum = mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c] - low;
            const auto cell = [scale](float offset) {
                return static_cast<std::uint32_t>(
                    std::clamp(offset * scale, 0.0f, static_cast<float>((1 << kCurveBits) - 1)));
            };
            const std::uint64_t key =
                spread(cell(sum.x)) | spread(cell(sum.y)) << 1 | spread(cell(sum.z)) << 2;
            keys[i] = key << 32 | triangles[i];
        }
    });
    return keys;
}

/// Stable radix sort by the place on the curve.
std::vector<CurveKey> sorted(std::vector<CurveKey> keys) {
    constexpr int kDigitBits = 10;
    constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
    const std::size_t chunks = chunks_of(keys.size());
    std::vector<CurveKey> other(keys.size());
    std::vector<std::array<std::uint32_t, kDigits>> places(chunks);
    for (int shift = 32; shift < 32 + 3 * kCurveBits; shift += kDigitBits) {
        const auto digit = [shift](CurveKey key) { return key >> shift & (kDigits - 1); };
        const auto each_key = [&](std::size_t chunk, auto visit) {
            const std::size_t end = std::min(keys.size(), (chunk + 1) * kChunk);
            for (std::size_t i = chunk * kChunk; i < end; ++i) visit(keys[i]);
        };
        parallel_for(chunks, [&](std::size_t chunk) {
            places[chunk].fill(0);
            each_key(chunk, [&](CurveKey key) { ++places[chunk][digit(key)]; });
        });
        std::uint32_t place = 0;
        for (std::size_t d = 0; d < kDigits; ++d)
            for (auto& of_chunk : places) place += std::exchange(of_chunk[d], place);
        parallel_for(chunks, [&](std::size_t chunk) {
            each_key(chunk, [&](CurveKey key) { other[places[chunk][digit(key)]++] = key; });
        });
        keys.swap(other);
    }
    return keys;
}

/// Gives the vertices of one cluster their numbers within it, in the order of first use.
class LocalVertices {
  public:
    std::uint8_t number(std::uint32_t vertex) {
        std::size_t slot = vertex * 0x9e3779b1u >> (32 - kSlotBits);
        while (slots_[slot] != kFree && found_[slots_[slot]] != vertex) slot = (slot + 1) % kSlots;
        if (slots_[slot] == kFree) {
            used_[count_] = static_cast<std::uint16_t>(slot);
            found_[count_] = vertex;
            slots_[slot] = static_cast<std::uint8_t>(count_++);
        }
        return slots_[slot];
    }
    [[nodiscard]] std::span<const std::uint32_t> found() const { return {found_.data(), count_}; }
    void clear() {
        for (std::size_t i = 0; i < count_; ++i) slots_[used_[i]] = kFree;
        count_ = 0;
    }

    LocalVertices() { slots_.fill(kFree); }

  private:
    static constexpr int kSlotBits = 9;
    static constexpr std::size_t kSlots = std::size_t{1} << kSlotBits;
    static constexpr std::uint8_t kFree = 255;
    static_assert(SurfaceClusters::kVertices < kFree);

    std::array<std::uint8_t, kSlots> slots_{};
    std::array<std::uint32_t, SurfaceClusters::kVertices> found_{};
    std::array<std::uint16_t, SurfaceClusters::kVertices> used_{};
    std::size_t count_ = 0;
};

struct FloatBox {
    Vec3f min, max;

    void include(const FloatBox& other) {
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], other.min[axis]);
            max[axis] = std::max(max[axis], other.max[axis]);
        }
    }
};

void set_box(BoxLevel& level, std::size_t i, const FloatBox& box) {
    BoxGroup& group = level.groups[i / BoxGroup::kBoxes];
    const std::size_t lane = i % BoxGroup::kBoxes;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const float centre = box.min[axis] * 0.5f + box.max[axis] * 0.5f;
        group.centre[a][lane] = centre;
        group.half[a][lane] = std::max(box.max[axis] - centre, centre - box.min[axis]);
    }
}

/// Some clusters, as one task makes them.
struct Part {
    SurfaceClusters clusters;
    std::vector<FloatBox> boxes;
};

void add_cluster(Part& part, const Mesh& mesh, std::span<const CurveKey> keys, LocalVertices& local) {
    SurfaceClusters& out = part.clusters;
    SurfaceClusters::Cluster cluster;
    cluster.first_coordinate = static_cast<std::uint32_t>(out.coordinates.size());
    cluster.first_triangle = static_cast<std::uint32_t>(out.corners.size());
    cluster.triangles = static_cast<std::uint16_t>(keys.size());
    local.clear();
    for (const CurveKey key : keys) {
        const auto& [a, b, c] = mesh.triangles[static_cast<std::uint32_t>(key)];
        const std::uint8_t first = local.number(a), second = local.number(b), third = local.number(c);
        out.corners.push_back({first, second, third});
    }
    cluster.vertices = static_cast<std::uint16_t>(local.found().size());
    const Vec3f first = mesh.vertices[local.found().front()];
    FloatBox box{first, first};
    const std::size_t padded = cluster.padded();
    out.coordinates.resize(out.coordinates.size() + 3 * padded);
    float* const coordinates = out.coordinates.data() + cluster.first_coordinate;
    for (std::size_t i = 0; i < padded; ++i) {
        const Vec3f p = mesh.vertices[local.found()[std::min(i, local.found().size() - 1)]];
        box.include({p, p});
        for (int axis = 0; axis < 3; ++axis)
            coordinates[static_cast<std::size_t>(axis) * padded + i] = p[axis];
    }
    part.boxes.push_back(box);
    out.clusters.push_back(cluster);
}

Part make_part(const Mesh& mesh, std::span<const CurveKey> keys) {
    Part part;
    LocalVertices local;
    for (std::size_t first = 0; first < keys.size(); first += SurfaceClusters::kTriangles)
        add_cluster(part, mesh,
                    keys.subspan(first, std::min(SurfaceClusters::kTriangles, keys.size() - first)), local);
    return part;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& part) {
    all.insert(all.end(), part.begin(), part.end());
}

void add_levels(SurfaceClusters& all, std::vector<FloatBox> boxes) {
    for (const FloatBox& box : boxes)
        for (int axis = 0; axis < 3; ++axis)
            all.largest = std::max({all.largest, std::fabs(box.min[axis]), std::fabs(box.max[axis])});
    while (!boxes.empty()) {
        BoxLevel& level = all.levels.emplace_back();
        level.boxes = boxes.size();
        level.groups.resize((boxes.size() + BoxGroup::kBoxes - 1) / BoxGroup::kBoxes);
        for (std::size_t i = 0; i < boxes.size(); ++i) set_box(level, i, boxes[i]);
        if (level.groups.size() == 1) return;
        std::vector<FloatBox> above;
        above.reserve(level.groups.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (i % BoxGroup::kBoxes == 0)
                above.push_back(boxes[i]);
            else
                above.back().include(boxes[i]);
        }
        boxes = std::move(above);
    }
}

void add_samples(SurfaceClusters& all) {
    for (std::size_t i = 0; i < all.clusters.size(); i += 4) {
        const float* const coordinates = all.coordinates.data() + all.clusters[i].first_coordinate;
        const std::size_t padded = all.clusters[i].padded();
        all.samples.push_back({coordinates[0], coordinates[padded], coordinates[2 * padded]});
    }
}

SurfaceClusters make_clusters(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    static_assert(kChunk % SurfaceClusters::kTriangles == 0);
    const std::vector<CurveKey> keys = sorted(curve_keys(mesh, triangles));
    std::vector<Part> parts(chunks_of(keys.size()));
    parallel_for(parts.size(), [&](std::size_t chunk) {
        const std::size_t first = chunk * kChunk;
        parts[chunk] = make_part(mesh, std::span(keys).subspan(first, std::min(kChunk, keys.size() - first)));
    });
    SurfaceClusters all;
    std::vector<FloatBox> boxes;
    for (const Part& part : parts) {
        for (SurfaceClusters::Cluster cluster : part.clusters.clusters) {
            cluster.first_coordinate += static_cast<std::uint32_t>(all.coordinates.size());
            cluster.first_triangle += static_cast<std::uint32_t>(all.corners.size());
            all.clusters.push_back(cluster);
        }
        append(all.coordinates, part.clusters.coordinates);
        append(all.corners, part.clusters.corners);
        append(boxes, part.boxes);
    }
    add_levels(all, std::move(boxes));
    add_samples(all);
    return all;
}

}  // namespace

PreparedSurface prepare_surface(const Mesh& mesh) {
    const std::size_t first_cap_vertex = mesh.vertices.size() - mesh.cap_vertices;
    std::vector<std::uint32_t> body, caps;
    body.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        (std::max({a, b, c}) < first_cap_vertex ? body : caps).push_back(t);
    }
    return {make_clusters(mesh, body), make_clusters(mesh, caps)};
}

}  // namespace snug

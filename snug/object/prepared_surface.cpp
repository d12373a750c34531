#include "snug/object/prepared_surface.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "snug/base/box.h"
#include "snug/base/parallel.h"
#include "snug/object/curve_order.h"

namespace snug {
namespace {

constexpr std::size_t kTrianglesATask = std::size_t{1} << 15;  // triangles that one task treats
constexpr std::size_t kClustersPerSample = 4;

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

void add_cluster(Part& part, const Mesh& mesh, std::span<const std::uint32_t> triangles,
                 LocalVertices& local) {
    SurfaceClusters& out = part.clusters;
    SurfaceClusters::Cluster cluster;
    cluster.first_coordinate = static_cast<std::uint32_t>(out.coordinates.size());
    cluster.first_triangle = static_cast<std::uint32_t>(out.corners.size());
    cluster.triangles = static_cast<std::uint16_t>(triangles.size());
    local.clear();
    for (const std::uint32_t t : triangles) {
        const auto& [a, b, c] = mesh.triangles[t];
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

Part make_part(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    constexpr std::size_t kMost = SurfaceClusters::kTriangles;
    Part part;
    LocalVertices local;
    for (std::size_t first = 0; first < triangles.size(); first += kMost)
        add_cluster(part, mesh, triangles.subspan(first, std::min(kMost, triangles.size() - first)), local);
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
    for (std::size_t i = 0; i < all.clusters.size(); i += kClustersPerSample) {
        const float* const coordinates = all.coordinates.data() + all.clusters[i].first_coordinate;
        const std::size_t padded = all.clusters[i].padded();
        all.samples.push_back({coordinates[0], coordinates[padded], coordinates[2 * padded]});
    }
}

SurfaceClusters make_clusters(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    static_assert(kTrianglesATask % SurfaceClusters::kTriangles == 0);
    const std::vector<std::uint32_t> order = curve_order(mesh, triangles);
    std::vector<Part> parts((order.size() + kTrianglesATask - 1) / kTrianglesATask);
    parallel_for(parts.size(), [&](std::size_t chunk) {
        const std::size_t first = chunk * kTrianglesATask;
        parts[chunk] =
            make_part(mesh, std::span(order).subspan(first, std::min(kTrianglesATask, order.size() - first)));
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

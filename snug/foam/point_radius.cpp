#include "snug/foam/point_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nanoflann.hpp>
#include <numeric>
#include <tuple>

#include "snug/base/parallel.h"
#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::size_t kNeighbours = 6;
constexpr double kMostMedians = 4;
constexpr std::size_t kLeaf = 16;
constexpr std::size_t kChunk = 4096;  // points that one task treats

/// The places where points lie, each once, as nanoflann wants to see them. Without this, points in the same
/// place would all be looked at by each of them.
struct Places {
    std::vector<Vec3f> at;
    std::vector<std::uint32_t> of_vertex;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return at.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t place, std::size_t axis) const {
        return static_cast<double>(at[place][static_cast<int>(axis)]);
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using PlaceTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Places>, Places, 3,
                                                      std::uint32_t>;

Places places_of(const std::vector<Vec3f>& vertices) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&vertices](std::uint32_t a, std::uint32_t b) {
        const Vec3f p = vertices[a], q = vertices[b];
        return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
    });
    Places places;
    places.of_vertex.resize(vertices.size());
    for (const std::uint32_t v : order) {
        if (places.at.empty() || !(places.at.back() == vertices[v])) places.at.push_back(vertices[v]);
        places.of_vertex[v] = static_cast<std::uint32_t>(places.at.size() - 1);
    }
    return places;
}

std::vector<double> spacing_of(const Places& places) {
    const PlaceTree tree(3, places, nanoflann::KDTreeSingleIndexAdaptorParams(kLeaf));
    const std::size_t wanted = std::min(kNeighbours + 1, places.at.size());  // and itself
    std::vector<double> spacing(places.at.size());
    parallel_for((spacing.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        const std::size_t end = std::min(spacing.size(), (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i) {
            const Vec3d p = vec_cast<double>(places.at[i]);
            const std::array<double, 3> query = {p.x, p.y, p.z};
            std::array<std::uint32_t, kNeighbours + 1> nearest{};
            std::array<double, kNeighbours + 1> squared{};
            tree.knnSearch(query.data(), wanted, nearest.data(), squared.data());
            spacing[i] = std::sqrt(squared[wanted - 1]);
        }
    });
    return spacing;
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Not below the value, so that rounding leaves nothing uncovered.
float rounded_up(double value) {
    const auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) < value
               ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
               : rounded;
}

}  // namespace

Result<PointRadii> point_radii(const Mesh& cloud, double fixed) {
    if (!(fixed >= 0 && fixed <= static_cast<double>(std::numeric_limits<float>::max())))
        return fail(ErrorKind::usage, "the radius of a point must be 0 mm (from the spacing) or more");
    const Places places = places_of(cloud.vertices);
    if (places.at.size() < 2) return fail(ErrorKind::input, "the object has no size: all its points are one");

    PointRadii radii;
    if (fixed > 0) {
        radii.radius.assign(cloud.vertices.size(), rounded_up(fixed));
        radii.median = fixed;
        return radii;
    }
    const std::vector<double> spacing = spacing_of(places);
    radii.radius.reserve(cloud.vertices.size());
    radii.median = median_of(spacing);
    const double most = kMostMedians * radii.median;
    for (const std::uint32_t place : places.of_vertex) {
        radii.shortened += spacing[place] > most;
        radii.radius.push_back(rounded_up(std::min(spacing[place], most)));
    }
    return radii;
}

}  // namespace snug

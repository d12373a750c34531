#include "snug/object/cloud_places.h"

#include <algorithm>
#include <nanoflann.hpp>
#include <numeric>
#include <tuple>

namespace snug {
namespace {

constexpr std::size_t kLeaf = 16;

/// As nanoflann wants to see points.
struct TreePoints {
    const std::vector<Vec3f>& at;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return at.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t place, std::size_t axis) const {
        return static_cast<double>(at[place][static_cast<int>(axis)]);
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, TreePoints>,
                                                  TreePoints, 3, std::uint32_t>;

}  // namespace

struct CloudPlaces::Tree {
    explicit Tree(const std::vector<Vec3f>& at)
        : points{at}, index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(kLeaf)) {}
    TreePoints points;
    Index index;
};

CloudPlaces::CloudPlaces(const Mesh& cloud) {
    std::vector<std::uint32_t> order(cloud.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&cloud](std::uint32_t a, std::uint32_t b) {
        const Vec3f p = cloud.vertices[a], q = cloud.vertices[b];
        return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
    });
    of_vertex_.resize(cloud.vertices.size());
    for (const std::uint32_t v : order) {
        if (at_.empty() || !(at_.back() == cloud.vertices[v])) {
            at_.push_back(cloud.vertices[v]);
            vertex_.push_back(v);
        }
        of_vertex_[v] = static_cast<std::uint32_t>(at_.size() - 1);
    }
    if (!at_.empty()) tree_ = std::make_unique<Tree>(at_);
}

CloudPlaces::~CloudPlaces() = default;

CloudPlaces::Neighbours CloudPlaces::nearest(std::size_t place, std::size_t count) const {
    std::array<std::uint32_t, kMostNeighbours + 1> index{};
    std::array<double, kMostNeighbours + 1> squared{};
    const Vec3d p = position(place);
    const std::array<double, 3> query = {p.x, p.y, p.z};
    const std::size_t wanted = std::min(std::min(count, kMostNeighbours) + 1, size());  // and itself
    tree_->index.knnSearch(query.data(), wanted, index.data(), squared.data());
    Neighbours found;
    found.count = wanted - 1;
    std::copy_n(index.begin() + 1, found.count, found.place.begin());
    std::copy_n(squared.begin() + 1, found.count, found.squared.begin());
    return found;
}

}  // namespace snug

#include "snug/search/extreme_points.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "snug/search/turn.h"

namespace snug {
namespace {

constexpr std::uint64_t kRotations = 48;  ///< of which each gives six directions

}  // namespace

ExtremePoints::ExtremePoints(const Mesh& mesh) : mesh_(mesh) {
    for (std::uint64_t i = 0; i < kRotations; ++i) add_furthest(rotation_of(spread_turn(i, 0)));
    add_furthest(Rotation{});
}

void ExtremePoints::add(Vec3d direction) {
    std::size_t furthest = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
        const double reached = dot(direction, vec_cast<double>(mesh_.vertices[i]));
        if (reached > most) {
            most = reached;
            furthest = i;
        }
    }
    const auto place = std::lower_bound(known_.begin(), known_.end(), furthest);
    if (place != known_.end() && *place == furthest) return;
    known_.insert(place, furthest);
    const Vec3d point = vec_cast<double>(mesh_.vertices[furthest]);
    x_.push_back(point.x);
    y_.push_back(point.y);
    z_.push_back(point.z);
}

Box3d ExtremePoints::turned(const Rotation& rotation) const {
    Box3d result;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3d row = rotation.row[static_cast<std::size_t>(axis)];
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            const double reached = row.x * x_[i] + row.y * y_[i] + row.z * z_[i];
            low = reached < low ? reached : low;
            high = reached > high ? reached : high;
        }
        result.min[axis] = low;
        result.max[axis] = high;
    }
    return result;
}

std::vector<Vec3d> ExtremePoints::points() const {
    std::vector<Vec3d> result;
    for (std::size_t i = 0; i < x_.size(); ++i) result.push_back({x_[i], y_[i], z_[i]});
    return result;
}

void ExtremePoints::add_furthest(const Rotation& rotation) {
    for (const Vec3d& row : rotation.row) {
        add(row);
        add(-row);
    }
}

}  // namespace snug

#include "snug/object/triangle_groups.h"

#include <array>
#include <cmath>

namespace snug {
namespace {

/// More than rounding does to placed coordinates, in shares of their size (and in mm).
constexpr double kRounding = 1e-9;

}  // namespace

// Four corners at a time, which the compiler turns into a few vector instructions.
Box3d box_of(TriangleGroup group) {
    constexpr std::size_t kLanes = 12;
    const std::size_t corners = group.size() * 3;
    const auto corner = [&](std::size_t i) -> const Vec3f& { return group[i / 3][i % 3]; };
    Box3d box;
    std::size_t at = 0;
    if (corners >= 4) {
        static_assert(sizeof(TriangleStream::Corners) == 9 * sizeof(float));
        const float* const values = &group[0][0].x;
        std::array<float, kLanes> low, high;
        for (std::size_t lane = 0; lane < kLanes; ++lane) low[lane] = high[lane] = values[lane];
        for (at = 4; at + 4 <= corners; at += 4)
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const float value = values[3 * at + lane];
                low[lane] = value < low[lane] ? value : low[lane];
                high[lane] = value > high[lane] ? value : high[lane];
            }
        for (std::size_t lane = 0; lane < kLanes; lane += 3) {
            box.include(vec_cast<double>(Vec3f{low[lane], low[lane + 1], low[lane + 2]}));
            box.include(vec_cast<double>(Vec3f{high[lane], high[lane + 1], high[lane + 2]}));
        }
    }
    for (; at < corners; ++at) box.include(vec_cast<double>(corner(at)));
    return box;
}

Box3d in_object(const FileToObject& object, const Box3d& box) {
    return {vec_cast<double>(object(vec_cast<float>(box.min))),
            vec_cast<double>(object(vec_cast<float>(box.max)))};
}

Box3d reached(const Rotation& rotation, Vec3d shift, const Box3d& box) {
    const Vec3d centre = box.centre(), half = box.size() * 0.5;
    Box3d result;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3d row = rotation.row[static_cast<std::size_t>(axis)];
        const Vec3d size{std::fabs(row.x), std::fabs(row.y), std::fabs(row.z)};
        const double middle = dot(row, centre) + shift[axis];
        const double extent = dot(size, half);
        const double far = dot(size, {std::fabs(centre.x), std::fabs(centre.y), std::fabs(centre.z)});
        const double slack = kRounding * (1 + far + extent + std::fabs(shift[axis]));
        result.min[axis] = middle - extent - slack;
        result.max[axis] = middle + extent + slack;
    }
    return result;
}

void mark_group(MetCubes& cubes, const FileToObject& object, TriangleGroup group, const Box3d& box) {
    if (cubes.mark_if_small(box)) return;
    if (group.size() == 1) {
        cubes.mark({vec_cast<double>(object(group[0][0])), vec_cast<double>(object(group[0][1])),
                    vec_cast<double>(object(group[0][2]))});
        return;
    }
    const std::size_t half = group.size() / 2;
    for (const auto part : {group.first(half), group.subspan(half)})
        mark_group(cubes, object, part, in_object(object, box_of(part)));
}

}  // namespace snug

#include "snug/depth/streamed_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/depth/depth_builder.h"

namespace snug {
namespace {

using Corners = TriangleStream::Corners;

/// Triangles that are looked at together: scanners write neighbours one after the other, so a box around a
/// few tells most often that none of them changes anything.
constexpr std::size_t kGroup = 64;
/// Where a group's box meets more columns than this, its triangles are looked at one by one.
constexpr int kMostColumns = 64;
/// More than rounding does to placed coordinates and crossings, in shares of their size (and in mm).
constexpr double kRounding = 1e-9;

/// The box of coordinates as the file has them. Four corners at a time, which the compiler turns into a few
/// vector instructions.
Box3d box_of(std::span<const Corners> group) {
    constexpr std::size_t kLanes = 12;
    const std::size_t corners = group.size() * 3;
    const auto corner = [&](std::size_t i) -> const Vec3f& { return group[i / 3][i % 3]; };
    Box3d box;
    std::size_t at = 0;
    if (corners >= 4) {
        static_assert(sizeof(Corners) == 9 * sizeof(float));
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

/// Of a box of floats. Rounding keeps the order of numbers, so the result holds every corner of the group as
/// the object has it.
Box3d in_object(const FileToObject& object, const Box3d& box) {
    return {vec_cast<double>(object(vec_cast<float>(box.min))),
            vec_cast<double>(object(vec_cast<float>(box.max)))};
}

/// What a box may reach once it is turned and shifted, with all that rounding does.
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

bool holds(const Box3d& outer, const Box3d& inner) {
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
           outer.max.x >= inner.max.x && outer.max.y >= inner.max.y && outer.max.z >= inner.max.z;
}

/// Whether nothing within the placed box changes a depth.
bool changes_nothing(const DepthMapBuilder& builder, const Box3d& placed) {
    const CellRange j = builder.rows().meeting(placed.min.y, placed.max.y);
    const CellRange k = builder.columns().meeting(placed.min.z, placed.max.z);
    if ((j.last - j.first + 1) * (k.last - k.first + 1) > kMostColumns) return false;
    for (int row = j.first; row <= j.last; ++row)
        for (int column = k.first; column <= k.last; ++column) {
            const DepthRange& depth = builder.depths()(row, column);
            if (depth.lowest > placed.min.x || depth.highest < placed.max.x) return false;
        }
    return true;
}

void add_triangle(DepthMapBuilder& builder, const FileToObject& object, const Placement& placement,
                  const Corners& corners) {
    std::array<Vec3d, 3> placed;
    std::array<VertexCell, 3> cells;
    for (std::size_t i = 0; i < 3; ++i) {
        placed[i] = placement(object(corners[i]));
        cells[i] = builder.add_vertex(placed[i]);
    }
    const bool one_cell = cells[0].one() && cells[0] == cells[1] && cells[0] == cells[2];
    if (!one_cell) builder.add_triangle(placed);
}

/// By halves, until each lies within a few cubes. `box` is the group's.
void mark_group(MetCubes& cubes, const FileToObject& object, std::span<const Corners> group,
                const Box3d& box) {
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

/// Calls visit(group) for the groups of a piece.
template <class Visit>
void for_groups(std::span<const Corners> piece, const Visit& visit) {
    for (std::size_t at = 0; at < piece.size(); at += kGroup)
        visit(piece.subspan(at, std::min(kGroup, piece.size() - at)));
}

}  // namespace

Result<StreamedBounds> streamed_bounds(const TriangleStream& stream, const FileToObject& object,
                                       const Rotation& rotation, const Progress& progress) {
    std::vector<StreamedBounds> workers(worker_count());
    const auto done = stream.pass(
        [&](std::span<const Corners> piece, std::size_t worker) {
            StreamedBounds own = workers[worker];
            own.triangles += piece.size();
            for_groups(piece, [&](std::span<const Corners> group) {
                const Box3d box = box_of(group);
                own.file.include(box);
                if (holds(own.turned, reached(rotation, {}, in_object(object, box)))) return;
                for (const Corners& corners : group)
                    for (const Vec3f& corner : corners)
                        own.turned.include(rotation(vec_cast<double>(object(corner))));
            });
            workers[worker] = own;
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    StreamedBounds all;
    for (const StreamedBounds& own : workers) {
        all.file.include(own.file);
        all.turned.include(own.turned);
        all.triangles += own.triangles;
    }
    return all;
}

Result<DepthMap> depth_map(const TriangleStream& stream, const FileToObject& object,
                           const Placement& placement, const DesignSpace& space, Reach reach, MetCubes* cubes,
                           const Progress& progress) {
    DepthMapBuilder whole(space, reach);
    std::vector<std::unique_ptr<DepthMapBuilder>> workers(worker_count());
    const auto done = stream.pass(
        [&](std::span<const Corners> piece, std::size_t worker) {
            if (!workers[worker]) workers[worker] = std::make_unique<DepthMapBuilder>(space, reach);
            DepthMapBuilder& own = *workers[worker];
            for_groups(piece, [&](std::span<const Corners> group) {
                const Box3d box = in_object(object, box_of(group));
                if (cubes != nullptr) mark_group(*cubes, object, group, box);
                if (changes_nothing(own, reached(placement.rotation, placement.shift, box))) return;
                for (const Corners& corners : group) add_triangle(own, object, placement, corners);
            });
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    for (const auto& own : workers)
        if (own) whole.include(*own);
    return whole.take();
}

Result<void> mark_cubes(const TriangleStream& stream, const FileToObject& object, MetCubes& cubes,
                        const Progress& progress) {
    return stream.pass(
        [&](std::span<const Corners> piece, std::size_t) {
            for_groups(piece, [&](std::span<const Corners> group) {
                mark_group(cubes, object, group, in_object(object, box_of(group)));
            });
        },
        progress);
}

}  // namespace snug

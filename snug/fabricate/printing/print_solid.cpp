#include "snug/fabricate/printing/print_solid.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/rotation.h"
#include "snug/polygon/lattice.h"
#include "snug/solid/solid_faces.h"

namespace snug {
namespace {

/// A bore in one part, in that part's own coordinates: levels, y and z in mm from its first corner.
struct PartBore {
    FaceOpening opening;
    Vec3d centre_mm;
    bool after = false;  ///< the part begins at the cut
};

Vec3d first_corner(const PrintPart& part, Vec3d block) {
    return {part.first.x * block.x, part.first.y * block.y, part.first.z * block.z};
}

PartBore part_bore(const Bore& bore, const PrintPart& part, bool after, Vec3d block, double radius) {
    PartBore result;
    result.after = after;
    result.centre_mm = bore.centre_mm - first_corner(part, block);
    result.opening.axis = bore.axis;
    result.opening.plane = bore.plane - part.first[bore.axis];
    const PlaneAxes axes = plane_axes(bore.axis);
    const Vec3i steps = block_steps(block);
    const auto begin = [&](int a) {
        return static_cast<int>(std::floor((result.centre_mm[a] - radius) / block[a] * steps[a])) - 1;
    };
    const auto end = [&](int a) {
        return static_cast<int>(std::ceil((result.centre_mm[a] + radius) / block[a] * steps[a])) + 1;
    };
    result.opening.row_begin = begin(axes.row);
    result.opening.row_end = end(axes.row);
    result.opening.position_begin = begin(axes.position);
    result.opening.position_end = end(axes.position);
    return result;
}

FaceOpening opening_of(const SunkLetters& letters) {
    return {0,
            letters.level,
            letters.box.least.y,
            letters.box.greatest.y,
            letters.box.least.z,
            letters.box.greatest.z,
            0};
}

/// In the part's own coordinates; made one after another: corners of the solid, then of openings, then bores
/// and letters.
class PartBuilder {
  public:
    PartBuilder(const PrintPart& part, Vec3d block_mm)
        : part_(part), block_(block_mm), block_steps_(block_steps(block_mm)) {}

    void add_foam(std::vector<PartBore>& bores, std::span<const SunkLetters> letters) {
        const SolidCorners corners(part_.runs);
        for (const Vec3i p : corners.points()) points.push_back(in_mm(vec_cast<double>(p)));
        std::vector<FaceOpening> openings;
        for (PartBore& bore : bores) {
            bore.opening.first_vertex = static_cast<std::uint32_t>(points.size());
            add_corners(bore.opening);
            openings.push_back(bore.opening);
        }
        first_letters_ = static_cast<std::uint32_t>(points.size());
        for (const SunkLetters& sunk : letters) {
            openings.push_back(opening_of(sunk));
            openings.back().first_vertex = static_cast<std::uint32_t>(points.size());
            add_corners(openings.back());
        }
        add_faces(part_.runs, corners, openings, block_steps_, triangles);
    }

    void add_bore(const PartBore& bore, double radius, double depth) {
        const auto mouth = static_cast<std::uint32_t>(points.size());
        for (const double along : {0.0, bore.after ? depth : -depth})
            for (Vec3d at : bore_ring(bore.opening.axis, bore.centre_mm, radius)) {
                at[bore.opening.axis] = bore.opening.plane * block_[bore.opening.axis] + along;
                points.push_back(at);
            }
        snug::add_bore({bore.opening.first_vertex, mouth, mouth + kBoreSides}, bore.opening.axis, bore.after,
                       triangles);
    }

    /// The letters that were given with the foam, the how manieth they were.
    void add_letters(const SunkLetters& letters, std::size_t place) {
        const SunkFaces faces = sunk_faces(letters, first_letters_ + static_cast<std::uint32_t>(4 * place),
                                           static_cast<std::uint32_t>(points.size()));
        for (const SunkPoint& point : faces.points) {
            Vec3d at =
                in_mm({static_cast<double>(letters.level), static_cast<double>(point.at.y) / block_steps_.y,
                       static_cast<double>(point.at.z) / block_steps_.z});
            if (point.floor) at.x -= letters.depth_mm;
            points.push_back(at);
        }
        triangles.insert(triangles.end(), faces.triangles.begin(), faces.triangles.end());
    }

    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;

  private:
    [[nodiscard]] Vec3d in_mm(Vec3d blocks) const {
        return {blocks.x * block_.x, blocks.y * block_.y, blocks.z * block_.z};
    }

    void add_corners(const FaceOpening& opening) {
        const PlaneAxes axes = plane_axes(opening.axis);
        for (const int row : {opening.row_begin, opening.row_end})
            for (const int position : {opening.position_begin, opening.position_end}) {
                Vec3d at;
                at[opening.axis] = opening.plane;
                at[axes.row] = static_cast<double>(row) / block_steps_[axes.row];
                at[axes.position] = static_cast<double>(position) / block_steps_[axes.position];
                points.push_back(in_mm(at));
            }
    }

    const PrintPart& part_;
    Vec3d block_;
    Vec3i block_steps_;
    std::uint32_t first_letters_ = 0;  // the first vertex of their rectangles, four each
};

Solid moved_to_corner(const std::vector<Vec3d>& points, std::vector<Triangle> triangles) {
    Box3d box;
    for (const Vec3d& p : points) box.include(p);
    Solid solid{{}, std::move(triangles)};
    solid.vertices.reserve(points.size());
    for (const Vec3d& p : points) solid.vertices.push_back(vec_cast<float>(p - box.min));
    return solid;
}

}  // namespace

Vec3i block_steps(Vec3d block_mm) {
    Vec3i steps;
    for (int axis = 0; axis < 3; ++axis) steps[axis] = static_cast<int>(in_steps(block_mm[axis]));
    return steps;
}

Solid part_solid(const PrintLayout& layout, int index, std::span<const Bore> bores, Vec3d block_mm,
                 const PrintOptions& options, PrintPose pose, std::span<const SunkLetters> letters) {
    const PrintPart& part = layout.parts[static_cast<std::size_t>(index)];
    const double radius = bore_corner_radius_mm(options), depth = bore_depth_mm(options);
    std::vector<PartBore> own;
    for (const Bore& bore : bores) {
        if (bore.before == index) own.push_back(part_bore(bore, part, false, block_mm, radius));
        if (bore.after == index) own.push_back(part_bore(bore, part, true, block_mm, radius));
    }
    PartBuilder builder(part, block_mm);
    builder.add_foam(own, letters);
    for (const PartBore& bore : own) builder.add_bore(bore, radius, depth);
    for (std::size_t i = 0; i < letters.size(); ++i) builder.add_letters(letters[i], i);
    for (Vec3d& p : builder.points) p = on_bed(p, pose);
    if (pose.lid)
        for (Triangle& t : builder.triangles) std::swap(t[1], t[2]);
    return moved_to_corner(builder.points, std::move(builder.triangles));
}

Solid dowel_solid(const PrintOptions& options) {
    const double radius = options.dowel_diameter_mm / 2;
    std::vector<Vec3d> points;
    for (const double x : {0.0, options.dowel_length_mm})
        for (int i = 0; i < kBoreSides; ++i) {
            const SineCosine turn = sine_cosine_degrees(360.0 / kBoreSides * (i + 0.5));  // a side is below
            points.push_back({x, radius * turn.cosine, radius * turn.sine});
        }
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < kBoreSides; ++i) {
        const std::uint32_t next = (i + 1) % kBoreSides, end = kBoreSides;
        triangles.push_back({i, next, end + next});
        triangles.push_back({i, end + next, end + i});
        if (i < 2) continue;
        triangles.push_back({0, i, i - 1});
        triangles.push_back({end, end + i - 1, end + i});
    }
    return moved_to_corner(points, std::move(triangles));
}

}  // namespace snug

#include "snug/picture/fall_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "snug/drawing/page_builder.h"
#include "snug/drawing/svg.h"
#include "snug/picture/isometric.h"
#include "snug/picture/object_outlines.h"

namespace snug {
namespace {

constexpr double kFinestShare = 0.004;  // of the case's longest side
constexpr double kAbove = 0.16;         // of the rectangle's height, for the way that it falls
constexpr double kBelow = 0.12;         // for what it falls through yet, and the ground
constexpr double kTint = 0.55;          // of white in a piece's colour
constexpr Color kLines{44, 54, 66}, kGround{107, 118, 134}, kItem{250, 248, 243};

Vec3d along(int axis, double by) {
    Vec3d v{};
    v[axis] = by;
    return v;
}

/// Axes of the page in the case: the side's own down is down, and the viewer stands at the front, or at the
/// right where the case falls on its back or front.
struct View {
    Vec3d right, up;

    explicit View(Side face) {
        const int axis = face / 2;
        up = along(axis, face % 2 == 1 ? -1 : 1);
        right = cross(up, along(axis == 1 ? 2 : 1, 1));
    }
    [[nodiscard]] Vec2d at(Vec3d v) const { return {dot(right, v), -dot(up, v)}; }
};

std::vector<Loop> item_outlines(std::span<const FallingMesh> meshes, const View& view, double finest_mm) {
    std::vector<Loop> outlines;
    for (const FallingMesh& each : meshes) {
        std::vector<Projected> points;
        points.reserve(each.mesh.vertices.size());
        for (const Vec3f& vertex : each.mesh.vertices) points.push_back({view.at(each.placement(vertex)), 0});
        if (points.empty()) continue;
        for (Loop& loop : object_outlines(points, each.mesh.triangles, {}, finest_mm).whole)
            outlines.push_back(std::move(loop));
    }
    return outlines;
}

/// Each piece of foam from its lowest parting to its highest.
std::vector<FallPicture::Band> bands(const Foams& foams, const DesignSpace& space, const View& view) {
    const Vec3d half = space.size() * 0.5;
    std::vector<FallPicture::Band> all;
    for (const Piece piece : foams.all()) {
        const auto level = [&](int i) { return space.face(0, foams.parting[static_cast<std::size_t>(i)]); };
        const double low = piece.index == 0 ? -half.x : level(piece.index - 1);
        const double high =
            piece.index < static_cast<int>(foams.parting.size()) ? level(piece.index) : half.x;
        const auto corner = [&](double x, double y, double z) {
            return view.at({x, y * half.y, z * half.z});
        };
        // Two opposite corners of the block: across the way that it is seen, both are the same.
        const Vec2d a = corner(low, -1, -1), b = corner(high, 1, 1);
        all.push_back({piece, {a, {b.x, a.y}, b, {a.x, b.y}}});
    }
    return all;
}

/// Where the middle of the case lies in a rectangle.
Vec2d middle_in(const FallPicture& picture, double scale, Vec2d size) {
    return {size.x / 2, size.y * (1 - kBelow) - picture.size.y * scale / 2};
}

FallShape ground(Vec2d size) {
    const double y = size.y * 0.975;
    return {{{{0, y}, {size.x, y}}}, false, {}, kGround, 2.5};
}

/// Two short lines above the case and an arrow into the ground's way.
FallShape motion(const FallPicture& picture, double scale, Vec2d size) {
    const double top = middle_in(picture, scale, size).y - picture.size.y * scale / 2;
    const double length = std::min(size.y * kAbove * 0.8, top * 0.8), gap = size.y * 0.03;
    const double head = length * 0.34, x = size.x / 2, side = picture.size.x * scale * 0.28;
    FallShape shape{{}, false, {}, kGround, 1.6};
    for (const double beside : {-side, side})
        shape.loops.push_back({{x + beside, top - gap - length * 0.75}, {x + beside, top - gap}});
    shape.loops.push_back({{x, top - gap - length}, {x, top - gap}});
    shape.loops.push_back({{x - head, top - gap - head}, {x, top - gap}, {x + head, top - gap - head}});
    return shape;
}

}  // namespace

std::vector<FallPicture> fall_pictures(const Foams& foams, const DesignSpace& space,
                                       std::span<const FallingMesh> meshes) {
    const Vec3d whole = space.size();
    const double finest = kFinestShare * std::max({whole.x, whole.y, whole.z});
    std::vector<FallPicture> pictures;
    for (const Side face : {kFloor, kRoof, kBack, kFront, kLeft, kRight}) {
        const View view(face);
        const Vec2d corner = view.at(whole);
        pictures.push_back({face,
                            {std::abs(corner.x), std::abs(corner.y)},
                            bands(foams, space, view),
                            item_outlines(meshes, view, finest)});
    }
    return pictures;
}

double fall_scale(std::span<const FallPicture> pictures, Vec2d size) {
    double scale = 1e9;
    for (const FallPicture& picture : pictures)
        scale = std::min({scale, size.x / picture.size.x, size.y * (1 - kAbove - kBelow) / picture.size.y});
    return scale;
}

std::vector<FallShape> fall_shapes(const FallPicture& picture, double scale, Vec2d size) {
    const Vec2d middle = middle_in(picture, scale, size);
    const auto placed = [&](Loop loop) {
        for (Vec2d& point : loop) point = middle + point * scale;
        return loop;
    };
    std::vector<FallShape> shapes{ground(size), motion(picture, scale, size)};
    for (const FallPicture::Band& band : picture.foams)
        shapes.push_back(
            {{placed(band.outline)}, true, mixed(piece_color(band.piece), kWhite, kTint), kLines, 1});
    if (picture.items.empty()) return shapes;
    FallShape items{{}, true, kItem, kLines, 1.2};
    for (const Loop& loop : picture.items) items.loops.push_back(placed(loop));
    shapes.push_back(std::move(items));
    return shapes;
}

}  // namespace snug

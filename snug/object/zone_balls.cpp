#include "snug/object/zone_balls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "snug/mesh/triangle_tree.h"

namespace snug {
namespace {

Box3d box_around(const ZoneBalls::Corners& corners) {
    Box3d box;
    for (const Vec3d corner : corners) box.include(corner);
    return box;
}

double square_of(Vec3d v) {
    return dot(v, v);
}

}  // namespace

ZoneBalls::ZoneBalls(const Zone& zone, Vec3d origin, double grown_mm) {
    for (const Zone::Ball& ball : zone.balls)
        balls_.push_back({ball.centre - origin, ball.radius_mm + grown_mm});
    std::stable_sort(balls_.begin(), balls_.end(),
                     [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
    std::vector<Ball> outermost;
    for (const Ball& ball : balls_) {
        const bool within = std::any_of(outermost.begin(), outermost.end(), [&](const Ball& other) {
            const double room = other.radius - ball.radius;
            return square_of(ball.centre - other.centre) <= room * room;
        });
        if (!within) outermost.push_back(ball);
    }
    balls_ = std::move(outermost);
    for (const Ball& ball : balls_) {
        const Vec3d r{ball.radius, ball.radius, ball.radius};
        bounds_.include(ball.centre - r);
        bounds_.include(ball.centre + r);
    }
    if (balls_.empty()) return;
    cell_mm_ = bounds_.size() * (1.0 / kCells);
    in_cell_.resize(static_cast<std::size_t>(kCells) * kCells * kCells);
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        const Vec3d r{balls_[i].radius, balls_[i].radius, balls_[i].radius};
        const auto [x0, y0, z0, x1, y1, z1] = cells({balls_[i].centre - r, balls_[i].centre + r});
        for (std::int32_t x = x0; x <= x1; ++x)
            for (std::int32_t y = y0; y <= y1; ++y)
                for (std::int32_t z = z0; z <= z1; ++z)
                    in_cell_[static_cast<std::size_t>((x * kCells + y) * kCells + z)].push_back(
                        static_cast<std::uint16_t>(i));
    }
}

std::array<std::int32_t, 6> ZoneBalls::cells(const Box3d& box) const {
    const auto cell = [&](double at, int axis) {
        const double cells = std::floor((at - bounds_.min[axis]) / cell_mm_[axis]);
        return static_cast<std::int32_t>(std::clamp(cells, 0.0, kCells - 1.0));
    };
    return {cell(box.min.x, 0), cell(box.min.y, 1), cell(box.min.z, 2),
            cell(box.max.x, 0), cell(box.max.y, 1), cell(box.max.z, 2)};
}

template <class Visit>
bool ZoneBalls::any_near(const Box3d& box, Visit visit) const {
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.min[axis] <= bounds_.max[axis] && box.max[axis] >= bounds_.min[axis])) return false;
    const auto [x0, y0, z0, x1, y1, z1] = cells(box);
    for (std::int32_t x = x0; x <= x1; ++x)
        for (std::int32_t y = y0; y <= y1; ++y)
            for (std::int32_t z = z0; z <= z1; ++z)
                for (const std::uint16_t i :
                     in_cell_[static_cast<std::size_t>((x * kCells + y) * kCells + z)])
                    if (visit(balls_[i])) return true;
    return false;
}

bool ZoneBalls::meet(const Corners& triangle) const {
    return any_near(box_around(triangle), [&](const Ball& ball) {
        const Vec3d nearest = nearest_on_triangle(triangle[0], triangle[1], triangle[2], ball.centre);
        return square_of(nearest - ball.centre) <= ball.radius * ball.radius;
    });
}

bool ZoneBalls::meet(Vec3d centre, double radius) const {
    const Vec3d r{radius, radius, radius};
    return any_near({centre - r, centre + r}, [&](const Ball& ball) {
        const double reach = ball.radius + radius;
        return square_of(centre - ball.centre) <= reach * reach;
    });
}

void ZoneBalls::add_pieces(const Corners& triangle, std::vector<Corners>& pieces) const {
    double smallest = 0;
    bool within = false;
    (void)any_near(box_around(triangle), [&](const Ball& ball) {
        const Vec3d nearest = nearest_on_triangle(triangle[0], triangle[1], triangle[2], ball.centre);
        if (square_of(nearest - ball.centre) > ball.radius * ball.radius) return false;
        smallest = smallest == 0 ? ball.radius : std::min(smallest, ball.radius);
        within = std::all_of(triangle.begin(), triangle.end(), [&](Vec3d corner) {
            return square_of(corner - ball.centre) <= ball.radius * ball.radius;
        });
        return within;
    });
    if (smallest == 0) return;
    int longest = 0;
    double length = 0;
    for (int i = 0; i < 3; ++i) {
        const double edge = square_of(triangle[static_cast<std::size_t>((i + 1) % 3)] -
                                      triangle[static_cast<std::size_t>(i)]);
        if (edge <= length) continue;
        length = edge;
        longest = i;
    }
    const double fine = std::max(1.0, smallest / 256);
    if (within || length <= fine * fine) return pieces.push_back(triangle);
    const auto corner = [&](int i) { return triangle[static_cast<std::size_t>((longest + i) % 3)]; };
    const Vec3d middle = (corner(0) + corner(1)) * 0.5;
    add_pieces({corner(0), middle, corner(2)}, pieces);
    add_pieces({middle, corner(1), corner(2)}, pieces);
}

}  // namespace snug

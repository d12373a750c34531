#include "snug/search/objective.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "snug/search/extreme_points.h"

namespace snug {
namespace {

constexpr double kBearing = 3;           // mm
constexpr double kTouchingShare = 0.01;  // of the object's length

/// Twice the area on which o, a and b lie, counter-clockwise in y-z.
double turn_left(Vec3d o, Vec3d a, Vec3d b) {
    return (a.y - o.y) * (b.z - o.z) - (a.z - o.z) * (b.y - o.y);
}

/// The convex hull in y-z, counter-clockwise (Andrew 1979).
std::vector<Vec3d> hull(std::vector<Vec3d> points) {
    std::sort(points.begin(), points.end(), [](Vec3d a, Vec3d b) {
        if (a.y != b.y) return a.y < b.y;
        return a.z != b.z ? a.z < b.z : a.x < b.x;
    });
    std::vector<Vec3d> result;
    for (const bool upper : {false, true}) {
        const std::size_t first = result.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3d p = upper ? points[points.size() - 1 - i] : points[i];
            while (result.size() >= first + 2 && turn_left(result[result.size() - 2], result.back(), p) <= 0)
                result.pop_back();
            result.push_back(p);
        }
        result.pop_back();
    }
    return result;
}

/// How far a point lies inside a hull, in y-z; below 0 outside it.
double inside(Vec3d p, const std::vector<Vec3d>& corners) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = corners[i], b = corners[(i + 1) % corners.size()];
        const double dy = b.y - a.y, dz = b.z - a.z;
        const double length = std::sqrt(dy * dy + dz * dz);
        if (length > 0) least = std::min(least, turn_left(a, b, p) / length);
    }
    return std::isinf(least) ? 0 : least;
}

Vec3d centre_of_surface(const Mesh& mesh) {
    Vec3d sum;
    double area = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = vec_cast<double>(mesh.vertices[t[0]]), b = vec_cast<double>(mesh.vertices[t[1]]),
                    c = vec_cast<double>(mesh.vertices[t[2]]);
        const Vec3d normal = cross(b - a, c - a);
        const double size = std::sqrt(dot(normal, normal));
        area += size;
        sum = sum + (a + b + c) * (size / 3);
    }
    return area > 0 ? sum * (1 / area) : bounds(mesh).centre();
}

}  // namespace

PlacementMeasures measures(const ExactCut& exact, const DesignSpace& space) {
    PlacementMeasures result;
    result.cut_blocks = static_cast<double>(exact.cut_blocks);
    double gaps = 0, ends = 0, bearing = 0;
    const DepthMap& lower = exact.depths.lower.depths;
    const DepthMap& upper = exact.depths.upper ? exact.depths.upper->depths : lower;
    const auto count = [&](double gap) {
        gaps += std::max(0.0, gap);
        bearing += gap <= kBearing;
        ends += 1;
    };
    int first = space.blocks.x, end = 0;
    for (std::size_t column = 0; column < exact.blocks.size(); ++column) {
        const CutRun run = exact.blocks[column];
        if (run.none()) continue;
        first = std::min(first, int{run.first});
        end = std::max(end, int{run.end});
        const DepthRange below = lower[column], above = upper[column];
        if (!below.none()) count(below.lowest - space.face(0, run.first));
        if (!above.none()) count(space.face(0, run.end) - above.highest);
    }
    if (ends == 0) return result;
    result.gap_mm = gaps / ends;
    result.bearing = bearing / ends;
    result.depth_mm = (end - first) * space.block_mm.x;
    return result;
}

Steadiness::Steadiness(const Mesh& mesh) : weight_(centre_of_surface(mesh)) {
    outermost_ = ExtremePoints(mesh).points();
    const Vec3d size = bounds(mesh).size();
    touching_ = kTouchingShare * std::sqrt(dot(size, size));
}

double Steadiness::operator()(const Rotation& rotation) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3d& p : outermost_) lowest = std::min(lowest, dot(rotation.row[0], p));
    std::vector<Vec3d> touching;
    for (const Vec3d& p : outermost_)
        if (dot(rotation.row[0], p) <= lowest + touching_) touching.push_back(rotation(p));
    const Vec3d weight = rotation(weight_);
    const double height = weight.x - lowest;
    const double margin = touching.size() < 3 ? 0 : inside(weight, hull(touching));
    const double slant = std::sqrt(height * height + margin * margin);
    return slant > 0 ? margin / slant : 0;
}

Score::Score(const std::array<double, kObjectives>& weight, const PlacementMeasures& start)
    : weight_(weight), start_(start) {}

double Score::operator()(const PlacementMeasures& at) const {
    const auto share = [](double value, double start) { return value / std::max(start, 1e-6); };
    const auto worst = [](const PlacementMeasures& of) {
        return *std::max_element(of.margins.begin(), of.margins.end());
    };
    const std::array<double, kObjectives> term{share(at.cut_blocks, start_.cut_blocks),
                                               share(at.gap_mm, start_.gap_mm),
                                               share(at.depth_mm, start_.depth_mm),
                                               1 - at.bearing,
                                               1 - at.steadiness,
                                               share(worst(at), worst(start_))};
    double sum = 0;
    for (std::size_t i = 0; i < kObjectives; ++i) sum += weight_[i] * term[i];
    return sum;
}

}  // namespace snug

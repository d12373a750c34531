#include "snug/check/stability.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/base/vec2.h"
#include "snug/polygon/convex_hull.h"
#include "snug/space/tray.h"

namespace snug {
namespace {

constexpr double kLeastTip = 20;       // degrees: a tray that is carried on one hand leans so much
constexpr double kRoundedAway = 0.05;  // mm
constexpr double kDegrees = 180 / 3.14159265358979323846;

/// Of each row's outermost columns that are cut below the surface: (y, z).
std::vector<Vec2d> rim_points(const BlockMap& cut, const DesignSpace& space, int level) {
    std::vector<Vec2d> points;
    for (int j = 0; j < cut.ny(); ++j) {
        int first = cut.nz(), end = 0;
        for (int k = 0; k < cut.nz(); ++k)
            if (cut(j, k).first < level && !cut(j, k).none()) {
                first = std::min(first, k);
                end = k + 1;
            }
        for (const int row : {j, j + 1})
            if (first < end) {
                points.push_back({space.face(1, row), space.face(2, first)});
                points.push_back({space.face(1, row), space.face(2, end)});
            }
    }
    return points;
}

}  // namespace

Vec3d centre_of_mass(const Object& object, const Placement& placement) {
    if (!object.measure.centre) return placement.bounds.centre();
    return placement.rotation(*object.measure.centre) + placement.shift;
}

std::optional<double> tip_angle_deg(const BlockMap& cut, const DesignSpace& space, int level, Vec3d centre) {
    const double above = centre.x - space.face(0, level);
    if (above <= 0) return {};
    const std::vector<Vec2d> points = rim_points(cut, space, level);
    if (points.empty()) return 0;
    const std::vector<Vec2d> hull = convex_hull(points);
    const Vec2d at{centre.y, centre.z};
    double inside = 1e300;  // from the weight to the nearest edge
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2d a = hull[i], b = hull[(i + 1) % hull.size()];
        inside = std::min(inside, turn(a, b, at) / length(b - a));
    }
    return std::max(0.0, std::atan2(inside, above) * kDegrees);
}

void find_tray_problems(const Item& item, double wanted_mm, const BlockMap& cut, int level,
                        const DesignSpace& space, std::vector<Finding>& findings) {
    const auto find = [&](Severity severity, Message message) {
        findings.push_back({severity, std::move(message), item.placement.bounds.centre()});
    };
    const bool pocket =
        std::any_of(cut.begin(), cut.end(), [&](CutRun run) { return !run.none() && run.first < level; });
    if (!pocket) return find(Severity::danger, say("no_pocket", {{"option", "--open"}}));
    if (item.tip_deg && *item.tip_deg < kLeastTip)
        find(Severity::warning,
             say("tips_out", {{"degrees", number(std::floor(*item.tip_deg), 0)}, {"option", "--open"}}));
    const double reached = reached_mm(item, level, space);
    if (reached < wanted_mm - kRoundedAway)
        find(Severity::warning,
             say("sunk_less", {{"mm", number(reached, 1)}, {"wanted_mm", number(wanted_mm, 1)}}));
}

}  // namespace snug

#include "snug/search/direction_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/foam/turned_bounds.h"
#include "snug/search/quick_cut.h"
#include "snug/search/turn.h"

namespace snug {
namespace {

constexpr double kPoints = 5000;
constexpr std::size_t kBatch = 64, kTask = 16;

/// Points of equal area on the half sphere x >= 0 (a Fibonacci lattice, Gonzalez 2010).
Vec3d half_sphere_point(std::size_t i, std::size_t count) {
    constexpr double kGoldenTurn = 0.61803398874989484820;
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const auto [sine, cosine] =
        sine_cosine_degrees(360 * std::fmod(kGoldenTurn * static_cast<double>(i), 1.0));
    const double r = std::sqrt(1 - x * x);
    return {x, r * cosine, r * sine};
}

/// Fractions that fill 0 to 1 evenly wherever they are broken off (van der Corput).
double spread_fraction(std::size_t i) {
    double result = 0;
    for (double share = 0.5; i > 0; i /= 2, share /= 2) result += static_cast<double>(i % 2) * share;
    return result;
}

/// Turns a direction onto +x, then about it.
Turn turn_onto_x(Vec3d direction, double spin_deg) {
    const Vec3d half{direction.x + 1, direction.y, direction.z};
    // Half a turn about the line between the two lays one on the other.
    return turn_about({1, 0, 0}, spin_deg) * turn_about(half, 180);
}

}  // namespace

DirectionMap::DirectionMap(const Mesh& mesh, const PreparedSurface& surface, const Design& design,
                           const DesignSpace& space, std::size_t directions)
    : surface_(surface), space_(space), cut_(design.cut) {
    least_wall_ = wanted_wall_mm(design.space);
    const Vec3d size = bounds(mesh).size();
    longest_ = std::sqrt(dot(size, size));
    const double area = surface_area(mesh);
    const double spacing = std::max(std::sqrt(area / kPoints), longest_ / 500);
    points_ = surface_points(mesh, spacing);
    for (std::size_t i = 0; i < directions; ++i) {
        DirectionCut cut;
        cut.direction = half_sphere_point(i, directions);
        cuts_.push_back(cut);
    }
}

void DirectionMap::step() {
    const std::size_t end = std::min(cuts_.size(), next_ + kBatch);
    const double spin = 180 * spread_fraction(passes_);  // half a turn more cuts the same
    parallel_for((end - next_ + kTask - 1) / kTask, [&](std::size_t task) {
        QuickCut quick(space_, cut_, least_wall_, longest_, 4, 8);
        const std::size_t first = next_ + task * kTask;
        for (std::size_t i = first; i < std::min(end, first + kTask); ++i) {
            DirectionCut& cut = cuts_[i];
            const Vec3d rotation_deg = euler_of(rotation_of(turn_onto_x(cut.direction, spin)));
            const Rotation rotation = rotation_from_euler(rotation_deg);
            const auto found = quick.least(points_, rotation, turned_bounds(surface_.body, rotation), 1);
            if (found.empty() || (cut.cut_blocks >= 0 && found.front().blocks >= cut.cut_blocks)) continue;
            cut.cut_blocks = found.front().blocks;
            cut.rotation_deg = rotation_deg;
            cut.offset_mm = found.front().offset_mm;
        }
    });
    next_ = end;
    if (next_ < cuts_.size()) return;
    next_ = 0;
    ++passes_;
}

}  // namespace snug

#include "snug/search/direction_map.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/object/turned_bounds.h"
#include "snug/search/searched_zones.h"
#include "snug/search/turn.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

constexpr double kPoints = 5000;
constexpr std::size_t kDirectionsABatch = 64, kTask = 16;
/// Offsets of one spin that are looked at exactly, at most: the points may promise too much.
constexpr std::size_t kMostExact = 4;

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

/// As people are shown it; never -0.
Vec3d to_thousandths(Vec3d v) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::floor(v[axis] * 1000 + 0.5) / 1000 + 0.0;
    return v;
}

/// Into half a block about 0.
double wrapped(double value, double block) {
    return value - block * std::floor(value / block + 0.5);
}

/// Holds an object of this length at every offset, with faces at the same places as any space of even counts.
DesignSpace roomy(double longest, Vec3d block_mm, const CutOptions& cut) {
    const Vec3d clearances = grown(Box3d{{}, {}}, cut.whole_clearance_mm()).size();
    Vec3i blocks;
    for (int axis = 0; axis < 3; ++axis)
        blocks[axis] = 2 * static_cast<int>(std::ceil((longest + clearances[axis]) / 2 / block_mm[axis])) + 4;
    return {blocks, block_mm};
}

}  // namespace

DirectionMap::DirectionMap(const Mesh& mesh, const PreparedSurface& surface, const Design& design,
                           const DesignSpace& space, std::size_t directions, Grid<Run> available,
                           std::vector<ItemZone> zones)
    : surface_(surface),
      design_(design),
      space_(space),
      available_(std::move(available)),
      zones_(std::move(zones)) {
    fitted_ = !design.space.blocks && !design.case_options.inside_mm;
    const Vec3d size = bounds(mesh).size();
    longest_ = std::sqrt(dot(size, size));
    // A fitted space has the walls by itself.
    if (fitted_)
        space_ = roomy(longest_, space.block_mm, design.cut);
    else
        least_wall_ = wanted_wall_mm(design.space);
    const double area = surface_area(mesh);
    const double spacing = std::max(std::sqrt(area / kPoints), longest_ / 500);
    points_ = surface_points(mesh, spacing);
    for (std::size_t i = 0; i < directions; ++i) {
        DirectionCut cut;
        cut.direction = half_sphere_point(i, directions);
        cuts_.push_back(cut);
    }
    promised_.assign(directions, -1);
}

void DirectionMap::step() {
    const std::size_t end = std::min(cuts_.size(), next_ + kDirectionsABatch);
    const double spin = 180 * spread_fraction(passes_);  // half a turn more cuts the same
    parallel_for((end - next_ + kTask - 1) / kTask, [&](std::size_t task) {
        QuickCut quick(space_, design_.cut, least_wall_, longest_, 4, 8);
        const std::size_t first = next_ + task * kTask;
        for (std::size_t i = first; i < std::min(end, first + kTask); ++i) {
            const Vec3d rotation_deg =
                to_thousandths(euler_of(rotation_of(turn_onto_x(cuts_[i].direction, spin))));
            const Rotation rotation = rotation_from_euler(rotation_deg);
            const Box3d turned = turned_bounds(surface_.body, rotation);
            // A space that is fitted has room for zones by itself, too.
            const Box3d kept_free =
                fitted_ ? Box3d{} : kept_free_by_zones(lying({rotation, {}, turned}, design_.cut, zones_));
            improve(i, rotation_deg, quick.least(points_, rotation, turned, kMostExact, kept_free));
        }
    });
    next_ = end;
    if (next_ < cuts_.size()) return;
    next_ = 0;
    ++passes_;
}

/// The surface is looked at where its points promise more than before, or where what they promised cannot be.
void DirectionMap::improve(std::size_t direction, const Vec3d& rotation_deg,
                           const std::vector<OffsetCut>& offsets) {
    DirectionCut& cut = cuts_[direction];
    long long& promised = promised_[direction];
    for (const OffsetCut& candidate : offsets) {
        if (promised >= 0 && candidate.blocks >= promised) return;
        const Vec3d offset_mm = to_thousandths(fitted_ ? offset_when_fitted(rotation_deg, candidate.offset_mm)
                                                       : candidate.offset_mm);
        const auto found = exact(rotation_deg, offset_mm);
        if (!found) continue;
        promised = candidate.blocks;
        if (cut.cut_blocks < 0 || found->cut_blocks < cut.cut_blocks)
            cut = {cut.direction, found->cut_blocks, rotation_deg, offset_mm};
        return;
    }
}

/// What the design makes of the placement; none where it does not fit or a wall is thinner than wanted.
std::optional<ExactCut> DirectionMap::exact(Vec3d rotation_deg, Vec3d offset_mm) const {
    const Vec3d lies = offset_mm + shift_between_walls(design_.space, !fitted_);
    std::optional<ExactCut> found;
    if (fitted_) {
        const auto own = fitted_space(rotation_deg, lies);
        if (!own) return {};
        found = exact_cut(surface_, own->space, design_.cut, rotation_deg, lies, own->available, zones_);
    } else {
        found = exact_cut(surface_, space_, design_.cut, rotation_deg, lies, available_, zones_);
    }
    if (found && !keeps_walls(found->wall_mm, wanted_wall_mm(design_.space))) return {};
    return found;
}

/// That of the design where the object lies so.
Result<PackedSpace> DirectionMap::fitted_space(Vec3d rotation_deg, Vec3d lies) const {
    return space_for(room_of(lying(surface_, design_.cut, zones_, rotation_deg, lies)),
                     design_.cut.whole_clearance_mm().least(), design_);
}

/// The offset at which the object meets the blocks of its fitted space as it meets those of space_: a fitted
/// space with an odd number of blocks begins half a block elsewhere, and further from its middle it has one
/// more.
Vec3d DirectionMap::offset_when_fitted(Vec3d rotation_deg, Vec3d offset_mm) const {
    const Vec3d shift = shift_between_walls(design_.space, false);
    const Vec3d block = space_.block_mm;
    Vec3d even, odd;
    for (int axis = 0; axis < 3; ++axis) {
        even[axis] = wrapped(offset_mm[axis] - shift[axis], block[axis]);
        odd[axis] = wrapped(offset_mm[axis] - shift[axis] - block[axis] / 2, block[axis]);
    }
    const auto own = fitted_space(rotation_deg, even + shift);
    if (!own) return even;
    Vec3d result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = own->space.blocks[axis] % 2 == 0 ? even[axis] : odd[axis];
    return result;
}

}  // namespace snug

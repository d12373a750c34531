#include "snug/check/gap_space.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace snug {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void add_obstacle(GapSpace::Probe& probe, Vec3d point) {
    probe.obstacles[static_cast<std::size_t>(probe.obstacle_count++)] = point;
}

}  // namespace

PrismField cut_field(const BlockMap& blocks, const DesignSpace& space) {
    int j_first = blocks.ny(), j_last = -1, k_first = blocks.nz(), k_last = -1;
    for (int j = 0; j < blocks.ny(); ++j) {
        for (int k = 0; k < blocks.nz(); ++k) {
            if (blocks(j, k).none()) continue;
            j_first = std::min(j_first, j);
            j_last = std::max(j_last, j);
            k_first = std::min(k_first, k);
            k_last = std::max(k_last, k);
        }
    }
    if (j_last < 0) return PrismField({}, 0, 1, 0, 1);
    Grid<PrismSpan> spans(j_last - j_first + 1, k_last - k_first + 1);
    for (int j = 0; j < spans.ny(); ++j) {
        for (int k = 0; k < spans.nz(); ++k) {
            const CutRun run = blocks(j_first + j, k_first + k);
            if (!run.none()) spans(j, k) = {space.face(0, run.first), space.face(0, run.end)};
        }
    }
    return PrismField(std::move(spans), space.face(1, j_first), space.block_mm.y, space.face(2, k_first),
                      space.block_mm.z);
}

GapSpace::GapSpace(const PrismField& cut, const TriangleTree& surface, std::span<const Vec3d> vertices,
                   const LineLattice& lattice, const PrismField* hull)
    : cut_(cut), surface_(surface), vertices_(vertices), lattice_(lattice), hull_(hull) {}

GapSpace::Probe GapSpace::probe(Vec3d p, double radius, double enough, const Surroundings& known) const {
    Probe probe;
    probe.surroundings = known;
    limit_by_foam(probe, p);
    if (probe.room > enough && hull_) limit_by_hull(probe, p, radius);
    if (probe.room > enough) limit_by_surface(probe, p, radius, enough, known);
    return probe;
}

void GapSpace::limit_by_foam(Probe& probe, Vec3d p) const {
    if (!cut_.contains(p)) {
        const NearestPoint cut = cut_.nearest_inside(p, kInfinity);
        probe.room = -cut.distance;
        probe.work += cut.looked_at;
        return;
    }
    const NearestPoint foam = cut_.nearest_outside(p, kInfinity);
    probe.room = foam.distance;
    probe.work += foam.looked_at;
    add_obstacle(probe, foam.point);
    // The wall on the other side: the foam nearest to the first wall's mirror image.
    const Vec3d mirrored = p + (p - foam.point);
    if (!cut_.contains(mirrored)) return add_obstacle(probe, mirrored);
    const NearestPoint opposite = cut_.nearest_outside(mirrored, kInfinity);
    add_obstacle(probe, opposite.point);
    probe.work += opposite.looked_at;
}

void GapSpace::limit_by_hull(Probe& probe, Vec3d p, double radius) const {
    if (hull_->contains(p)) {
        const NearestPoint outside = hull_->nearest_outside(p, radius);
        probe.room = std::min(probe.room, -outside.distance);
        probe.work += outside.looked_at;
        return;
    }
    const double at_most = std::max(probe.room, radius);
    const NearestPoint hull = hull_->nearest_inside(p, at_most);
    if (hull.distance < at_most) add_obstacle(probe, hull.point);
    probe.room = std::min(probe.room, hull.distance);
    probe.work += hull.looked_at;
}

void GapSpace::limit_by_surface(Probe& probe, Vec3d p, double radius, double enough,
                                const Surroundings& known) const {
    const double at_most = std::max(probe.room, radius);
    const NearestPoint surface = surface_.nearest(p, at_most, enough);
    probe.work += surface.looked_at;
    if (surface.distance < at_most) add_obstacle(probe, surface.point);
    if (surface.distance <= enough) {
        probe.room = surface.distance;
        return;
    }
    bool inside = false;
    if (!hull_) {
        // No surface between p and the point of which this is known: they lie on the same side.
        const Vec3d way = p - known.centre;
        inside = dot(way, way) < known.clear * known.clear ? known.inside : inside_object(p, probe.work);
    }
    probe.surroundings = {p, surface.distance, inside};
    probe.room = inside ? -surface.distance : std::min(probe.room, surface.distance);
}

bool GapSpace::inside_object(Vec3d p, std::uint32_t& work) const {
    const SnappedVertex here = lattice_.snap(p);
    // Snapping moves the point and each vertex by up to half a unit.
    const double dy = 2 * lattice_.mm_per_unit_y();
    const double dz = 2 * lattice_.mm_per_unit_z();
    const Box3d above{{p.x, p.y - dy, p.z - dz}, {kInfinity, p.y + dy, p.z + dz}};
    int winding = 0;
    work += surface_.for_each_near(above, [&](const Triangle& t) {
        const std::optional<Crossing> found =
            crossing(here.u, here.v, lattice_.snap(vertices_[t[0]]), lattice_.snap(vertices_[t[1]]),
                     lattice_.snap(vertices_[t[2]]));
        if (found && found->x > p.x) winding -= found->turn;
    });
    return winding != 0;
}

}  // namespace snug

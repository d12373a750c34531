#pragma once

#include <algorithm>
#include <vector>

#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/object/prepare.h"
#include "snug/space/design_space.h"

#include "tests/support/broken_foams.h"
#include "tests/support/fit_designs.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"
#include "tests/support/random_zone.h"
#include "tests/support/shapes.h"

// Random items with places that foam keeps away from.

namespace snug::test {

inline bool is_in(const Zone& zone, Vec3d p) {
    return std::any_of(zone.balls.begin(), zone.balls.end(), [&](const Zone::Ball& ball) {
        return dot(p - ball.centre, p - ball.centre) < ball.radius_mm * ball.radius_mm;
    });
}

/// Whether a block of the piece stands within `off` of a point along all axes, or where the point passes on
/// its way out of the piece: upwards from a piece below it, downwards from one above it.
inline bool stands_in_the_way(const Grid<Run>& piece, bool below, const DesignSpace& space, Vec3d p,
                              double off) {
    for (int j = 0; j < piece.ny(); ++j)
        for (int k = 0; k < piece.nz(); ++k) {
            const Run kept = piece(j, k);
            if (kept.none()) continue;
            const bool beside = space.face(1, j) >= p.y + off || space.face(1, j + 1) <= p.y - off ||
                                space.face(2, k) >= p.z + off || space.face(2, k + 1) <= p.z - off;
            if (beside) continue;
            if (below ? space.face(0, kept.end) > p.x - off : space.face(0, kept.first) < p.x + off)
                return true;
        }
    return false;
}

struct ZonedKit {
    Design design;
    std::vector<Object> objects;
};

/// One to four random soups with zones, in a fitted space or a case, in layers or a tray.
inline ZonedKit random_kit_with_zones(Random& random) {
    ZonedKit kit;
    Design& design = kit.design;
    design.object.units = Unit::mm;
    design.space.block_mm = {random.between(3, 20), random.between(4, 25), random.between(4, 25)};
    design.space.blocks.reset();
    design.cut.clearance_mm = random_clearance(random, design.space.block_mm);
    design.cut.cut_on_touch = random.chance(0.3);
    if (random.chance(0.5)) design.placement.rotation_deg = {random.between(-180, 180), 90, 0};
    if (random.chance(0.3)) design.fit.least_rib_mm = random.between(1, 40);
    if (random.chance(0.3)) design.fit.notches = NotchOptions{40, 25, 10, {}, {}, {}};
    if (random.chance(0.3)) design.fit.lift = LiftOptions{random.between(10, 60), random.between(5, 25)};
    if (random.chance(0.3)) design.space.open = random.between(0.3, 1);
    design.fit.settle = random.chance(0.5);
    if (random.chance(0.5)) design.fit.pads = PadOptions{random.between(1, 6), 0};
    const int items = random.integer(1, 4);
    design.items.clear();
    for (int i = 0; i < items; ++i) {
        const Vec3d size{random.between(20, 80), random.between(20, 90), random.between(20, 90)};
        kit.objects.push_back(prepare(random_soup(random, size, random.integer(3, 12)), design).value());
        ItemOptions item;
        item.object = i;
        item.layer = random.integer(1, std::min(i + 1, 2));
        if (random.chance(0.4)) item.rotation_deg = Vec3d{90, random.between(-90, 90), 0};
        for (int zone = random.integer(0, 2); zone > 0; --zone)
            item.zones.push_back(random_zone(random, kit.objects.back()));
        design.items.push_back(item);
    }
    return kit;
}

}  // namespace snug::test

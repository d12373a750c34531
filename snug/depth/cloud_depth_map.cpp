#include "snug/depth/cloud_depth_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "snug/depth/add_in_parallel.h"

namespace snug {
namespace {

/// From a value to the nearest in a cell.
double distance(const GrownCells& cells, int cell, double value) {
    return std::max({cells.low(cell) - value, value - cells.high(cell), 0.0});
}

void add_ball(DepthMapBuilder& builder, Vec3d centre, double radius) {
    const GrownCells& rows = builder.rows();
    const GrownCells& columns = builder.columns();
    const CellRange across = rows.meeting(centre.y - radius, centre.y + radius);
    const CellRange along = columns.meeting(centre.z - radius, centre.z + radius);
    for (int j = across.first; j <= across.last; ++j) {
        const double dy = distance(rows, j, centre.y);
        for (int k = along.first; k <= along.last; ++k) {
            const double dz = distance(columns, k, centre.z);
            const double left = radius * radius - (dy * dy + dz * dz);
            if (left < 0) continue;
            const double half_chord = std::sqrt(left);
            builder.depths()(j, k).include({centre.x - half_chord, centre.x + half_chord});
        }
    }
}

}  // namespace

DepthMap cloud_depth_map(const Mesh& cloud, std::span<const float> radius, const Placement& placement,
                         const DesignSpace& space, Reach reach) {
    DepthMapBuilder builder(space, reach);
    add_in_parallel(builder, cloud.vertices.size(), [&](DepthMapBuilder& own, std::size_t i) {
        add_ball(own, placement(cloud.vertices[i]), static_cast<double>(radius[i]));
    });
    return builder.take();
}

}  // namespace snug

#include "snug/object/prepare_cloud.h"

#include <cstddef>
#include <utility>

#include "snug/mesh/cap.h"
#include "snug/mesh/shell.h"
#include "snug/object/cloud_places.h"
#include "snug/object/cloud_rims.h"
#include "snug/object/point_radius.h"

namespace snug {
namespace {

Box3d ball(const PointBalls& balls, std::size_t point) {
    const Vec3d centre = vec_cast<double>(balls.cloud.vertices[point]);
    const auto r = static_cast<double>(balls.radius[point]);
    return {centre - Vec3d{r, r, r}, centre + Vec3d{r, r, r}};
}

/// Points in the same place have the same ball.
Mesh stand_in(const PointBalls& balls, const CloudPlaces& places) {
    Box3d box;
    for (std::size_t i = 0; i < places.size(); ++i) box.include(ball(balls, places.vertex_of(i)));
    MetCubes cubes(box, kStandInCubes);
    for (std::size_t i = 0; i < places.size(); ++i) cubes.mark(ball(balls, places.vertex_of(i)));
    return cubes.shell();
}

}  // namespace

Result<Object> prepare_cloud(Object object, Mesh cloud, const Design& design) {
    object.measure.bounds = bounds(cloud);
    const CloudPlaces places(cloud);
    auto radii = point_radii(cloud, places, design.object.point_radius_mm);
    if (!radii) return tl::unexpected(radii.error());
    const auto rims = cloud_rims(places);
    object.missing.capped = design.object.cap && !rims.empty();
    object.missing.spans = object.missing.capped ? capped(cloud, rims) : span_of_loops(cloud, rims);
    PointBalls balls{std::move(cloud), std::move(radii->radius)};
    object.mesh = stand_in(balls, places);
    object.surface = std::move(balls);
    return object;
}

}  // namespace snug

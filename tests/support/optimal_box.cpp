#include "tests/support/optimal_box.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/optimal_bounding_box.h>
#include <array>
#include <cmath>
#include <vector>

namespace snug::test {

Vec3d optimal_box(const Mesh& mesh) {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    std::vector<Point> points;
    for (const Vec3f& v : mesh.vertices) points.emplace_back(v.x, v.y, v.z);
    std::array<Point, 8> corner;
    CGAL::oriented_bounding_box(points, corner);
    // Corner 0 is joined to corners 1, 3 and 5.
    const auto side = [&](std::size_t to) {
        return std::sqrt(CGAL::squared_distance(corner[0], corner[to]));
    };
    return {side(1), side(3), side(5)};
}

}  // namespace snug::test

#include "snug/search/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace snug {
namespace {

/// Samples of one triangle, its corners included.
constexpr int kMostRows = 1024;

class PointThinner {
  public:
    PointThinner(double spacing, Vec3d centre, Vec3d low) : spacing_(spacing), centre_(centre), low_(low) {}

    void add(Vec3d p) {
        const Vec3d out = p - centre_;
        kept_.push_back({key(p), dot(out, out), vec_cast<float>(p)});
        if (kept_.size() > 2 * sorted_ + (std::size_t{1} << 16)) thin();
    }

    SurfacePoints take() {
        thin();
        SurfacePoints points;
        for (const Sample& sample : kept_) {
            points.x.push_back(sample.point.x);
            points.y.push_back(sample.point.y);
            points.z.push_back(sample.point.z);
        }
        return points;
    }

  private:
    struct Sample {
        std::uint64_t cube;
        double out;  ///< squared distance from the centre
        Vec3f point;
    };

    [[nodiscard]] std::uint64_t key(Vec3d p) const {
        std::uint64_t result = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double cell = std::clamp((p[axis] - low_[axis]) / spacing_, 0.0, 2097151.0);
            result = result << 21 | static_cast<std::uint64_t>(cell);
        }
        return result;
    }

    void thin() {
        std::sort(kept_.begin(), kept_.end(), [](const Sample& a, const Sample& b) {
            if (a.cube != b.cube) return a.cube < b.cube;
            if (a.out != b.out) return a.out > b.out;
            if (a.point.x != b.point.x) return a.point.x < b.point.x;
            if (a.point.y != b.point.y) return a.point.y < b.point.y;
            return a.point.z < b.point.z;
        });
        const auto same = [](const Sample& a, const Sample& b) { return a.cube == b.cube; };
        kept_.erase(std::unique(kept_.begin(), kept_.end(), same), kept_.end());
        sorted_ = kept_.size();
    }

    double spacing_;
    Vec3d centre_, low_;
    std::vector<Sample> kept_;
    std::size_t sorted_ = 0;
};

/// Rows of points from the longest side to the corner opposite, so that slivers get few.
void sample(const std::array<Vec3d, 3>& corner, double spacing, PointThinner& points) {
    std::array<double, 3> side{};
    for (std::size_t i = 0; i < 3; ++i) side[i] = length(corner[(i + 1) % 3] - corner[i]);
    const auto i = static_cast<std::size_t>(std::max_element(side.begin(), side.end()) - side.begin());
    if (side[i] <= spacing) return;
    const Vec3d a = corner[i], b = corner[(i + 1) % 3], apex = corner[(i + 2) % 3];
    const double height = length(cross(b - a, apex - a)) / side[i];
    const int rows = static_cast<int>(std::clamp(std::ceil(height / spacing), 1.0, double{kMostRows}));
    for (int row = 0; row < rows; ++row) {
        const double up = static_cast<double>(row) / rows;
        const Vec3d from = a + (apex - a) * up, to = b + (apex - b) * up;
        const int steps =
            static_cast<int>(std::clamp(std::ceil(side[i] * (1 - up) / spacing), 1.0, double{kMostRows}));
        for (int step = 0; step <= steps; ++step)
            points.add(from + (to - from) * (static_cast<double>(step) / steps));
    }
}

}  // namespace

SurfacePoints surface_points(const Mesh& mesh, double spacing) {
    const Box3d box = bounds(mesh);
    PointThinner points(spacing, box.centre(), box.min);
    for (const Vec3f& vertex : mesh.vertices) points.add(vec_cast<double>(vertex));
    for (const Triangle& t : mesh.triangles)
        sample({vec_cast<double>(mesh.vertices[t[0]]), vec_cast<double>(mesh.vertices[t[1]]),
                vec_cast<double>(mesh.vertices[t[2]])},
               spacing, points);
    return points.take();
}

SurfacePoints thinned(const SurfacePoints& points, double spacing) {
    Box3d box;
    const auto point = [&points](std::size_t i) {
        return vec_cast<double>(Vec3f{points.x[i], points.y[i], points.z[i]});
    };
    for (std::size_t i = 0; i < points.size(); ++i) box.include(point(i));
    PointThinner thinner(spacing, box.centre(), box.min);
    for (std::size_t i = 0; i < points.size(); ++i) thinner.add(point(i));
    return thinner.take();
}

double surface_area(const Mesh& mesh) {
    double area = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = vec_cast<double>(mesh.vertices[t[0]]);
        area += length(cross(vec_cast<double>(mesh.vertices[t[1]]) - a,
                             vec_cast<double>(mesh.vertices[t[2]]) - a)) /
                2;
    }
    return area;
}

}  // namespace snug

#include "snug/object/point_radius.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "snug/base/parallel.h"

namespace snug {
namespace {

constexpr std::size_t kNeighbours = 6;
constexpr double kMostMedians = 4;
constexpr std::size_t kPointsATask = 4096;  // points that one task treats

std::vector<double> spacing_of(const CloudPlaces& places) {
    std::vector<double> spacing(places.size());
    parallel_for((spacing.size() + kPointsATask - 1) / kPointsATask, [&](std::size_t chunk) {
        const std::size_t end = std::min(spacing.size(), (chunk + 1) * kPointsATask);
        for (std::size_t i = chunk * kPointsATask; i < end; ++i) {
            const CloudPlaces::Neighbours nearest = places.nearest(i, kNeighbours);
            spacing[i] = std::sqrt(nearest.squared[nearest.count - 1]);
        }
    });
    return spacing;
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Not below the value, so that rounding leaves nothing uncovered.
float radius_rounded_up(double value) {
    const auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) < value
               ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
               : rounded;
}

}  // namespace

Result<PointRadii> point_radii(const Mesh& cloud, const CloudPlaces& places, double fixed) {
    if (!(fixed >= 0 && fixed <= static_cast<double>(std::numeric_limits<float>::max())))
        return fail(ErrorKind::usage, say("cloud.radius"));
    if (places.size() < 2) return fail(ErrorKind::input, say("object.one_point"));

    PointRadii radii;
    if (fixed > 0) {
        radii.radius.assign(cloud.vertices.size(), radius_rounded_up(fixed));
        radii.median = fixed;
        return radii;
    }
    const std::vector<double> spacing = spacing_of(places);
    radii.radius.reserve(cloud.vertices.size());
    radii.median = median_of(spacing);
    const double most = kMostMedians * radii.median;
    for (std::size_t v = 0; v < cloud.vertices.size(); ++v) {
        const std::uint32_t place = places.of_vertex(v);
        radii.shortened += spacing[place] > most;
        radii.radius.push_back(radius_rounded_up(std::min(spacing[place], most)));
    }
    return radii;
}

}  // namespace snug

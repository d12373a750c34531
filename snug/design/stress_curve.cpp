#include "snug/design/stress_curve.h"

#include <algorithm>
#include <string>

#include "snug/words/words.h"

namespace snug {
namespace {

constexpr double kAir = 101.325;         // kPa
constexpr double kFullPlateau = 0.05;    // strain
constexpr double kLeastPlateau = 5;      // kPa
constexpr double kGreatestPlateau = 70;  // kPa
constexpr int kPlateaus = 14;            // 5, 10 ... 70

double air_kpa(double strain, double solid_share) {
    return kAir * strain / (1 - strain - solid_share);
}

}  // namespace

std::optional<Message> problem_of(std::span<const StressPoint> points) {
    constexpr std::size_t kMostPoints = 1000;
    if (points.size() < 2) return say("curve.two_points");
    if (points.size() > kMostPoints) return say("curve.many", {{"most", std::to_string(kMostPoints)}});
    StressPoint before;
    for (const StressPoint& point : points) {
        if (!(point.strain > before.strain && point.strain < 1)) return say("curve.strains");
        if (!(point.kpa > 0 && point.kpa >= before.kpa && point.kpa <= 1e6)) return say("curve.falls");
        before = point;
    }
    return {};
}

StressCurve::StressCurve(std::span<const StressPoint> points) : corners_(1) {
    for (const StressPoint& point : points) {
        const Corner& before = corners_.back();
        const double energy = before.energy + (before.kpa + point.kpa) / 2 * (point.strain - before.strain);
        corners_.push_back({point.strain, point.kpa, energy});
    }
}

StressCurve::Value StressCurve::at(double strain) const {
    if (!(strain > 0)) return {};
    const auto above =
        std::upper_bound(corners_.begin(), corners_.end(), strain,
                         [](double value, const Corner& corner) { return value < corner.strain; });
    const Corner& before = *(above - 1);
    if (above == corners_.end()) return {before.kpa, before.energy};
    const double slope = (above->kpa - before.kpa) / (above->strain - before.strain);
    const double kpa = before.kpa + slope * (strain - before.strain);
    return {kpa, before.energy + (before.kpa + kpa) / 2 * (strain - before.strain)};
}

std::optional<double> StressCurve::strain_of_drop(double stress_kpa, double height) const {
    const auto lacking = [&](double strain) { return stress_kpa * (height + strain) - at(strain).energy; };
    double low = 0, high = greatest_strain();
    if (lacking(high) > 0) return {};
    // Energy begins below what falls and, convex, crosses it once.
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (lacking(middle) > 0 ? low : high) = middle;
    }
    return high;
}

std::vector<StressPoint> closed_cell_points(double plateau_kpa, double solid_share, double greatest_strain,
                                            double air) {
    std::vector<StressPoint> points;
    constexpr int kSteps = 40;
    for (int i = 1; i <= kSteps; ++i) {
        const double strain = std::min(static_cast<double>(i) / kSteps, greatest_strain);
        points.push_back({strain, plateau_kpa * std::min(1.0, strain / kFullPlateau) +
                                      air * air_kpa(strain, solid_share)});
        if (strain >= greatest_strain) break;
    }
    return points;
}

double plateau_kpa(const StressCurve& curve) {
    return std::clamp(curve.at(kFullPlateau).kpa - air_kpa(kFullPlateau, 0), kLeastPlateau, kGreatestPlateau);
}

std::vector<StressCurve> with_other_plateaus(std::span<const StressPoint> points) {
    const StressCurve given(points);
    std::vector<double> strains;
    for (const StressPoint& point : points) strains.push_back(point.strain);
    if (kFullPlateau < strains.back()) strains.push_back(kFullPlateau);
    std::sort(strains.begin(), strains.end());
    strains.erase(std::unique(strains.begin(), strains.end()), strains.end());
    std::vector<StressCurve> curves;
    for (int i = 0; i < kPlateaus; ++i) {
        const double other = kLeastPlateau + (kGreatestPlateau - kLeastPlateau) * i / (kPlateaus - 1);
        const double more = other - plateau_kpa(given);
        std::vector<StressPoint> shifted;
        double before = 0;
        for (const double strain : strains) {
            const double kpa = given.at(strain).kpa + more * std::min(1.0, strain / kFullPlateau);
            before = std::max(before, std::max(kpa, 0.0));
            shifted.push_back({strain, before});
        }
        curves.emplace_back(shifted);
    }
    return curves;
}

}  // namespace snug

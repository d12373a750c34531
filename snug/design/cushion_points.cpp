#include "snug/design/cushion_points.h"

#include <algorithm>
#include <cmath>

#include "snug/base/text.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr std::size_t kLeastPoints = 5, kMostPoints = 200;
constexpr double kMostResidual = 0.15;
constexpr double kSolidShare = 0.04;  // of foams of 35 kg/m3; others differ little below 75 % of strain
constexpr double kGreatestStrain = 0.9;
constexpr double kBottomed = 10;  // as a residual

struct Cushion {
    double plateau_kpa = 0, air = 0;

    [[nodiscard]] std::vector<StressPoint> points(double greatest_strain) const {
        return closed_cell_points(plateau_kpa, kSolidShare, greatest_strain, air);
    }
};

std::optional<double> strain_at(const CushionPoint& point, const StressCurve& curve) {
    return curve.strain_of_drop(point.static_kpa, point.height_mm / point.thickness_mm);
}

double residual(const CushionPoint& point, const StressCurve& curve) {
    const auto strain = strain_at(point, curve);
    if (!strain) return kBottomed;
    return (curve.at(*strain).kpa / point.static_kpa - 1 - point.g) / point.g;
}

double error_of(const Cushion& cushion, std::span<const CushionPoint> points) {
    const std::vector<StressPoint> corners = cushion.points(kGreatestStrain);
    const StressCurve curve(corners);
    double sum = 0;
    for (const CushionPoint& point : points) {
        const double r = residual(point, curve);
        sum += r * r;
    }
    return sum;
}

/// The best of a grid that narrows around the best so far.
Cushion best_cushion(std::span<const CushionPoint> points) {
    constexpr int kHalf = 6, kRounds = 24;
    Cushion best{250, 2};
    double least = error_of(best, points);
    double plateau_step = 40, air_step = 0.32;
    for (int round = 0; round < kRounds; ++round) {
        const Cushion middle = best;
        for (int i = -kHalf; i <= kHalf; ++i)
            for (int k = -kHalf; k <= kHalf; ++k) {
                const Cushion other{std::max(0.0, middle.plateau_kpa + i * plateau_step),
                                    std::max(0.01, middle.air + k * air_step)};
                const double error = error_of(other, points);
                if (error >= least) continue;
                least = error;
                best = other;
            }
        const bool moved = best.plateau_kpa != middle.plateau_kpa || best.air != middle.air;
        if (moved && round < kRounds / 2) continue;
        plateau_step /= 2;
        air_step /= 2;
    }
    return best;
}

bool is_number_above_0(double value) {
    return value > 0 && value <= 1e6;
}

}  // namespace

Result<CushionFit> fit_cushion_points(std::span<const CushionPoint> points) {
    if (points.size() < kLeastPoints)
        return fail(ErrorKind::usage, say("cushion.few", {{"least", std::to_string(kLeastPoints)},
                                                          {"found", std::to_string(points.size())}}));
    if (points.size() > kMostPoints)
        return fail(ErrorKind::usage, say("cushion.many", {{"most", std::to_string(kMostPoints)},
                                                           {"found", std::to_string(points.size())}}));
    CushionFit fit;
    fit.least_mm = points.front().thickness_mm;
    for (const CushionPoint& point : points) {
        for (const double value : {point.static_kpa, point.g, point.thickness_mm, point.height_mm})
            if (!is_number_above_0(value)) return fail(ErrorKind::usage, say("cushion.above_0"));
        fit.least_mm = std::min(fit.least_mm, point.thickness_mm);
        fit.greatest_mm = std::max(fit.greatest_mm, point.thickness_mm);
    }
    const Cushion best = best_cushion(points);
    const StressCurve curve(best.points(kGreatestStrain));
    double greatest = 0, worst = 0;
    for (const CushionPoint& point : points) {
        fit.residuals.push_back(residual(point, curve));
        worst = std::max(worst, std::abs(fit.residuals.back()));
        greatest = std::max(greatest, strain_at(point, curve).value_or(0));
    }
    if (worst > kMostResidual) {
        std::vector<Message> shown;
        for (const double each : fit.residuals) shown.push_back(as_it_is(number(each * 100, 0)));
        return fail(ErrorKind::usage, say("cushion.residuals",
                                          {{"residuals", shown}, {"most", number(kMostResidual * 100, 0)}}));
    }
    fit.curve = best.points(greatest);
    return fit;
}

}  // namespace snug

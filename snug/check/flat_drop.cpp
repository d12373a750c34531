#include "snug/check/flat_drop.h"

#include <algorithm>
#include <cmath>

#include "snug/check/gravity.h"

namespace snug {
namespace {

/// Both foams together after a travel.
class Balance {
  public:
    Balance(const Cushioned& item, const StressCurve& curve) : item_(item), curve_(curve) {
        if (item.ahead) begin_.joule += item.ahead->taken(0, curve).joule;
        if (item.behind) begin_behind_ = item.behind->taken(0, curve).joule;
    }

    [[nodiscard]] double newton(double travel) const {
        return item_.ahead->push(travel, curve_).newton - behind(travel).newton;
    }
    /// Taken up since the drawn place.
    [[nodiscard]] double joule(double travel) const {
        const double ahead = item_.ahead->taken(travel, curve_).joule - begin_.joule;
        return ahead - (item_.behind ? begin_behind_ - item_.behind->taken(-travel, curve_).joule : 0);
    }
    /// As far as the data go.
    [[nodiscard]] double longest_mm() const {
        return std::min(item_.bare_mm, item_.ahead->travel_to_strain(curve_.greatest_strain()));
    }

    [[nodiscard]] Stop stop_at(double travel, double thin_mm) const {
        const Pads& ahead = *item_.ahead;
        Stop stop;
        stop.travel_mm = travel;
        const Pads::Push push = ahead.push(travel, curve_), back = behind(travel);
        stop.newton = push.newton - back.newton;
        if (stop.newton > 0)
            stop.at = Vec2d{push.u_mm * push.newton - back.u_mm * back.newton,
                            push.v_mm * push.newton - back.v_mm * back.newton} *
                      (1 / stop.newton);
        const Pads::Most most = ahead.most_squeezed(travel);
        stop.strain = most.strain;
        stop.most_at = {most.u_mm, most.v_mm};
        stop.peak_kpa = curve_.at(most.strain).kpa;
        stop.area_mm2 = ahead.area_mm2(travel);
        const Pads::Taken taken = ahead.taken(travel, curve_, thin_mm);
        stop.thin_share = taken.joule > 0 ? taken.thin_joule / taken.joule : 0;
        return stop;
    }

  private:
    [[nodiscard]] Pads::Push behind(double travel) const {
        return item_.behind ? item_.behind->push(-travel, curve_) : Pads::Push{};
    }

    const Cushioned& item_;
    const StressCurve& curve_;
    Pads::Taken begin_;
    double begin_behind_ = 0;
};

bool has_foam(const Cushioned& item) {
    return item.ahead && !item.ahead->empty();
}

}  // namespace

std::optional<Stop> flat_drop(const Cushioned& item, const StressCurve& curve, double height_mm,
                              double thin_mm) {
    if (!has_foam(item)) return {};
    const Balance balance(item, curve);
    const double weight = item.mass_kg * kStandardGravity;
    const auto lacking = [&](double travel) {
        return weight * (height_mm + travel) * 1e-3 - balance.joule(travel);
    };
    double travel = balance.longest_mm();
    if (!(travel > 0) || lacking(travel) > 0) return {};
    // Concave in the travel and not above 0 here: Newton's steps come down to the one root and never pass it.
    for (int i = 0; i < 60; ++i) {
        const double slope = (balance.newton(travel) - weight) * 1e-3;
        if (!(slope > 0)) break;
        const double step = -lacking(travel) / slope;
        travel -= step;
        if (!(step > 1e-9 * travel)) break;
    }
    return balance.stop_at(travel, thin_mm);
}

double lacking_share(const Cushioned& item, const StressCurve& curve, double height_mm) {
    if (!has_foam(item)) return 1;
    const Balance balance(item, curve);
    const double travel = balance.longest_mm();
    if (!(travel > 0)) return 1;
    const double fall = item.mass_kg * kStandardGravity * (height_mm + travel) * 1e-3;
    return std::clamp((fall - balance.joule(travel)) / fall, 0.0, 1.0);
}

std::optional<Stop> at_rest(const Cushioned& item, const StressCurve& curve) {
    if (!has_foam(item)) return {};
    const Balance balance(item, curve);
    const double weight = item.mass_kg * kStandardGravity;
    double low = 0, high = balance.longest_mm();
    if (!(high > 0) || balance.newton(high) < weight) return {};
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (balance.newton(middle) < weight ? low : high) = middle;
    }
    return balance.stop_at(high, 0);
}

std::vector<Vec2d> force_on_the_way(const Cushioned& item, const StressCurve& curve, int steps) {
    if (!has_foam(item)) return {};
    const Balance balance(item, curve);
    const double longest = balance.longest_mm();
    if (!(longest > 0)) return {};
    std::vector<Vec2d> points;
    for (int i = 0; i <= steps; ++i) {
        const double travel = longest * i / steps;
        points.push_back({travel, balance.newton(travel)});
    }
    return points;
}

double shock_g(const Stop& stop, double mass_kg) {
    const double weight = mass_kg * kStandardGravity;
    return (stop.newton - weight) / weight;
}

}  // namespace snug

#include "snug/check/joint_drop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "snug/check/gravity.h"

namespace snug {
namespace {

constexpr double kGravityMm = kStandardGravity * 1e3;  // mm/s2
constexpr int kStepsPerPad = 800;                      // in the time that the fall takes through the thinnest
constexpr int kMostSteps = 40000;

/// The force of one contact over how near its ends came, straight between equal steps.
class ForceTable {
  public:
    ForceTable(const PadContact& contact, const StressCurve& curve)
        : begin_(contact.pads.least_gap_mm()),
          end_(std::min(contact.bare_mm, contact.pads.travel_to_strain(curve.greatest_strain()))) {
        if (!(end_ > begin_) || !std::isfinite(begin_)) return;
        newton_.reserve(kSteps + 1);
        for (int i = 0; i <= kSteps; ++i)
            newton_.push_back(contact.pads.push(begin_ + (end_ - begin_) * i / kSteps, curve).newton);
    }

    [[nodiscard]] double newton(double near) const {
        if (newton_.empty() || near <= begin_) return 0;
        const double at = std::min((near - begin_) / (end_ - begin_), 1.0) * kSteps;
        const auto i = std::min(static_cast<std::size_t>(at), newton_.size() - 2);
        return newton_[i] + (newton_[i + 1] - newton_[i]) * (at - static_cast<double>(i));
    }
    /// As far as the data go.
    [[nodiscard]] double longest_mm() const { return end_; }

  private:
    static constexpr int kSteps = 400;
    double begin_, end_;
    std::vector<double> newton_;
};

/// A contact by the way that they fall: the rear presses it against the front.
struct Link {
    const PadContact* contact;
    ForceTable force;
    int rear, front;  ///< places in JointItems::items; -1: the case
};

class Motion {
  public:
    Motion(const JointItems& items, const StressCurve& curve)
        : items_(items), curve_(curve), travel_(items.items.size()), force_(items.items.size()) {
        const auto place = [&](int item) {
            const auto found = std::find(items.items.begin(), items.items.end(), item);
            return item == PadContact::kCase ? -1 : static_cast<int>(found - items.items.begin());
        };
        for (const PadContact* contact : items.contacts) {
            const int low = place(contact->low), high = place(contact->high);
            links_.push_back({contact, ForceTable(*contact, curve), items.to_high ? low : high,
                              items.to_high ? high : low});
        }
        result_.stops.resize(items.items.size());
        result_.bottoms.resize(items.items.size());
    }

    [[nodiscard]] std::vector<double>& travel() { return travel_; }
    /// How near the ends of a contact came to each other since they were drawn.
    [[nodiscard]] double near(const Link& link) const { return at(link.rear) - at(link.front); }

    /// What pushes each item back, N.
    const std::vector<double>& forces() {
        std::fill(force_.begin(), force_.end(), 0.0);
        for (const Link& link : links_) {
            const double newton = link.force.newton(near(link));
            if (link.rear >= 0) force_[static_cast<std::size_t>(link.rear)] += newton;
            if (link.front >= 0) force_[static_cast<std::size_t>(link.front)] -= newton;
        }
        return force_;
    }

    /// Whether something bottoms as it lies now; then that is marked.
    bool bottoms() {
        bool any = false;
        for (const Link& link : links_) {
            if (near(link) <= link.force.longest_mm()) continue;
            any = true;
            for (const int end : {link.rear, link.front})
                if (end >= 0) result_.bottoms[static_cast<std::size_t>(end)] = true;
            if (link.rear >= 0 && link.front >= 0) result_.items_meet = true;
        }
        return any;
    }

    /// What item i lies on now, pressed by so many N in all.
    [[nodiscard]] Stop stop_of(std::size_t i, double newton, double thin_mm) const {
        Stop stop;
        stop.travel_mm = travel_[i];
        stop.newton = newton;
        double pushed = 0, taken = 0, thin = 0;
        Vec2d moment;
        for (const Link& link : links_) {
            if (link.rear == static_cast<int>(i) || link.front == static_cast<int>(i))
                stop.contacts.push_back({link.contact->low, link.contact->high, near(link)});
            if (link.rear != static_cast<int>(i)) continue;
            const Pads& pads = link.contact->pads;
            const Pads::Push push = pads.push(near(link), curve_);
            pushed += push.newton;
            moment = moment + Vec2d{push.u_mm, push.v_mm} * push.newton;
            const Pads::Most most = pads.most_squeezed(near(link));
            if (most.strain > stop.strain) {
                stop.strain = most.strain;
                stop.most_at = {most.u_mm, most.v_mm};
            }
            stop.area_mm2 += pads.area_mm2(near(link));
            const Pads::Taken energy = pads.taken(near(link), curve_, thin_mm);
            taken += energy.joule;
            thin += energy.thin_joule;
        }
        if (pushed > 0) stop.at = moment * (1 / pushed);
        stop.peak_kpa = curve_.at(stop.strain).kpa;
        stop.thin_share = taken > 0 ? thin / taken : 0;
        return stop;
    }

    [[nodiscard]] double thinnest_mm() const {
        double least = std::numeric_limits<double>::infinity();
        for (const Link& link : links_)
            if (link.rear >= 0 && link.force.longest_mm() > 0)
                least = std::min(least, link.force.longest_mm());
        return least;
    }

    JointStops result_;
    const JointItems& items_;

  private:
    [[nodiscard]] double at(int item) const { return item < 0 ? 0 : travel_[static_cast<std::size_t>(item)]; }

    const StressCurve& curve_;
    std::vector<Link> links_;
    std::vector<double> travel_, force_;
};

/// The fall, step by step (velocity Verlet). `seen(step, forces)` after each; ends where every item has
/// turned round, or something bottoms: then false.
template <class Seen>
bool fall(Motion& motion, double height_mm, Seen seen) {
    const std::size_t count = motion.travel().size();
    const double begun = std::sqrt(2 * kGravityMm * height_mm);
    const double dt = motion.thinnest_mm() / begun / kStepsPerPad;
    std::fill(motion.travel().begin(), motion.travel().end(), 0.0);
    std::vector<double> speed(count, begun), pull(count);
    const auto accelerate = [&] {
        const auto& forces = motion.forces();
        for (std::size_t i = 0; i < count; ++i)
            pull[i] = kGravityMm - forces[i] * 1e3 / motion.items_.mass_kg[i];
    };
    accelerate();
    std::vector<bool> turned(count);
    for (int step = 0; step < kMostSteps; ++step) {
        for (std::size_t i = 0; i < count; ++i) {
            speed[i] += pull[i] * dt / 2;
            motion.travel()[i] += speed[i] * dt;
        }
        accelerate();
        for (std::size_t i = 0; i < count; ++i) {
            speed[i] += pull[i] * dt / 2;
            if (speed[i] <= 0) turned[i] = true;
        }
        if (motion.bottoms()) return false;
        seen(step, motion.forces());
        if (std::all_of(turned.begin(), turned.end(), [](bool each) { return each; })) return true;
    }
    motion.result_.unsettled = true;
    return false;
}

}  // namespace

JointStops joint_drop(const JointItems& items, const StressCurve& curve, double height_mm, double thin_mm) {
    Motion motion(items, curve);
    if (!std::isfinite(motion.thinnest_mm())) return std::move(motion.result_);
    const std::size_t count = items.items.size();
    std::vector<double> most(count);
    std::vector<int> when(count, -1);
    if (!fall(motion, height_mm, [&](int step, const std::vector<double>& forces) {
            for (std::size_t i = 0; i < count; ++i) {
                if (forces[i] <= most[i]) continue;
                most[i] = forces[i];
                when[i] = step;
            }
        }))
        return std::move(motion.result_);
    // Once more, to see how everything lay when each met its most.
    (void)fall(motion, height_mm, [&](int step, const std::vector<double>&) {
        for (std::size_t i = 0; i < count; ++i)
            if (when[i] == step) motion.result_.stops[i] = motion.stop_of(i, most[i], thin_mm);
    });
    return std::move(motion.result_);
}

JointStops joint_rest(const JointItems& items, const StressCurve& curve) {
    constexpr int kSweeps = 2000;
    constexpr double kAtRest = 1e-7, kFarthest = 1e4;  // mm
    Motion motion(items, curve);
    std::vector<double>& travel = motion.travel();
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        double moved = 0;
        for (std::size_t i = 0; i < travel.size(); ++i) {
            const double before = travel[i], weight = items.mass_kg[i] * kStandardGravity;
            double low = -kFarthest, high = kFarthest;
            for (int k = 0; k < 60; ++k) {
                travel[i] = (low + high) / 2;
                (motion.forces()[i] < weight ? low : high) = travel[i];
            }
            moved = std::max(moved, std::abs(travel[i] - before));
        }
        if (moved < kAtRest) break;
    }
    if (motion.bottoms()) return std::move(motion.result_);
    for (std::size_t i = 0; i < travel.size(); ++i)
        motion.result_.stops[i] = motion.stop_of(i, items.mass_kg[i] * kStandardGravity, 0);
    return std::move(motion.result_);
}

std::vector<std::vector<int>> joint_sets(std::span<const PadContact> contacts, std::size_t item_count) {
    std::vector<int> set_of(item_count);
    std::iota(set_of.begin(), set_of.end(), 0);
    const auto root = [&](int item) {
        while (set_of[static_cast<std::size_t>(item)] != item) item = set_of[static_cast<std::size_t>(item)];
        return item;
    };
    for (const PadContact& contact : contacts) {
        if (contact.low == PadContact::kCase || contact.high == PadContact::kCase) continue;
        const int a = root(contact.low), b = root(contact.high);
        set_of[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::vector<std::vector<int>> sets;
    std::vector<std::size_t> place(item_count);
    for (std::size_t i = 0; i < item_count; ++i) {
        const auto first = static_cast<std::size_t>(root(static_cast<int>(i)));
        if (first == i) {
            place[i] = sets.size();
            sets.emplace_back();
        }
        sets[place[first]].push_back(static_cast<int>(i));
    }
    return sets;
}

}  // namespace snug

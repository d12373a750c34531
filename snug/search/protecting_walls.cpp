#include "snug/search/protecting_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "snug/base/text.h"
#include "snug/check/pad_contacts.h"
#include "snug/check/protection.h"
#include "snug/space/spread_items.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

constexpr double kWallStep = 5;        // mm
constexpr double kGreatest = 400;      // mm
constexpr double kMostMoreFoam = 200;  // mm, that FaceShock::more_foam_mm looks at
constexpr int kMostRounds = 60;

std::optional<Error> lacking_wishes(const Design& design) {
    if (auto error = lacking_for_shocks(design, say("protect.wish/walls"))) return error;
    if (design.space.blocks || design.case_options.inside_mm)
        return Error{ErrorKind::usage, say("protect.not_fitted", {{"option", "--blocks auto"}})};
    return {};
}

/// The foam on the six sides, by Side, and between two items.
constexpr std::size_t kBetween = 6;
constexpr std::size_t kParts = 7;
using Foam = std::array<double, kParts>;

/// How much more a part needs; 0: it has enough.
struct Lack {
    double mm = 0;
    bool known = false;  ///< that no less would do
};
using Lacking = std::array<Lack, kParts>;

bool is_enough(const Lacking& lacking) {
    return std::all_of(lacking.begin(), lacking.end(), [](const Lack& each) { return each.mm == 0; });
}

double to_step(double mm) {
    return std::ceil(mm / kWallStep - 1e-9) * kWallStep;
}

Walls walls_of(const Foam& foam) {
    Walls walls;
    std::copy_n(foam.begin(), walls.size(), walls.begin());
    return walls;
}

/// Where it is not known how much more would do: so much that few steps lead far.
double a_step_more(double mm) {
    return std::max(2 * kWallStep, to_step(mm / 4));
}

/// What an item falls onto, as far as that is known.
struct Ahead {
    bool item = false, wall = false;
};

Ahead ahead_of(int item, const FaceShock& face) {
    if (face.meets_item) return {true, false};
    Ahead ahead;
    for (const ContactTravel& contact : face.contacts) {
        const bool low = face.face % 2 == 0;
        if ((low ? contact.high : contact.low) != item) continue;
        ((low ? contact.low : contact.high) == PadContact::kCase ? ahead.wall : ahead.item) = true;
    }
    return ahead.item ? ahead : Ahead{false, true};
}

/// Adds what a side and the foam between items lack for the sake of one item.
void add_lacking(const Protection& found, std::size_t i, Side side, bool spreads, const Foam& foam,
                 Lacking& lacking) {
    const ItemProtection& item = found.items[i];
    const FaceShock& face = item.faces[static_cast<std::size_t>(side)];
    if (face.g_high && *face.g_high <= *item.asked_g) return;
    // More foam there does nothing for what another item bottoms on.
    if (face.bottoms && !face.bottoms_itself && !face.meets_item) return;
    const Ahead ahead = ahead_of(static_cast<int>(i), face);
    const bool alone = !face.force.empty() && !item.relief;
    const auto add = [&](std::size_t part) {
        const double unknown = alone ? kMostMoreFoam : a_step_more(foam[part]);
        const Lack lack{face.more_foam_mm.value_or(unknown), face.more_foam_mm.has_value()};
        if (lack.mm > lacking[part].mm) lacking[part] = lack;
    };
    if (ahead.item && spreads) add(kBetween);
    if (ahead.wall || !spreads) add(static_cast<std::size_t>(side));
}

bool items_meet(std::size_t side, const Protection& found) {
    return std::any_of(found.items.begin(), found.items.end(),
                       [&](const ItemProtection& item) { return item.faces[side].meets_item; });
}

/// What stands in the way where no thickness would do. `met`: whether items met on that side, with any of
/// those that were tried.
Message too_thick(std::size_t part, const Protection& found, bool met) {
    const std::string cm = number(*found.drop_mm / 10, 0), most = number(kGreatest, 0);
    if (part == kBetween) return say("protect.between", {{"cm", cm}, {"most", most}});
    const auto side = static_cast<Side>(part);
    const Message fallen = fallen_on(side);
    if (met) return say("protect.items_meet", {{"cm", cm}, {"fallen", fallen}});
    const ItemProtection& worst = found.items[found.worst_item(side)];
    const bool stiff = worst.faces[part].g_high.has_value();
    const Message what = stiff ? say("protect.too_stiff", {{"cm", cm}, {"fallen", fallen}, {"most", most}})
                               : say("protect.too_thick", {{"cm", cm}, {"fallen", fallen}, {"most", most}});
    return worst.name.empty() ? what : say("summary.named", {{"name", worst.name}, {"what", what}});
}

/// The least that does of one thickness, closed in on from both sides.
struct Least {
    std::optional<double> fails, does;  ///< the most that is known not to do, the least that is known to

    [[nodiscard]] bool open() const { return fails && does && *does - *fails > kWallStep + 1e-9; }
    [[nodiscard]] double next() const {
        return open() ? *fails + to_step((*does - *fails) / 2) : does.value();
    }
};

/// Which items can be moved apart.
enum class Spreads { no, rows, placed };

Spreads spreads_of(const Design& design) {
    const std::vector<ItemOptions>& items = design.items;
    if (items.size() < 2) return Spreads::no;
    const auto any = [&](const auto& is) { return std::any_of(items.begin(), items.end(), is); };
    // place_items() lays those without a place with so much foam between them.
    if (any([](const ItemOptions& item) { return !item.offset_mm; })) return Spreads::rows;
    return any([](const ItemOptions& item) { return item.lock; }) ? Spreads::no : Spreads::placed;
}

class Thickening {
  public:
    Thickening(std::span<const Object> objects, const Design& design, const PackIt& pack_it,
               const Progress& progress)
        : objects_(objects),
          given_(design),
          pack_it_(pack_it),
          progress_(progress),
          spreads_(spreads_of(design)),
          between_(wanted_between_mm(design.space)) {
        foam_.fill(to_step(design.protection.foam->least_thickness_mm()));
        foam_[kBetween] = between_;
    }

    Result<Design> find() {
        if (auto done = grow(); !done) return tl::unexpected(done.error());
        if (auto done = narrow(); !done) return tl::unexpected(done.error());
        return with(foam_);
    }

  private:
    /// Until every item has enough.
    Result<void> grow() {
        while (true) {
            const auto found = dropped(foam_);
            if (!found) return tl::unexpected(found.error());
            const Lacking lacking = lacking_of(*found, foam_);
            if (is_enough(lacking)) {
                for (std::size_t i = 0; i < kParts; ++i) least_[i].does = foam_[i];
                return {};
            }
            for (std::size_t i = 0; i < kParts; ++i) {
                if (i < kBetween) met_[i] = met_[i] || items_meet(i, *found);
                if (lacking[i].mm == 0) continue;
                least_[i].fails = lacking[i].known ? foam_[i] + lacking[i].mm - kWallStep : foam_[i];
                foam_[i] += lacking[i].mm;
                if (foam_[i] > kGreatest)
                    return fail(ErrorKind::does_not_fit, too_thick(i, *found, i < kBetween && met_[i]));
            }
        }
    }

    /// Where larger steps were taken than were needed, back again; what is left has been tried as a whole.
    Result<void> narrow() {
        while (std::any_of(least_.begin(), least_.end(), [](const Least& each) { return each.open(); })) {
            Foam trial{};
            for (std::size_t i = 0; i < kParts; ++i) trial[i] = least_[i].next();
            if (auto done = try_out(trial); !done) return done;
        }
        Foam left{};
        for (std::size_t i = 0; i < kParts; ++i) left[i] = least_[i].does.value();
        return left == foam_ ? Result<void>() : try_out(left);
    }

    /// Marks what does and what does not; taken where all of it does.
    Result<void> try_out(const Foam& trial) {
        const auto found = dropped(trial);
        if (!found) return tl::unexpected(found.error());
        const Lacking lacking = lacking_of(*found, trial);
        if (is_enough(lacking)) foam_ = trial;
        for (std::size_t i = 0; i < kParts; ++i)
            (lacking[i].mm == 0 ? least_[i].does : least_[i].fails) = trial[i];
        return {};
    }

    [[nodiscard]] Lacking lacking_of(const Protection& found, const Foam& foam) const {
        Lacking lacking;
        for (std::size_t i = 0; i < found.items.size(); ++i)
            for (int side = 0; side < 6; ++side) {
                const bool spreads =
                    spreads_ == Spreads::rows || (spreads_ == Spreads::placed && side / 2 > 0);
                add_lacking(found, i, static_cast<Side>(side), spreads, foam, lacking);
            }
        return lacking;
    }

    Result<Protection> dropped(const Foam& foam) {
        if (++round_ > kMostRounds) return fail(ErrorKind::does_not_fit, say("protect.none"));
        if (!go_on(progress_, static_cast<double>(round_ - 1) / kMostRounds))
            return fail(ErrorKind::cancelled, say("cancelled"));
        const Design tried = with(foam);
        auto packing = pack_it_(tried);
        if (!packing) return tl::unexpected(packing.error());
        if (round_ == 1) first_ = packing->items;
        auto found = protection(objects_, *packing, tried);
        if (!found || found->drop_mm) return found;
        if (round_ == 1 || !found->gross_kg) return fail(ErrorKind::usage, say("no_shock/height"));
        return fail(ErrorKind::does_not_fit, say("protect.too_heavy", {{"kg", number(*found->gross_kg, 0)}}));
    }

    [[nodiscard]] Design with(const Foam& foam) const {
        Design design = given_;
        design.space.wall_mm = walls_of(foam);
        const double more = foam[kBetween] - between_;
        if (more <= 0) return design;
        if (spreads_ != Spreads::placed) {
            design.space.between_mm = foam[kBetween];
            return design;
        }
        Vec3d step;
        for (int axis = 0; axis < 3; ++axis) {
            const double block = design.space.block_mm[axis];
            step[axis] = std::ceil(more / block - 1e-9) * block;
        }
        const std::vector<Vec3d> shifts = shifts_apart(first_, step);
        for (std::size_t i = 0; i < shifts.size(); ++i)
            design.items[i].offset_mm = *design.items[i].offset_mm + shifts[i];
        return design;
    }

    std::span<const Object> objects_;
    const Design& given_;
    const PackIt& pack_it_;
    const Progress& progress_;
    Spreads spreads_;
    double between_;           ///< of the design, mm
    std::vector<Item> first_;  ///< where they lay at first
    Foam foam_{};
    std::array<Least, kParts> least_;
    std::array<bool, kBetween> met_{};
    int round_ = 0;
};

}  // namespace

Result<Design> protecting_walls(std::span<const Object> objects, const Design& design, const PackIt& pack_it,
                                const Progress& progress) {
    if (const auto error = lacking_wishes(design)) return tl::unexpected(*error);
    // A copy that stands outside is held by more foam: its walls might let the thing itself bottom.
    if (std::any_of(objects.begin(), objects.end(), [](const Object& each) { return !each.whole(); }))
        return fail(ErrorKind::usage, say("protect.stand_in", {{"option", "--no-stream"}}));
    return Thickening(objects, design, pack_it, progress).find();
}

}  // namespace snug

#include "snug/search/plan_designs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "snug/search/arrange.h"
#include "snug/search/fit_case.h"
#include "snug/search/protecting_walls.h"
#include "snug/search/rank_cases.h"
#include "snug/search/searched_zones.h"
#include "snug/space/space_for.h"

namespace snug {
namespace {

constexpr double kMoreFoam = 1.5;
constexpr std::size_t kMostCases = 2;  // that are looked at for each design
constexpr double kLeastShare = 0.8;    // of a case that is made to measure, see add_case_of_several()
// mm, where a hard case has no room for more
constexpr double kLessFoam[] = {50, 40, 30, 25, 20, 15, 10, 5, 0};

/// The longest side of all objects, mm.
double longest_mm(std::span<const Object> objects) {
    double longest = 0;
    for (const Object& object : objects) {
        const Vec3d size = object.measure.bounds.size();
        longest = std::max({longest, size.x, size.y, size.z});
    }
    return longest;
}

/// Foam that suits the size: finer for what is small.
std::string_view preset_for(Workshop work, double longest) {
    if (work == Workshop::sponge) return longest < 150 ? "slit-10" : "slit-15";
    if (work == Workshop::sheets) return longest < 120 ? "sheet-5" : "sheet-10";
    return usual_preset(work);
}

/// By somebody, who wants it to lie so.
bool is_turned(const Design& design) {
    return design.placement.rotation_deg != Vec3d() || design.placement.offset_mm != Vec3d() ||
           design.search.upright.has_value();
}

double volume_of(Vec3d size) {
    return size.x * size.y * size.z;
}

Vec3d grown_by(Vec3d size, const Walls& walls) {
    return size + Vec3d{walls[0] + walls[1], walls[2] + walls[3], walls[4] + walls[5]};
}

bool is_whole(std::span<const Object> objects) {
    return std::all_of(objects.begin(), objects.end(), [](const Object& each) { return each.whole(); });
}

class Planner {
  public:
    Planner(std::span<Object> objects, const Design& design, const PlanWishes& wishes, const PackIt& pack_it)
        : objects_(objects), given_(design), wishes_(wishes), pack_it_(pack_it) {}

    Result<std::vector<Design>> find(const Progress& progress) {
        const double share = 1.0 / static_cast<double>(wishes_.ways.size());
        double done = 0;
        for (const Workshop work : wishes_.ways) {
            if (auto added = add_way(work, part_of(progress, done, done + share)); !added) {
                if (added.error().kind == ErrorKind::cancelled) return tl::unexpected(added.error());
                if (!why_not_) why_not_ = added.error();
            }
            done += share;
        }
        if (found_.empty()) return tl::unexpected(*why_not_);
        return std::move(found_);
    }

  private:
    /// How the items lie follows from the blocks alone, so that is looked for once.
    Result<void> add_way(Workshop work, const Progress& progress) {
        const std::vector<std::optional<FoamMaterial>> foams = foams_for(work);
        auto laid = started(work, foams.front());
        if (!laid) return tl::unexpected(laid.error());
        if (auto done = lay(*laid, part_of(progress, 0, 0.4)); !done) return done;
        const double share = 0.6 / static_cast<double>(foams.size());
        for (std::size_t i = 0; i < foams.size(); ++i) {
            Design design = *laid;
            design.protection.foam = foams[i];
            const double begin = 0.4 + share * static_cast<double>(i);
            if (auto added = add(std::move(design), part_of(progress, begin, begin + share)); !added)
                return added;
        }
        return {};
    }

    /// The design's own; else, of what is cut, those with data: all where a shock can be compared with them.
    [[nodiscard]] std::vector<std::optional<FoamMaterial>> foams_for(Workshop work) const {
        if (given_.protection.foam) return {given_.protection.foam};
        std::vector<std::optional<FoamMaterial>> all;
        const bool cut = work == Workshop::sheets || work == Workshop::mill;
        if (cut && given_.protection.drops())
            for (const FoamMaterial& foam : wishes_.foams)
                if (!foam.curve.empty()) all.push_back(foam);
        if (all.empty()) all.push_back({});
        if (!mass_kg(given_)) all.resize(1);
        return all;
    }

    [[nodiscard]] Result<Design> started(Workshop work, const std::optional<FoamMaterial>& foam) const {
        Design design = given_;
        design.workshop.work = work;
        design.protection.foam = foam;
        design.fit.settle = !design.space.open;
        if (!wishes_.own_blocks)
            if (const auto preset = find_preset(built_in_presets(), preset_for(work, longest_mm(objects_)))) {
                const Clearance clearance = design.cut.clearance_mm;
                apply(*preset, design);
                if (clearance != Clearance()) design.cut.clearance_mm = clearance;
            }
        if (!design.space.wall_mm) design.space.wall_mm = equal_walls(usual_wall_mm(design, wishes_.carrier));
        return checked(std::move(design));  // what follows from the way of working, too
    }

    Result<void> add(Design design, const Progress& progress) {
        const bool fitted = !design.case_options.inside_mm && !given_.space.blocks;
        const bool walls_given = given_.space.wall_mm.has_value();
        if (fitted && !walls_given && can_be_judged(design)) {
            Design open = design;
            open.space.blocks.reset();
            auto held = protecting_walls(objects_, open, pack_it_, progress);
            if (!held && held.error().kind == ErrorKind::cancelled) return tl::unexpected(held.error());
            if (held) design = std::move(*held);
        }
        if (!fitted) {
            found_.push_back(design);
            return {};
        }
        if (wishes_.in_known_case) {
            const auto added = add_known_cases(design, 1, progress);
            if (!added) return tl::unexpected(added.error());
            if (*added == 0) found_.push_back(design);
            return {};
        }
        found_.push_back(design);
        if (!walls_given) add_more_foam(design);
        const auto added = add_known_cases(design, kMostCases, progress);
        return added ? Result<void>() : tl::unexpected(added.error());
    }

    /// As they take the least room, or where they are to lie.
    Result<void> lay(Design& design, const Progress& progress) {
        if (design.items.size() > 1) {
            if (!wants_arranging(design)) return {};
            const auto told = [&](double share, std::optional<double>) { return go_on(progress, share); };
            auto done = arrange(objects_, design, false, usual_arranging_work(design), {told, {}, pack_it_});
            return done ? Result<void>() : tl::unexpected(done.error());
        }
        if (is_turned(design)) return {};
        const Object& object = objects_.front();
        const auto zones = searched_zones(object, design);
        if (!zones) return tl::unexpected(zones.error());
        if (design.case_options.inside_mm || design.space.blocks) {
            const auto space = space_for(Box3d(), design);
            if (!space) return tl::unexpected(space.error());
            auto turned = fitting_rotation(object.mesh, design, space->space, design.search.seed, *zones);
            if (!turned) return tl::unexpected(turned.error());
            design.placement.rotation_deg = *turned;
            return {};
        }
        const auto least = fit_case(object.mesh, design, design.search.seed, progress, *zones);
        if (!least) return tl::unexpected(least.error());
        design.placement.rotation_deg = least->rotation_deg;
        return {};
    }

    [[nodiscard]] static bool wants_arranging(const Design& design) {
        return std::any_of(design.items.begin(), design.items.end(),
                           [](const ItemOptions& item) { return !item.offset_mm; });
    }

    [[nodiscard]] bool can_be_judged(const Design& design) const {
        return is_whole(objects_) && !design.space.open &&
               !lacking_for_shocks(design, say("protect.wish/walls"));
    }

    void add_more_foam(Design design) {
        SpaceOptions& space = design.space;
        Walls walls = wanted_wall_mm(space);
        // In whole blocks, the same on opposite sides: so the items meet them as before.
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double block = space.block_mm[static_cast<int>(axis)];
            const double wall = std::max(walls[2 * axis], walls[2 * axis + 1]);
            const int more = static_cast<int>(std::ceil(wall * (kMoreFoam - 1) / block - 1e-9));
            walls[2 * axis] += more * block;
            walls[2 * axis + 1] += more * block;
            if (space.blocks) (*space.blocks)[static_cast<int>(axis)] += 2 * more;
        }
        space.wall_mm = walls;
        found_.push_back(std::move(design));
    }

    /// In the smallest that hold the items with their walls, or else, of hard cases, with as much of them as
    /// goes; how many were added.
    Result<int> add_known_cases(const Design& design, std::size_t most, const Progress& progress) {
        if (wishes_.cases.empty() || design.space.open) return 0;
        std::vector<Walls> all{wanted_wall_mm(design.space)};
        const double thickest = *std::max_element(all[0].begin(), all[0].end());
        if (wishes_.in_known_case)
            for (const double wall : kLessFoam)
                if (wall < thickest) all.push_back(equal_walls(wall));
        for (const Walls& walls : all) {
            Design tried = design;
            tried.space.wall_mm = walls;
            const auto added = design.items.size() == 1 ? add_cases_of_one(tried, most)
                                                        : add_case_of_several(tried, progress);
            if (!added || *added > 0) return added;
        }
        return 0;
    }

    Result<int> add_cases_of_one(const Design& design, std::size_t most) {
        const auto packing = pack_it_(design);
        if (!packing) return tl::unexpected(packing.error());
        const Cargo cargo{packing->items.front().placement.bounds.size(), design.workshop.mass_kg,
                          design.search.billed_divisor};
        std::vector<RankedCase> fitting = rank_cases(wishes_.cases, design, cargo).fitting;
        // What stands as somebody wants it stays upright: ways to lay it that keep that come first.
        if (is_turned(given_))
            std::erase_if(fitting, [](const RankedCase& each) { return each.lay[0] != 0; });
        std::stable_sort(fitting.begin(), fitting.end(), [](const RankedCase& a, const RankedCase& b) {
            return volume_of(a.known.inside_mm) < volume_of(b.known.inside_mm);
        });
        fitting.resize(std::min(most, fitting.size()));
        for (const RankedCase& each : fitting) {
            Design in_case = design;
            apply(each.known, in_case.case_options);
            in_case.placement.rotation_deg = rotation_for(each.lay, design.placement.rotation_deg);
            found_.push_back(std::move(in_case));
        }
        return static_cast<int>(fitting.size());
    }

    /// Of hard cases alone: cartons for several are made to measure. Those that are much smaller than what
    /// one that is made to measure takes are not tried.
    Result<int> add_case_of_several(Design design, const Progress& progress) {
        if (!wishes_.in_known_case || !wants_arranging(given_)) return 0;
        const auto packing = pack_it_(design);
        if (!packing) return tl::unexpected(packing.error());
        const Walls walls = wanted_wall_mm(design.space);
        const Vec3d least = grown_by(room_of(packing->items).size(), walls);
        std::vector<KnownCase> cases = wishes_.cases;
        std::erase_if(cases, [&](const KnownCase& each) {
            return volume_of(each.inside_mm) < kLeastShare * volume_of(least);
        });
        design.items = given_.items;
        design.space.blocks.reset();
        // How far it is, of several sizes of case, is not known; whether to go on is asked all the same.
        const auto told = [&](double, std::optional<double>) { return go_on(progress, 1); };
        auto found = arrange_in_known_case(objects_, design, false, cases, usual_arranging_work(design),
                                           {told, {}, pack_it_});
        if (!found && found.error().kind != ErrorKind::does_not_fit) return tl::unexpected(found.error());
        if (found) found_.push_back(std::move(design));
        return found ? 1 : 0;
    }

    std::span<Object> objects_;
    const Design& given_;
    const PlanWishes& wishes_;
    const PackIt& pack_it_;
    std::vector<Design> found_;
    std::optional<Error> why_not_;
};

}  // namespace

void choose_cases(const std::vector<KnownCase>& known, CaseChoice choice, PlanWishes& wishes) {
    wishes.cases.clear();
    wishes.in_known_case = choice == CaseChoice::hard_cases;
    if (choice == CaseChoice::none) return;
    for (const KnownCase& each : known)
        if ((each.kind == "hard case") == wishes.in_known_case && (each.kind != "parcel class" || each.price))
            wishes.cases.push_back(each);
}

Result<std::vector<Design>> planned_designs(std::span<Object> objects, const Design& design,
                                            const PlanWishes& wishes, const PackIt& pack_it,
                                            const Progress& progress) {
    return Planner(objects, design, wishes, pack_it).find(progress);
}

}  // namespace snug

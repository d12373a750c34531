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

bool is_turned(const Design& design) {
    return design.placement.rotation_deg != Vec3d() || design.placement.offset_mm != Vec3d() ||
           design.search.upright.has_value();
}

bool is_whole(std::span<const Object> objects) {
    return std::all_of(objects.begin(), objects.end(), [](const Object& each) { return each.whole(); });
}

class Planner {
  public:
    Planner(std::span<Object> objects, const Design& design, const PlanWishes& wishes, const PackIt& pack_it)
        : objects_(objects), given_(design), wishes_(wishes), pack_it_(pack_it) {}

    Result<std::vector<PlannedDesign>> find(const Progress& progress) {
        double done = 0;
        for (const Workshop work : wishes_.ways) {
            const std::vector<std::optional<FoamMaterial>> foams = foams_for(work);
            for (const auto& foam : foams) {
                const double share = 1.0 / static_cast<double>(wishes_.ways.size() * foams.size());
                if (auto added = add(work, foam, part_of(progress, done, done + share)); !added) {
                    if (added.error().kind == ErrorKind::cancelled) return tl::unexpected(added.error());
                    if (!why_not_) why_not_ = added.error();
                }
                done += share;
            }
        }
        if (found_.empty()) return tl::unexpected(*why_not_);
        return std::move(found_);
    }

  private:
    /// The design's own; else those with data where a shock can be compared with them, and what is worked so.
    [[nodiscard]] std::vector<std::optional<FoamMaterial>> foams_for(Workshop work) const {
        if (given_.protection.foam) return {given_.protection.foam};
        std::vector<std::optional<FoamMaterial>> all;
        const bool cut = work == Workshop::sheets || work == Workshop::mill;
        if (cut && given_.protection.drops())
            for (const FoamMaterial& foam : wishes_.foams)
                if (!foam.curve.empty()) all.push_back(foam);
        if (all.empty()) all.push_back({});
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
        return checked(std::move(design));  // what follows from the way of working, too
    }

    Result<void> add(Workshop work, const std::optional<FoamMaterial>& foam, const Progress& progress) {
        auto begun = started(work, foam);
        if (!begun) return tl::unexpected(begun.error());
        PlannedDesign planned{std::move(*begun)};
        Design& design = planned.design;
        const bool walls_given = design.space.wall_mm.has_value();
        if (!walls_given) design.space.wall_mm = equal_walls(usual_wall_mm(work, wishes_.carrier));
        if (auto done = lay(design, part_of(progress, 0, 0.3)); !done) return done;
        const bool fitted = !design.case_options.inside_mm && !given_.space.blocks;
        if (fitted && !walls_given && can_be_judged(design)) {
            Design open = design;
            open.space.blocks.reset();
            auto held = protecting_walls(objects_, open, pack_it_, part_of(progress, 0.3, 0.8));
            if (!held && held.error().kind == ErrorKind::cancelled) return tl::unexpected(held.error());
            planned.protects = held.has_value();
            if (held) design = std::move(*held);
        }
        found_.push_back(planned);
        if (!fitted) return {};
        if (!walls_given) add_more_foam(planned);
        return add_known_cases(planned);
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

    void add_more_foam(PlannedDesign planned) {
        SpaceOptions& space = planned.design.space;
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
        planned.more = true;
        found_.push_back(std::move(planned));
    }

    /// The smallest that hold an only item with its walls.
    Result<void> add_known_cases(const PlannedDesign& planned) {
        const Design& design = planned.design;
        if (wishes_.cases.empty() || design.items.size() > 1 || design.space.open) return {};
        const auto packing = pack_it_(design);
        if (!packing) return tl::unexpected(packing.error());
        const Cargo cargo{packing->items.front().placement.bounds.size(), design.workshop.mass_kg,
                          design.search.billed_divisor};
        std::vector<RankedCase> fitting = rank_cases(wishes_.cases, design, cargo).fitting;
        const auto volume = [](const RankedCase& each) {
            const Vec3d inside = each.known.inside_mm;
            return inside.x * inside.y * inside.z;
        };
        std::stable_sort(fitting.begin(), fitting.end(),
                         [&](const RankedCase& a, const RankedCase& b) { return volume(a) < volume(b); });
        for (std::size_t i = 0; i < std::min(kMostCases, fitting.size()); ++i) {
            PlannedDesign in_case = planned;
            apply(fitting[i].known, in_case.design.case_options);
            in_case.design.placement.rotation_deg =
                rotation_for(fitting[i].lay, design.placement.rotation_deg);
            in_case.protects = false;
            found_.push_back(std::move(in_case));
        }
        return {};
    }

    std::span<Object> objects_;
    const Design& given_;
    const PlanWishes& wishes_;
    const PackIt& pack_it_;
    std::vector<PlannedDesign> found_;
    std::optional<Error> why_not_;
};

}  // namespace

std::vector<KnownCase> cases_to_choose(std::vector<KnownCase> known, CaseChoice choice) {
    if (choice == CaseChoice::none) return {};
    std::erase_if(known, [&](const KnownCase& each) {
        return (each.kind == "hard case") != (choice == CaseChoice::hard_cases);
    });
    return known;
}

Result<std::vector<PlannedDesign>> planned_designs(std::span<Object> objects, const Design& design,
                                                   const PlanWishes& wishes, const PackIt& pack_it,
                                                   const Progress& progress) {
    return Planner(objects, design, wishes, pack_it).find(progress);
}

}  // namespace snug

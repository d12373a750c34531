#include "snug/search/search_design.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/search/exact_cut.h"
#include "snug/search/fit_case.h"
#include "snug/search/placement_search.h"
#include "snug/search/searched_zones.h"
#include "snug/search/shock_pose.h"
#include "snug/search/turn.h"
#include "snug/space/available.h"
#include "snug/space/case_space.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

/// The space that is searched, and the blocks that exist in it.
struct Room {
    DesignSpace space;
    Grid<Run> available;
};

Result<Room> room_of(const Design& design) {
    if (!design.case_options.inside_mm)
        return Room{{*design.space.blocks, design.space.block_mm}, all_blocks(*design.space.blocks)};
    const auto fitted = case_space(design.case_options, design.space.block_mm);
    if (!fitted) return tl::unexpected(fitted.error());
    return Room{fitted->space, available_blocks(*fitted)};
}

/// What is searched: an object and its zones.
struct Searched {
    const Object& object;
    std::vector<ItemZone> zones;
};

std::optional<long long> cut_where_it_stands(const Searched& searched, const Design& design,
                                             const Room& room) {
    const auto exact =
        exact_cut(*searched.object.prepared, room.space, design.cut, design.placement.rotation_deg,
                  design.placement.offset_mm, room.available, searched.zones);
    if (!exact) return {};
    return exact->cut_blocks;
}

/// Counts that were left open become those that the object needs as it stands.
std::optional<Error> settle_counts(const Searched& searched, Design& design) {
    if (design.space.blocks || design.case_options.inside_mm) return {};
    design.space.wall_mm = wanted_wall_mm(design.space);
    const PlacementOptions& at = design.placement;
    const Item item =
        lying(*searched.object.prepared, design.cut, searched.zones, at.rotation_deg, at.offset_mm);
    const Vec3d counts = fitted_blocks(room_of(item), design.space.block_mm, *design.space.wall_mm);
    if (std::max({counts.x, counts.y, counts.z}) > kMostBlocks)
        return Error{ErrorKind::usage, say("space.too_many_blocks", {{"blocks", dimensions(counts, 0)}})};
    design.space.blocks = vec_cast<int>(counts);
    design.placement.offset_mm = at.offset_mm + fitted_shift(design.space.block_mm, *design.space.wall_mm);
    return {};
}

/// Counts that are left open follow how it lies; so that is chosen first, each pose in the space it needs.
std::optional<Error> lay_for_shock(const Searched& searched, Design& design, const SearchTask& task,
                                   const SearchNews& news, SearchReport& report) {
    if (!task.placement || task.fit_case || !design.search.weighs(Objective::shock)) return {};
    if (design.space.blocks || design.case_options.inside_mm) return {};
    const auto told = [&](double share) { return !news || news(share, {}); };
    const auto pose = pose_of_least_shock(searched.object, design, task.pack_it, told);
    if (!pose) return pose.error();
    report.evaluations += pose->looked_at;
    report.cancelled = pose->cancelled;
    design.placement.rotation_deg = pose->rotation_deg;
    return {};
}

std::optional<Error> fit(const Searched& searched, Design& design, const SearchNews& news,
                         SearchReport& report) {
    const auto told = [&](double share) {
        report.cancelled = news && !news(share, {});
        return !report.cancelled;
    };
    const auto fitted = fit_case(searched.object.mesh, design, design.search.seed, told, searched.zones);
    if (!fitted) return fitted.error();
    report.evaluations += fitted->evaluations;
    design.space.wall_mm = design.space.wall_mm.value_or(equal_walls(50));
    design.space.blocks = fitted->blocks;
    design.placement = {fitted->rotation_deg, fitted_shift(design.space.block_mm, *design.space.wall_mm)};
    return {};
}

std::optional<Error> turn_and_shift(const Searched& searched, Design& design, const SearchTask& task,
                                    const SearchNews& news, SearchReport& report) {
    const Mesh& mesh = searched.object.mesh;
    auto room = room_of(design);
    if (!room) return room.error();
    const Turn stands = turn_of(rotation_from_euler(design.placement.rotation_deg));
    if (!allowed_turns(design.search, design.placement.rotation_deg).allows(stands) ||
        !cut_where_it_stands(searched, design, *room)) {
        const auto rotation = fitting_rotation(mesh, design, room->space, design.search.seed, searched.zones);
        if (!rotation) return rotation.error();
        design.placement = {*rotation, {}};
    }
    std::optional<ShockMargins> shocks;
    if (design.search.weighs(Objective::shock)) {
        auto started = ShockMargins::start(searched.object, design, room->space, task.pack_it);
        if (!started) return started.error();
        shocks = std::move(*started);
    }
    auto search =
        PlacementSearch::start(mesh, *searched.object.prepared, design, room->space, design.search.seed,
                               std::move(room->available), searched.zones, std::move(shocks));
    if (!search) return search.error();
    const auto tell = [&](const PlacementSearch& at) {
        return !news || news(static_cast<double>(at.evaluations()) / static_cast<double>(task.evaluations),
                             at.best().cut_blocks);
    };
    report.cancelled = !run(*search, task.evaluations, tell);
    report.evaluations += search->evaluations();
    design.placement = {search->best().rotation_deg, search->best().offset_mm};
    return {};
}

}  // namespace

Result<SearchReport> search_design(const Object& object, Design& design, const SearchTask& task,
                                   const SearchNews& news) {
    SearchReport report;
    report.seed = design.search.seed;
    if (task.fit_case && design.case_options.inside_mm)
        return fail(ErrorKind::usage, say("search.case_given"));
    if (const auto error = lacking_for_search(design)) return tl::unexpected(*error);
    auto zones = searched_zones(object, design);
    if (!zones) return tl::unexpected(zones.error());
    const Searched whole{object, std::move(*zones)};
    Design searched = design;
    if (auto error = lay_for_shock(whole, searched, task, news, report)) return tl::unexpected(*error);
    if (auto error = settle_counts(whole, searched); error && !task.fit_case) return tl::unexpected(*error);
    if (searched.space.blocks || searched.case_options.inside_mm) {
        const auto room = room_of(searched);
        if (!room) return tl::unexpected(room.error());
        report.start_cut_blocks = cut_where_it_stands(whole, searched, *room);
    }
    if (task.fit_case) {
        report.method = "fit-case";
        if (const auto error = fit(whole, searched, news, report)) return tl::unexpected(*error);
    }
    if (task.placement && !report.cancelled) {
        report.method += report.method.empty() ? "placement" : ", placement";
        if (const auto error = turn_and_shift(whole, searched, task, news, report))
            return tl::unexpected(*error);
    }
    const auto room = room_of(searched);
    if (!room) return tl::unexpected(room.error());
    report.cut_blocks = cut_where_it_stands(whole, searched, *room).value_or(0);
    design = searched;
    return report;
}

}  // namespace snug

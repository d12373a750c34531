#include "snug/search/search_design.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"
#include "snug/search/exact_cut.h"
#include "snug/search/fit_case.h"
#include "snug/search/placement_search.h"
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

std::optional<long long> cut_where_it_stands(const PreparedSurface& surface, const Design& design,
                                             const Room& room) {
    const auto exact = exact_cut(surface, room.space, design.cut, design.placement.rotation_deg,
                                 design.placement.offset_mm, room.available);
    if (!exact) return {};
    return exact->cut_blocks;
}

/// Counts that were left open become those that the object needs as it stands.
std::optional<Error> settle_counts(const PreparedSurface& surface, Design& design) {
    if (design.space.blocks || design.case_options.inside_mm) return {};
    design.space.wall_mm = wanted_wall_mm(design.space);
    const PlacementOptions& at = design.placement;
    const Vec3d counts = fitted_blocks(
        grown(place(surface, at.rotation_deg, at.offset_mm).bounds, design.cut.whole_clearance_mm()),
        design.space.block_mm, *design.space.wall_mm);
    if (std::max({counts.x, counts.y, counts.z}) > kMostBlocks)
        return Error{ErrorKind::usage, say("space.too_many_blocks", {{"blocks", dimensions(counts, 0)}})};
    design.space.blocks = vec_cast<int>(counts);
    design.placement.offset_mm = at.offset_mm + fitted_shift(design.space.block_mm, *design.space.wall_mm);
    return {};
}

std::optional<Error> fit(const Mesh& mesh, Design& design, const SearchNews& news, SearchReport& report) {
    const auto fitted = fit_case(mesh, design, design.search.seed, [&](double share) {
        report.cancelled = news && !news(share, {});
        return !report.cancelled;
    });
    if (!fitted) return fitted.error();
    report.evaluations += fitted->evaluations;
    design.space.wall_mm = design.space.wall_mm.value_or(equal_walls(50));
    design.space.blocks = fitted->blocks;
    design.placement = {fitted->rotation_deg, fitted_shift(design.space.block_mm, *design.space.wall_mm)};
    return {};
}

std::optional<Error> turn_and_shift(const Mesh& mesh, const PreparedSurface& surface, Design& design,
                                    const SearchTask& task, const SearchNews& news, SearchReport& report) {
    auto room = room_of(design);
    if (!room) return room.error();
    const Turn stands = turn_of(rotation_from_euler(design.placement.rotation_deg));
    if (!AllowedTurns(design.search.upright).allows(stands) || !cut_where_it_stands(surface, design, *room)) {
        const auto rotation = fitting_rotation(mesh, design, room->space, design.search.seed);
        if (!rotation) return rotation.error();
        design.placement = {*rotation, {}};
    }
    auto search = PlacementSearch::start(mesh, surface, design, room->space, design.search.seed,
                                         std::move(room->available));
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

Result<SearchReport> search_design(const Mesh& mesh, const PreparedSurface& surface, Design& design,
                                   const SearchTask& task, const SearchNews& news) {
    SearchReport report;
    report.seed = design.search.seed;
    if (task.fit_case && design.case_options.inside_mm)
        return fail(ErrorKind::usage, say("search.case_given"));
    Design searched = design;
    if (auto error = settle_counts(surface, searched); error && !task.fit_case) return tl::unexpected(*error);
    if (searched.space.blocks || searched.case_options.inside_mm) {
        const auto room = room_of(searched);
        if (!room) return tl::unexpected(room.error());
        report.start_cut_blocks = cut_where_it_stands(surface, searched, *room);
    }
    if (task.fit_case) {
        report.method = "fit-case";
        if (const auto error = fit(mesh, searched, news, report)) return tl::unexpected(*error);
    }
    if (task.placement && !report.cancelled) {
        report.method += report.method.empty() ? "placement" : ", placement";
        if (const auto error = turn_and_shift(mesh, surface, searched, task, news, report))
            return tl::unexpected(*error);
    }
    const auto room = room_of(searched);
    if (!room) return tl::unexpected(room.error());
    report.cut_blocks = cut_where_it_stands(surface, searched, *room).value_or(0);
    design = searched;
    return report;
}

}  // namespace snug

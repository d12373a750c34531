#include "snug/search/search_design.h"

#include <algorithm>

#include "snug/base/text.h"
#include "snug/foam/fitted_space.h"
#include "snug/search/exact_cut.h"
#include "snug/search/fit_case.h"
#include "snug/search/placement_search.h"
#include "snug/search/turn.h"

namespace snug {
namespace {

std::optional<long long> cut_where_it_stands(const PreparedSurface& surface, const Design& design) {
    const DesignSpace space{*design.space.blocks, design.space.block_mm};
    const auto exact =
        exact_cut(surface, space, design.cut, design.placement.rotation_deg, design.placement.offset_mm);
    if (!exact) return {};
    return exact->cut_blocks;
}

/// Counts that were left open become those that the object needs as it stands.
std::optional<Error> settle_counts(const PreparedSurface& surface, Design& design) {
    if (design.space.blocks) return {};
    design.space.wall_mm = wanted_wall_mm(design.space);
    const PlacementOptions& at = design.placement;
    const Vec3d counts = fitted_blocks(place(surface, at.rotation_deg, at.offset_mm).bounds,
                                       design.space.block_mm, design.cut.clearance_mm, *design.space.wall_mm);
    if (std::max({counts.x, counts.y, counts.z}) > kMostBlocks)
        return Error{ErrorKind::usage, "the object and its walls would need " + dimensions(counts, 0) +
                                           " blocks, more than 4096 on an axis: choose larger blocks"};
    design.space.blocks = vec_cast<int>(counts);
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
    design.placement = {fitted->rotation_deg, {}};
    return {};
}

std::optional<Error> turn_and_shift(const Mesh& mesh, const PreparedSurface& surface, Design& design,
                                    const SearchTask& task, const SearchNews& news, SearchReport& report) {
    const DesignSpace space{*design.space.blocks, design.space.block_mm};
    const Turn stands = turn_of(rotation_from_euler(design.placement.rotation_deg));
    if (!AllowedTurns(design.search.upright).allows(stands) || !cut_where_it_stands(surface, design)) {
        const auto rotation = fitting_rotation(mesh, design, space, design.search.seed);
        if (!rotation) return rotation.error();
        design.placement = {*rotation, {}};
    }
    auto search = PlacementSearch::start(mesh, surface, design, space, design.search.seed);
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
    Design searched = design;
    if (auto error = settle_counts(surface, searched); error && !task.fit_case) return tl::unexpected(*error);
    if (searched.space.blocks) report.start_cut_blocks = cut_where_it_stands(surface, searched);
    if (task.fit_case) {
        report.method = "fit-case";
        if (const auto error = fit(mesh, searched, news, report)) return tl::unexpected(*error);
    }
    if (task.placement && !report.cancelled) {
        report.method += report.method.empty() ? "placement" : ", placement";
        if (const auto error = turn_and_shift(mesh, surface, searched, task, news, report))
            return tl::unexpected(*error);
    }
    report.cut_blocks = cut_where_it_stands(surface, searched).value_or(0);
    design = searched;
    return report;
}

}  // namespace snug

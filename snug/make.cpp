#include "snug/make.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/check/find_foam_problems.h"
#include "snug/check/find_item_notes.h"
#include "snug/check/find_near_items.h"
#include "snug/check/find_object_problems.h"
#include "snug/check/find_pads.h"
#include "snug/check/find_relief.h"
#include "snug/check/near_collections.h"
#include "snug/check/protection.h"
#include "snug/check/relieved.h"
#include "snug/check/stability.h"
#include "snug/foam/item_cuts.h"
#include "snug/foam/object_cut.h"
#include "snug/foam/parting.h"
#include "snug/foam/ribs.h"
#include "snug/search/protecting_walls.h"
#include "snug/space/place_items.h"
#include "snug/space/space_for.h"
#include "snug/space/tray.h"

namespace snug {
namespace {

/// Where the items lie, and which blocks there are around them.
Result<Packing> placed(std::span<const Object> objects, const Design& design, const Progress& progress) {
    Packing packing;
    auto items = place_items(objects, design, progress);
    if (!items) return tl::unexpected(items.error());
    packing.items = std::move(*items);
    double least_clearance = packing.items.front().cut.whole_clearance_mm().least();
    for (const Item& item : packing.items)
        least_clearance = std::min(least_clearance, item.cut.whole_clearance_mm().least());
    auto room = space_for(room_of(packing.items), least_clearance, design);
    if (!room) return tl::unexpected(room.error());
    packing.space = room->space;
    packing.fitted_case = std::move(room->fitted_case);
    packing.available = std::move(room->available);
    return packing;
}

/// `find(i, findings)` for each item, whose name the findings bear where there are several.
template <class Find>
void of_each(Packing& packing, const Find& find) {
    for (std::size_t i = 0; i < packing.items.size(); ++i) {
        const std::size_t before = packing.findings.size();
        find(i, packing.findings);
        if (packing.items.size() > 1)
            for (std::size_t k = before; k < packing.findings.size(); ++k)
                packing.findings[k].of = packing.items[i].name;
    }
}

/// Whether an item leaves the space: a finding of each.
bool find_all_outside(const Design& design, Packing& packing) {
    of_each(packing, [&](std::size_t i, std::vector<Finding>& findings) {
        find_outside(packing.items[i], packing, design, findings);
    });
    return !packing.findings.empty();
}

/// What each item cuts where it lies, or where it comes to lie once it is settled.
Result<ItemCuts> cut_each(std::span<const Object> objects, const Design& design, Packing& packing,
                          KeptDepths* kept, const Progress& progress) {
    std::vector<bool> locked;
    for (const ItemOptions& item : design.items) locked.push_back(item.lock);
    auto all = design.fit.settle ? cut_settled(objects, packing.items, locked, packing.space, kept, progress)
                                 : cut_items(objects, packing.items, packing.space, kept, progress);
    if (!all) return all;
    packing.zone_cuts = all->zones;
    packing.timing.depth_map = all->depth_ms;
    packing.timing.block_map = all->cut_ms;
    if (design.space.open)  // above the uppermost layer there is no foam to give way
        for (std::size_t i = 0; i < all->cuts.size(); ++i)
            if (packing.items[i].layer == layers_of(design)) all->cuts[i].upper.reset();
    return all;
}

/// Of the uppermost layer of a tray.
void find_tray_problems(std::span<const Object> objects, const ItemCuts& cuts, double open,
                        Packing& packing) {
    of_each(packing, [&](std::size_t i, std::vector<Finding>& findings) {
        Item& item = packing.items[i];
        if (item.layer != packing.foams->layers()) return;
        const BlockMap& cut = cuts.cuts[i].lower;
        const int level = packing.foams->parting.back();
        item.tip_deg =
            tip_angle_deg(cut, packing.space, level, centre_of_mass(objects[item.object], item.placement));
        find_tray_problems(item, sunk_mm(open, item.placement.bounds), cut, level, packing.space, findings);
    });
}

void find_problems(std::span<const Object> objects, const ItemCuts& cuts, const Design& design,
                   Packing& packing) {
    of_each(packing, [&](std::size_t i, std::vector<Finding>& findings) {
        const Item& item = packing.items[i];
        find_object_problems(objects[item.object], item.placement, packing.space, *cuts.depths[i],
                             cuts.cuts[i], findings);
    });
    if (design.space.open) find_tray_problems(objects, cuts, *design.space.open, packing);
    if (packing.items.size() > 1)
        find_near_items(packing.items, cuts.cuts, packing.space, wanted_between_mm(design.space),
                        packing.findings);
    find_foam_problems(packing, design, packing.findings);
    find_item_notes(packing.items, packing.findings);
    std::vector<bool> told(objects.size(), false);  // once of each object, however often it lies there
    of_each(packing, [&](std::size_t i, std::vector<Finding>& findings) {
        const Item& item = packing.items[i];
        if (!told[item.object]) find_object_notes(objects[item.object], item.placement, findings);
        told[item.object] = true;
    });
    sort_by_severity(packing.findings);
}

/// What the items of each layer cut together, the lowest layer first.
std::vector<HalfCuts> united_in_layers(const std::vector<Item>& items, const std::vector<HalfCuts>& cuts,
                                       int layers) {
    std::vector<HalfCuts> all;
    for (int layer = 1; layer <= layers; ++layer) {
        std::vector<const HalfCuts*> own;
        for (std::size_t i = 0; i < items.size(); ++i)
            if (items[i].layer == layer) own.push_back(&cuts[i]);
        all.push_back(united(own));
    }
    return all;
}

/// As chosen, or the best one in each layer, the uppermost at the line of the case's lid where it has one, or
/// where a tray ends.
Result<std::vector<int>> parting_levels(const Packing& packing, const std::vector<HalfCuts>& layers,
                                        const Design& design) {
    const int nx = packing.space.blocks.x;
    const PartingOptions& options = design.parting;
    if (options.level && options.level->each.back() > nx)
        return fail(ErrorKind::usage,
                    say("parting.too_high", {{"level", std::to_string(options.level->each.back())},
                                             {"blocks", std::to_string(nx)}}));
    if (options.level) return options.level->each;
    std::vector<int> levels(layers.size());
    for (std::size_t i = layers.size(); i-- > 0;) {
        const bool uppermost = i + 1 == layers.size();
        const std::vector<Item> own = of_layer(packing.items, static_cast<int>(i) + 1);
        if (uppermost && design.space.open)
            levels[i] = tray_level(*design.space.open, own, packing.space);
        else if (uppermost && packing.fitted_case && packing.fitted_case->lid_level)
            levels[i] = *packing.fitted_case->lid_level;
        else
            levels[i] = auto_parting_level(cut_by_either(layers[i]), packing.space, bounds_of(own));
        if (!uppermost) levels[i] = std::min(levels[i], levels[i + 1]);
    }
    return levels;
}

/// What a layer of items loses. In a tray the foam below the uppermost alone gives way, and none of it stands
/// above its surface.
BlockMap cut_of_layer(const HalfCuts& cuts, int level, bool uncovered) {
    BlockMap blocks = cut_by_both(cuts, level);
    if (!uncovered) return blocks;
    for (CutRun& run : blocks)
        if (!run.none()) run.first = std::min(run.first, static_cast<std::int16_t>(level));
    return blocks;
}

/// Takes more foam away than the items of a layer need, so that they can be lifted.
void cut_notches_of_layer(Packing& packing, const Design& design, const std::vector<HalfCuts>& cuts,
                          int number, NotchLevels levels, BlockMap& layer) {
    const bool uncovered = design.space.open && number == layers_of(design);
    for (std::size_t i = 0; i < packing.items.size(); ++i) {
        const Item& item = packing.items[i];
        if (item.layer != number) continue;
        const NotchedObject object{cut_of_layer(cuts[i], levels.parting, uncovered),
                                   packing.items.size() == 1};
        NotchPair pair = cut_notches(layer, object, packing.space, levels, *design.fit.notches,
                                     wanted_wall_mm(design.space));
        if (!pair.notches)
            packing.findings.push_back(
                {Severity::warning, pair.why_not, {}, packing.items.size() > 1 ? item.name : std::string()});
        else
            for (Notch& notch : *pair.notches) {
                notch.item = i;
                packing.notches.push_back(notch);
            }
    }
}

/// What each item takes of the foam, by itself: in a drop it tells whose pocket lies on a way.
std::vector<BlockMap> pockets_of(const std::vector<Item>& items, const std::vector<HalfCuts>& cuts,
                                 const std::vector<int>& parting, bool open) {
    std::vector<BlockMap> pockets;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto layer = static_cast<std::size_t>(items[i].layer);
        pockets.push_back(cut_of_layer(cuts[i], parting[layer - 1], open && layer == parting.size()));
    }
    return pockets;
}

/// What each layer loses to its items and to hands, and what is left.
Result<void> cut_layers(std::span<const Object> objects, Packing& packing, const Design& design,
                        const ItemCuts& items, const std::vector<HalfCuts>& layers, std::vector<int> parting,
                        const Progress& progress) {
    if (packing.items.size() > 1 && wants_protection(design))
        packing.pockets = pockets_of(packing.items, items.cuts, parting, design.space.open.has_value());
    int under = 0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool uncovered = design.space.open && i + 1 == layers.size();
        BlockMap layer = cut_of_layer(layers[i], parting[i], uncovered);
        if (design.fit.relief && i == 0)
            if (auto done = relieve(objects[packing.items.front().object], packing, design,
                                    items.cuts.front().lower, layer);
                !done)
                return done;
        if (design.fit.notches)
            cut_notches_of_layer(packing, design, items.cuts, static_cast<int>(i) + 1, {parting[i], under},
                                 layer);
        if (design.fit.least_rib_mm > 0)
            packing.rib_blocks += cut_thin_ribs(layer, packing.space, parting[i], design.fit.least_rib_mm);
        under = parting[i];
        for (const CutRun cut : layer)
            if (!cut.none()) under = std::max<int>(under, cut.end);
        packing.layers.push_back(std::move(layer));
    }
    if (!design.edits.empty()) {
        auto edited = apply_edits(design.edits,
                                  {objects, packing.items, packing.space, packing.available, parting,
                                   design.space.open.has_value()},
                                  packing.layers, progress);
        if (!edited) return tl::unexpected(edited.error());
        packing.edits = std::move(*edited);
    }
    packing.foams = split(packing.layers, std::move(parting), packing.available);
    if (design.space.open) packing.foams = without_lid(std::move(*packing.foams));
    if (design.fit.lift)
        packing.lift = cut_lift_slots(*packing.foams, packing.layers, packing.space, *design.fit.lift,
                                      wanted_between_mm(design.space));
    return {};
}

void add_findings(const std::vector<Finding>& more, std::vector<Finding>& findings) {
    findings.insert(findings.end(), more.begin(), more.end());
    sort_by_severity(findings);
}

/// Figures of a search with a stand-in are the stand-in's.
void note_stand_in(Packing& packing) {
    add_findings({{Severity::note, say("searched_stand_in")}}, packing.findings);
}

Progress told(const Tools& tools, Stage stage) {
    return tools.progress ? tools.progress(stage) : Progress();
}

}  // namespace

Result<Packing> pack(std::span<const Object> objects, const Design& design, const Progress& progress,
                     KeptDepths* kept) {
    auto packing = placed(objects, design, part_of(progress, 0, 0.4));
    if (!packing) return packing;
    if (find_all_outside(design, *packing)) return packing;

    const double edits_begin = design.edits.empty() ? 1 : 0.6;  // which may look at each object again
    const auto items = cut_each(objects, design, *packing, kept, part_of(progress, 0.4, edits_begin));
    if (!items) return tl::unexpected(items.error());
    // What zones keep free went down with settled items, in a case of any shape.
    if (design.fit.settle && find_all_outside(design, *packing)) return packing;

    Stopwatch watch;
    const std::vector<HalfCuts> layers = united_in_layers(packing->items, items->cuts, layers_of(design));
    auto parting = parting_levels(*packing, layers, design);
    if (!parting) return tl::unexpected(parting.error());
    if (auto done = cut_layers(objects, *packing, design, *items, layers, std::move(*parting),
                               part_of(progress, edits_begin, 1));
        !done)
        return tl::unexpected(done.error());
    if (design.fit.pads) {
        auto pads =
            fill_pads(packing->items, items->depths, *packing->foams, packing->space, *design.fit.pads);
        if (!pads) return tl::unexpected(pads.error());
        packing->pads = std::move(*pads);
    }
    packing->timing.foam_pair = watch.lap();

    packing->fit = fit_report(*packing->foams, packing->layers, packing->space, packing->available);
    // On islands the item lies on all of their foam.
    if (packing->relief) packing->fit.wall_mm[kFloor] = packing->relief->foam_mm;
    find_problems(objects, *items, design, *packing);
    return packing;
}

Result<Packing> pack(const Object& object, const Design& design, const Progress& progress) {
    return pack(std::span(&object, 1), design, progress);
}

Result<Made> make(std::span<Object> objects, Project& project, const Tools& tools) {
    Made made;
    made.language = tools.language;
    take_over_one_item(project);
    Design& design = project.design;
    if (tools.search && design.space.open) return fail(ErrorKind::usage, say("search.tray"));
    if (tools.search) {
        if (design.items.size() > 1)
            return fail(ErrorKind::usage,
                        say("search.one_item", {{"items", design.items.size()}, {"example", kPlacedItem}}));
        auto found = tools.search(objects.front(), design);
        if (!found) return tl::unexpected(found.error());
        made.search = std::move(*found);
    }

    const bool fitted = !design.space.blocks && !design.case_options.inside_mm;
    if (tools.arrange && design.items.size() > 1) {
        auto found = tools.arrange(objects, design);
        if (!found) return tl::unexpected(found.error());
        made.arrangement = *found;
    }

    bool moved_apart = false;
    if (tools.protecting_walls) {
        // What was arranged lies where it lies; the space fits itself to it again.
        if (fitted && made.arrangement) design.space.blocks.reset();
        const auto pack_it = [&](const Design& tried) {
            auto packing = pack(objects, tried);
            for (Object& object : objects) take_stand_in(object);
            return packing;
        };
        auto found = protecting_walls(objects, design, pack_it, told(tools, Stage::walls));
        if (!found) return tl::unexpected(found.error());
        moved_apart = found->items != design.items || found->space.between_mm != design.space.between_mm;
        design = std::move(*found);
        made.walls_chosen = true;
    }

    auto packing = pack(objects, design, told(tools, Stage::cut));
    if (!packing) return tl::unexpected(packing.error());
    made.packing = std::move(*packing);
    for (Object& object : objects) take_stand_in(object);
    const bool whole =
        std::all_of(objects.begin(), objects.end(), [](const Object& each) { return each.whole(); });
    if ((made.search || made.arrangement) && !whole) note_stand_in(made.packing);
    if (!made.packing.foams) return made;
    if (design.fit.settle && std::all_of(made.packing.items.begin(), made.packing.items.end(),
                                         [](const Item& item) { return item.settled_mm == 0; }))
        add_findings({{Severity::note, say("settled_none")}}, made.packing.findings);
    if (moved_apart) add_findings({{Severity::note, say("moved_apart")}}, made.packing.findings);

    if (wants_protection(design)) {
        auto held = protection(objects, made.packing, design, told(tools, Stage::drops));
        if (!held) return tl::unexpected(held.error());
        made.packing.protection = std::move(*held);
        const auto offered = offered_relief(objects, design, made.packing);
        if (!offered) return tl::unexpected(offered.error());
        if (*offered) add_findings({(*offered)->finding}, made.packing.findings);
    }

    find_relief(made.packing, design, made.packing.findings);
    if (design.fit.pads) find_pads(made.packing, *design.fit.pads, made.packing.findings);
    find_near_collections(design, made.packing.findings);
    if (design.workshop.work != Workshop::none) {
        auto pack = workshop_pack(objects, made.packing, project,
                                  {tools.solve_lp, told(tools, Stage::workshop), tools.language});
        if (!pack) return tl::unexpected(pack.error());
        made.pack = std::move(*pack);
        add_findings(made.pack->findings, made.packing.findings);
    }

    auto fit = measure_fit(objects, made.packing, design, told(tools, Stage::gaps));
    if (!fit) return tl::unexpected(fit.error());
    made.fit = std::move(*fit);
    return made;
}

Result<Made> make(Object& object, Project& project, const Tools& tools) {
    return make(std::span(&object, 1), project, tools);
}

}  // namespace snug

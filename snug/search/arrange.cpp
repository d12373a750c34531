#include "snug/search/arrange.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/base/text.h"
#include "snug/object/prepare.h"
#include "snug/search/arranger.h"
#include "snug/search/arranging.h"
#include "snug/search/rank_cases.h"

namespace snug {
namespace {

constexpr std::array<double, 3> kUsualWalls{50, 25.4, 12.7};  // mm: parcels, makers of trays, thin foam

/// What the words call the first item that the choice is true of.
std::string name_of(const ItemOptions& item, std::span<const Object> objects) {
    if (!item.name.empty()) return item.name;
    const auto object = static_cast<std::size_t>(item.object);
    return object < objects.size() ? objects[object].name : std::string();
}

std::optional<Error> problem_of(const Design& design, std::span<const Object> objects) {
    for (const ItemOptions& item : design.items)
        if (item.lock && !item.offset_mm)
            return Error{ErrorKind::usage, say("arrange.locked_nowhere",
                                               {{"name", name_of(item, objects)}, {"example", kLockedItem}})};
    const auto items = static_cast<int>(design.items.size());
    const int layers = design.search.layers.value_or(1);
    if (layers > items)
        return Error{ErrorKind::usage, say("arrange.layers", {{"layers", layers}, {"items", items}})};
    return {};
}

/// One that keeps walls that the design does not name.
Result<Arrangement> arranged_with_walls(std::span<Object> objects, Design& design, const Walls& walls,
                                        const std::vector<bool>& locked, long long work,
                                        const ArrangeWatch& watch) {
    Design walled = design;
    walled.space.wall_mm = walls;
    Design arranged;
    auto found = Arranger(objects, walled, locked, work, watch).run(arranged, false);
    if (!found) return found;
    arranged.space.wall_mm.reset();
    design = std::move(arranged);
    return found;
}

/// With each of the walls that are to be tried, and at last with those of the design.
Result<Arrangement> with_walls_to_try(std::span<Object> objects, Design& design,
                                      const std::vector<bool>& locked, long long work,
                                      const ArrangeWatch& watch, bool explain) {
    for (const Walls& walls : walls_to_try(design)) {
        auto found = arranged_with_walls(objects, design, walls, locked,
                                         std::min(work, usual_arranging_work(design)) / 8, watch);
        if (found || found.error().kind != ErrorKind::does_not_fit) return found;
    }
    Design found_design = design;
    auto found = Arranger(objects, design, locked, work, watch).run(found_design, explain);
    if (found) design = std::move(found_design);
    return found;
}

/// In a known case, with the walls that a space has that is fitted to its items.
Result<Arrangement> in_case(std::span<Object> objects, Design& design, const std::vector<bool>& locked,
                            long long work, const ArrangeWatch& watch) {
    SpaceOptions fitted = design.space;
    fitted.blocks.reset();
    if (!fitted.wall_mm)
        return arranged_with_walls(objects, design, wanted_wall_mm(fitted), locked, work, watch);
    Design arranged;
    auto found = Arranger(objects, design, locked, work, watch).run(arranged, false);
    if (found) design = std::move(arranged);
    return found;
}

/// Those that may be as heavy, by volume or, where that is what counts, by what a carrier bills.
std::vector<std::size_t> cheapest_first(const std::vector<KnownCase>& known, const Design& design) {
    const Cargo cargo{{}, mass_kg(design), design.search.billed_divisor};
    std::vector<std::tuple<double, double, std::size_t>> priced;
    for (std::size_t i = 0; i < known.size(); ++i) {
        const KnownCase& one = known[i];
        if (cargo.mass_kg && one.most_kg && *cargo.mass_kg + one.tare_kg.value_or(0) > *one.most_kg) continue;
        const bool billed = design.search.case_goal == CaseGoal::billed_weight;
        priced.emplace_back(billed ? billed_kg(one, cargo).value_or(0) : 0,
                            one.inside_mm.x * one.inside_mm.y * one.inside_mm.z, i);
    }
    std::sort(priced.begin(), priced.end());
    std::vector<std::size_t> order;
    for (const auto& each : priced) order.push_back(std::get<2>(each));
    return order;
}

}  // namespace

Result<void> begin_arranging(std::span<Object> objects, const Design& design, const ArrangeWatch& watch) {
    if (const auto error = problem_of(design, objects)) return tl::unexpected(*error);
    const Progress progress = [&](double) { return !watch.go_on || watch.go_on(0, {}); };
    for (Object& object : objects) {
        if (auto done = mark_stand_in(object, progress); !done) return done;
        prepare_for_many(object);
    }
    return {};
}

std::vector<bool> locked_items(const Design& design, bool all) {
    std::vector<bool> locked;
    for (const ItemOptions& item : design.items) locked.push_back(item.lock || (!all && item.offset_mm));
    return locked;
}

bool has_given_space(const Design& design) {
    return design.case_options.inside_mm || design.space.blocks;
}

std::vector<Walls> walls_to_try(const Design& design) {
    if (design.space.wall_mm || !has_given_space(design)) return {};
    std::vector<Walls> walls;
    for (const double mm : kUsualWalls) walls.push_back(equal_walls(mm));
    return walls;
}

Result<Arrangement> arranged(std::span<Object> objects, Design& design, const std::vector<bool>& locked,
                             long long work, const ArrangeWatch& watch, bool explain) {
    if (design.fit.notches && has_given_space(design)) {
        Design without = design;
        without.fit.notches.reset();
        // Rather without room for hands beside all of them than not at all.
        auto found = with_walls_to_try(objects, design, locked, work / 4, watch, false);
        if (found || found.error().kind != ErrorKind::does_not_fit) return found;
        found = with_walls_to_try(objects, without, locked, work, watch, explain);
        without.fit.notches = design.fit.notches;
        if (found) design = std::move(without);
        return found;
    }
    return with_walls_to_try(objects, design, locked, work, watch, explain);
}

long long usual_arranging_work(const Design& design) {
    constexpr long long kOfEach = 200'000'000, kMost = 5'000'000'000;
    return std::min(kMost, kOfEach * static_cast<long long>(design.items.size()));
}

Result<Arrangement> arrange(std::span<Object> objects, Design& design, bool all, long long work,
                            const ArrangeWatch& watch) {
    Stopwatch stopwatch;
    if (auto done = begin_arranging(objects, design, watch); !done) return tl::unexpected(done.error());
    auto found = arranged(objects, design, locked_items(design, all), work, watch, true);
    if (found) found->ms = stopwatch.lap();
    return found;
}

Result<Arrangement> arrange_in_known_case(std::span<Object> objects, Design& design, bool all,
                                          const std::vector<KnownCase>& known, long long work,
                                          const ArrangeWatch& watch) {
    Stopwatch stopwatch;
    if (auto done = begin_arranging(objects, design, watch); !done) return tl::unexpected(done.error());
    const std::vector<std::size_t> by_price = cheapest_first(known, design);
    for (const std::size_t i : by_price) {
        Design tried = design;
        apply(known[i], tried.case_options);
        if (snug::problem_of(tried.case_options)) continue;
        auto found = in_case(objects, tried, locked_items(tried, all),
                             std::min(work / 8, usual_arranging_work(design) / 4), watch);
        if (!found && found.error().kind == ErrorKind::does_not_fit) continue;
        if (!found) return found;
        design = std::move(tried);
        found->ms = stopwatch.lap();
        return found;
    }
    return fail(ErrorKind::does_not_fit, say("arrange.no_known_case", {{"cases", by_price.size()}}));
}

}  // namespace snug

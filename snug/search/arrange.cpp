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
    if (auto error = lacking_for_search(design)) return error;
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

std::vector<Design> wishes_to_try(const Design& design) {
    std::vector<Design> wishes;
    if (!has_given_space(design)) return wishes;
    for (const bool hands : {true, false}) {
        if (hands && !design.fit.notches) continue;
        Design wish = design;
        if (!hands) wish.fit.notches.reset();
        if (design.space.wall_mm) {
            if (hands) wishes.push_back(wish);
            continue;
        }
        for (const double mm : kUsualWalls) {
            wish.space.wall_mm = equal_walls(mm);
            wishes.push_back(wish);
        }
    }
    return wishes;
}

Design as_asked(Design arranged, const Design& asked) {
    if (has_given_space(asked)) arranged.space.wall_mm = asked.space.wall_mm;
    arranged.fit.notches = asked.fit.notches;
    return arranged;
}

Result<Arrangement> arranged(std::span<Object> objects, Design& design, const std::vector<bool>& locked,
                             long long work, const ArrangeWatch& watch, bool explain) {
    const ArrangeWatch told{watch.go_on,
                            [&](const Design& better) {
                                if (watch.better) watch.better(as_asked(better, design));
                            },
                            watch.pack_it
                                ? [&](const Design& tried) { return watch.pack_it(as_asked(tried, design)); }
                                : PackIt()};
    const auto look = [&](const Design& wish, long long most, bool tell) {
        Design found_design;
        auto found = Arranger(objects, wish, locked, most, told).run(found_design, tell);
        if (found) design = as_asked(std::move(found_design), design);
        return found;
    };
    for (const Design& wish : wishes_to_try(design)) {
        auto found = look(wish, std::min(work, usual_arranging_work(design)) / 8, false);
        if (found || found.error().kind != ErrorKind::does_not_fit) return found;
    }
    Design last = design;
    if (has_given_space(design)) last.fit.notches.reset();  // which the wishes had
    return look(last, work, explain);
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

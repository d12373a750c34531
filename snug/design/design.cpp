#include "snug/design/design.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/design/option_list.h"

namespace snug {
namespace {

using DesignProblem = std::optional<OptionProblem>;

constexpr double kTrayWall = 25.4;  // mm, an inch

DesignProblem problem_of_clearance(const CutOptions& cut, Vec3d block) {
    const double least = least_clearance_mm(block);
    const Clearance whole = cut.whole_clearance_mm();
    const double most =
        std::max({whole.lower.x, whole.lower.y, whole.lower.z, whole.upper.x, whole.upper.y, whole.upper.z});
    if (!(most <= kGreatestLength))
        return OptionProblem{"cut.clearance_mm", say("clearance.most", {{"most", number(kGreatestLength)}})};
    if (whole.least() >= least) return {};
    return OptionProblem{"cut.clearance_mm", say("clearance.least", {{"least", number(least, 4)},
                                                                     {"found", number(whole.least(), 4)}})};
}

DesignProblem problem_of_parting(const Design& design) {
    if (!design.parting.level) return {};
    const std::vector<int>& levels = design.parting.level->each;
    const int most = highest_parting(design), layers = layers_of(design);
    const auto problem = [](Message message) { return OptionProblem{"parting.level", std::move(message)}; };
    if (static_cast<int>(levels.size()) != layers)
        return problem(say("parting.layers",
                           {{"layers", std::to_string(layers)}, {"found", std::to_string(levels.size())}}));
    for (const int level : levels)
        if (level > most)
            return problem(
                say("parting.range", {{"most", std::to_string(most)}, {"found", std::to_string(level)}}));
    if (std::adjacent_find(levels.begin(), levels.end(), std::greater_equal<>()) != levels.end())
        return problem(say("parting.not_rising"));
    return {};
}

/// No layer below the uppermost may be empty.
DesignProblem problem_of_layers(const Design& design) {
    const int layers = layers_of(design);
    for (int layer = 1; layer < layers; ++layer)
        if (std::none_of(design.items.begin(), design.items.end(),
                         [&](const ItemOptions& item) { return item.layer == layer; }))
            return OptionProblem{"items",
                                 say("items.empty_layer", {{"layer", std::to_string(layer)},
                                                           {"layers", std::to_string(layers)},
                                                           {"example", "layer=" + std::to_string(layer)}})};
    return {};
}

}  // namespace

double millimetres(Unit unit) {
    switch (unit) {
        case Unit::mm:
            return 1;
        case Unit::cm:
            return 10;
        case Unit::m:
            return 1000;
        case Unit::in:
            return 25.4;
    }
    return 1;
}

double wanted_between_mm(const SpaceOptions& space) {
    constexpr double kUsualLeast = 12.7;  // half an inch
    return space.between_mm.value_or(std::max({kUsualLeast, space.block_mm.y, space.block_mm.z}));
}

Walls wanted_wall_mm(const SpaceOptions& space) {
    Walls walls = space.wall_mm.value_or(equal_walls(space.blocks ? 0 : space.open ? kTrayWall : 50));
    if (space.open && !space.wall_mm) walls[0] = kTrayWall;
    if (space.open) walls[1] = 0;
    return walls;
}

double least_clearance_mm(Vec3d block_mm) {
    return kLeastClearanceShare * std::min({block_mm.x, block_mm.y, block_mm.z});
}

int layers_of(const Design& design) {
    int layers = 1;
    for (const ItemOptions& item : design.items) layers = std::max(layers, item.layer);
    return layers;
}

int highest_parting(const Design& design) {
    const bool fitted_to_case = design.case_options.inside_mm.has_value();
    const auto& blocks = design.space.blocks;
    return blocks && !fitted_to_case ? blocks->x : kMostBlocks;
}

DesignProblem problem_of(const ObjectOptions& object) {
    if (auto found = out_of_range(object)) return found;
    if (auto found = problem_of(object.clean)) return found->within("clean");
    return {};
}

DesignProblem problem_of(const Design& design) {
    if (auto found = out_of_range(design)) return found;
    if (auto found = problem_of(design.object)) return found->within("object");
    if (auto found = problem_of_clearance(design.cut, design.space.block_mm)) return found;
    for (std::size_t i = 0; i < design.items.size(); ++i)
        if (auto found = problem_of_clearance(cut_of(design.items[i], design), design.space.block_mm))
            return OptionProblem{"items." + std::to_string(i) + ".clearance_mm", found->message};
    for (std::size_t i = 0; i < design.items.size(); ++i)
        if (auto wrong = problem_of(design.items[i].zones))
            return OptionProblem{"items." + std::to_string(i) + ".zones", std::move(*wrong)};
    if (auto found = problem_of_layers(design)) return found;
    if (auto found = problem_of_parting(design)) return found;
    if (auto wrong = problem_of(design.edits)) return OptionProblem{"edits", std::move(*wrong)};
    if (design.output.formats.empty()) return OptionProblem{"output.formats", say("formats.none")};
    if (auto found = problem_of(design.case_options)) return found->within("case");
    if (auto found = problem_of(design.protection)) return found->within("protection");
    if (design.space.open && design.protection.drops())
        return OptionProblem{"protection.height_mm", say("protection.tray", {{"option", "--open"}})};
    if (auto found = problem_of(design.search)) return found->within("search");
    if (auto found = problem_of(design.workshop)) return found->within("workshop");
    return {};
}

CutOptions cut_of(const ItemOptions& item, const Design& design) {
    CutOptions cut = design.cut;
    cut.clearance_mm = item.clearance_mm.value_or(cut.clearance_mm);
    return cut;
}

const Zones& zones_of(const ItemOptions& item, const Design& design) {
    return item.zones.empty() ? design.protection.zones : item.zones;
}

std::optional<double> mass_kg(const Design& design) {
    double sum = 0;
    for (const ItemOptions& item : design.items) {
        const auto own = mass_kg(item, design);
        if (!own) return {};
        sum += *own;
    }
    return sum;
}

std::optional<double> mass_kg(const ItemOptions& item, const Design& design) {
    return item.mass_kg ? item.mass_kg : design.workshop.mass_kg;
}

Result<Design> checked(Design design) {
    design.cut.stud_mm = design.workshop.work == Workshop::bricks ? kStudHeight : 0;
    if (const auto found = problem_of(design)) return fail(ErrorKind::usage, found->message);
    return design;
}

}  // namespace snug

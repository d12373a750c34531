#include "snug/search/arranger.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>

#include "snug/base/text.h"
#include "snug/search/cut_and_balance.h"
#include "snug/search/layer_heights.h"
#include "snug/space/available.h"
#include "snug/space/fitted_space.h"
#include "snug/space/place_items.h"
#include "snug/space/tray.h"

namespace snug {
namespace {

constexpr int kMostOpenLayers = 4;             // that are tried where their number is left open
constexpr long long kFirstSlice = 10'000'000;  // of the work, for one choice of heights among several
constexpr long long kLongest = 1 << 8;         // of equal volumes the least stretched is best
constexpr long long kLike = 1LL << 46;         // a hundredth longer than another space counts before blocks
constexpr long long kBilled = 1LL << 46;       // half kilograms that a carrier bills count before blocks

/// The layers that are asked for: so many, or, where that is left open, one to a few.
std::vector<int> layer_counts(const Design& design) {
    if (design.search.layers == 1) return {layers_of(design)};
    if (design.search.layers) return {*design.search.layers};
    std::vector<int> counts;
    for (int i = 1; i <= std::min<int>(kMostOpenLayers, static_cast<int>(design.items.size())); ++i)
        counts.push_back(i);
    return counts;
}

/// Room for hands beside what is packed, on both sides of its narrower way, as one item has it.
void widen_for_notches(const NotchOptions& notches, MaskGap packed, Vec3d block_mm, BlockWalls& walls) {
    const Box3d room{{}, {0, packed.rows * block_mm.y, packed.columns * block_mm.z}};
    const Box3d wide = with_room_for_notches(room, block_mm, notches);
    for (const int axis : {1, 2}) {
        const int blocks = static_cast<int>(std::lround((room.min[axis] - wide.min[axis]) / block_mm[axis]));
        walls.side[static_cast<std::size_t>(2 * axis)] += blocks;
        walls.side[static_cast<std::size_t>(2 * axis) + 1] += blocks;
    }
}

/// No layer below the uppermost may be empty; they are renumbered without the empty ones.
void drop_empty_layers(MaskLayout& layout, int layers) {
    int to = 0;
    for (int from = 0; from < layers; ++from) {
        bool any = false;
        for (LaidMask& at : layout) {
            if (at.bin != from) continue;
            any = true;
            at.bin = to;
        }
        to += any;
    }
}

/// How high a tray's items stand follows from how deep they are sunk.
std::optional<Message> too_high_in_tray(std::span<const Object> objects, const Design& design,
                                        const std::optional<PackedSpace>& space) {
    if (!design.space.open || !space || !space->fitted_case) return {};
    const auto items = place_items(objects, design);
    if (!items) return {};
    for (const Item& item : *items)
        if (auto problem = too_high_for_case(item, *space->fitted_case, space->space)) return problem;
    return {};
}

}  // namespace

long long space_price(Vec3i blocks, const Design& design, Vec3d block_mm) {
    const Vec3d size{blocks.x * block_mm.x, blocks.y * block_mm.y, blocks.z * block_mm.z};
    const double share = std::max({size.x, size.y, size.z}) / (size.x + size.y + size.z);
    const long long price =
        1LL * blocks.x * blocks.y * blocks.z * kLongest + static_cast<long long>(share * (kLongest - 1));
    if (design.search.case_goal == CaseGoal::volume) return price;
    double cm3 = 1;
    for (int axis = 0; axis < 3; ++axis) cm3 *= std::ceil(size[axis] / 10 - 1e-9);
    return static_cast<long long>(std::ceil(2 * cm3 / design.search.billed_divisor - 1e-9)) * kBilled + price;
}

PackingWatch Arranger::packing_watch() {
    return [this](long long work) {
        const double share = static_cast<double>(done_ + work) / static_cast<double>(work_);
        if (watch_.go_on && !watch_.go_on(std::min(1.0, share), best_mm3_)) cancelled_ = true;
        return !cancelled_;
    };
}

std::vector<std::vector<int>> Arranger::all_heights(int most) const {
    const BlockWalls walls = block_walls(design_.space, masks_->block_mm);
    std::vector<std::vector<int>> all;
    for (const int layers : layer_counts(design_))
        for (auto& heights : layer_heights(*masks_, layers, walls, most)) all.push_back(std::move(heights));
    return all;
}

RoomTask Arranger::task_for(const std::vector<int>& heights) const {
    const BlockWalls walls = block_walls(design_.space, masks_->block_mm);
    RoomTask task;
    const int x = height_of_layers(heights, walls), y = walls.along(1), z = walls.along(2);
    task.price = [this, x, y, z](int rows, int columns) {
        const Vec3i blocks{x, rows + y, columns + z};
        const long long price = space_price(blocks, design_, masks_->block_mm);
        if (!like_) return price;
        return price + kLike * std::max(100LL * blocks.y / like_->y, 100LL * blocks.z / like_->z);
    };
    int rows = 0, columns = 0;  // more than all beside each other need none
    for (const MaskPiece& piece : masks_->problem.pieces) {
        int own_rows = 0, own_columns = 0;
        for (const int shape : piece.shapes) {
            const BitMask& mask = masks_->problem.shapes[static_cast<std::size_t>(shape)].mask;
            own_rows = std::max(own_rows, mask.rows());
            own_columns = std::max(own_columns, mask.columns());
        }
        rows += own_rows + masks_->problem.gap.rows;
        columns += own_columns + masks_->problem.gap.columns;
    }
    task.most_rows = std::clamp(rows, 1, std::max(1, most_.y - y));
    task.most_columns = std::clamp(columns, 1, std::max(1, most_.z - z));
    task.heights = heights;
    return task;
}

std::optional<long long> Arranger::least_blocks() const {
    if (masks_->any_locked()) return {};
    const BlockWalls walls = block_walls(design_.space, masks_->block_mm);
    std::optional<long long> least;
    for (const auto& heights : all_heights(std::numeric_limits<int>::max())) {
        RoomTask task = task_for(heights);
        const int x = height_of_layers(heights, walls), y = walls.along(1), z = walls.along(2);
        task.price = [x, y, z](int rows, int columns) { return 1LL * x * (rows + y) * (columns + z); };
        const long long price = least_price(masks_->problem, task);
        if (price < std::numeric_limits<long long>::max()) least = std::min(least.value_or(price), price);
    }
    return least;
}

Arranger::Found Arranger::found_in_room(const PackedMasks& packed, const std::vector<int>& heights) const {
    Found found;
    found.layout = packed.layout;
    found.heights = heights;
    found.walls = block_walls(design_.space, masks_->block_mm);
    if (design_.fit.notches)
        widen_for_notches(*design_.fit.notches, {packed.rows, packed.columns}, masks_->block_mm, found.walls);
    found.room = {packed.rows, packed.columns, heights, {}};
    found.levels = layer_levels(heights, found.walls);
    found.space = {{height_of_layers(heights, found.walls), packed.rows + found.walls.along(1),
                    packed.columns + found.walls.along(2)},
                   masks_->block_mm};
    return found;
}

/// The heaviest layer becomes the lowest, where no item has a layer of its own.
void Arranger::put_heaviest_low(const ItemMasks& masks, Found& found) const {
    const bool chosen = std::any_of(masks.problem.pieces.begin(), masks.problem.pieces.end(),
                                    [](const MaskPiece& piece) { return piece.bin >= 0 || piece.locked; });
    const int layers = static_cast<int>(found.heights.size());
    if (chosen || layers < 2 || !found.room.refused.empty()) return;
    const std::vector<int> order = heaviest_first(found.layout, masks.mass, layers);
    std::vector<int> heights, place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        heights.push_back(found.heights[static_cast<std::size_t>(order[i])]);
    }
    for (LaidMask& at : found.layout) at.bin = place[static_cast<std::size_t>(at.bin)];
    const auto parting = found.levels.back().parting;
    const int below = found.levels.front().first - found.walls.side[kFloor];
    if (!design_.space.open) found.room.heights = heights;
    found.heights = heights;
    found.levels = layer_levels(heights, found.walls);
    for (LayerLevels& level : found.levels) level.first += below;
    found.levels.back().parting = parting;
}

/// Foam is as thick on both sides of a layer, where blocks are all there.
void Arranger::centre_layers(const ItemMasks& masks, Found& found) const {
    if (!found.room.refused.empty() || masks.any_locked()) return;
    for (int layer = 0; layer < static_cast<int>(found.heights.size()); ++layer) {
        int first_row = found.room.rows, first_column = found.room.columns, end_row = 0, end_column = 0;
        for (const LaidMask& at : found.layout) {
            if (at.bin != layer) continue;
            const BitMask& mask = masks.ways[static_cast<std::size_t>(at.shape)].mask;
            first_row = std::min(first_row, at.row);
            first_column = std::min(first_column, at.column);
            end_row = std::max(end_row, at.row + mask.rows());
            end_column = std::max(end_column, at.column + mask.columns());
        }
        const int down = (found.room.rows - end_row - first_row) / 2,
                  right = (found.room.columns - end_column - first_column) / 2;
        for (LaidMask& at : found.layout) {
            if (at.bin != layer) continue;
            at.row += down;
            at.column += right;
        }
    }
}

void Arranger::refine(const ItemMasks& masks, Found& found, MaskPacker& packer, long long most_work) const {
    CutAndBalance cost(masks, found.room, found.layout);
    packer.refine(found.room, found.layout, std::ref(cost), packer.work() + most_work);
}

void Arranger::finish(const ItemMasks& masks, Found& found) const {
    put_heaviest_low(masks, found);
    centre_layers(masks, found);
    drop_empty_layers(found.layout, static_cast<int>(found.heights.size()));
}

void Arranger::settle(const ItemMasks& masks, Found& found, MaskPacker& packer) {
    if (!cancelled_) refine(masks, found, packer, work_ / 4);
    const Found refined = found;
    finish(masks, found);
    if (!cancelled_ && watch_.pack_it && design_.search.weighs(Objective::shock))
        take_least_shock(masks, refined, found, packer);
}

Design Arranger::written(const ItemMasks& masks, const Found& found) const {
    Design design = design_;
    if (!given()) {
        design.space.wall_mm = wanted_wall_mm(design.space);
        design.space.blocks = found.space.blocks;
    }
    take_layout(masks, found.layout, found.levels, found.space, found.walls, design);
    if (given() || !design.space.open) return design;
    // How deep a tray must be follows from how its items are sunk.
    Design fitted = design;
    fitted.space.blocks.reset();
    if (const auto items = place_items(objects_, fitted))
        if (const auto room = space_for(room_of(*items), 0, fitted))
            design.space.blocks->x = room->space.blocks.x;
    return design;
}

void Arranger::tell(const ItemMasks& masks, const Found& found) {
    best_mm3_ = static_cast<double>(found.space.block_count()) * found.space.block_volume();
    if (watch_.better) watch_.better(written(masks, found));
}

Result<Arranger::Found> Arranger::in_free_space() {
    if (masks_->any_locked()) return around_locked();
    const auto choices = all_heights(kMostBlocks);
    MaskPacker packer(masks_->problem, design_.search.seed, packing_watch());
    std::optional<Found> best;
    long long price = -1;
    const auto look = [&](const std::vector<int>& heights, long long until) {
        RoomTask task = task_for(heights);
        task.known_price = price;
        task.work = until;
        const auto packed = smallest_room(
            packer, task, [&](const PackedMasks& each) { tell(*masks_, found_in_room(each, heights)); });
        if (!packed) return;
        price = packed->price;
        best = found_in_room(*packed, heights);
    };
    std::vector<std::pair<long long, std::size_t>> order;
    for (std::size_t i = 0; i < choices.size(); ++i)
        order.emplace_back(least_price(masks_->problem, task_for(choices[i])), i);
    std::sort(order.begin(), order.end());
    // Ever longer by turns, as long as more than one may still be better than the best, and worth a look.
    long long before = -1;
    for (long long slice = kFirstSlice; before != packer.work() && packer.work() < work_ && !cancelled_;
         slice *= 2) {
        before = packer.work();
        if (price >= 0) std::erase_if(order, [&](const auto& each) { return each.first >= price; });
        if (order.empty()) break;
        const bool alone = order.size() == 1;
        for (const auto& [least, i] : order)
            if (price < 0 || least < price)
                look(choices[i], alone ? work_ : std::min(work_, packer.work() + slice));
        if (alone) break;
    }
    done_ = packer.work();
    if (!best && cancelled_) return fail(ErrorKind::cancelled, say("cancelled"));
    if (!best) return fail(ErrorKind::usage, say("arrange.too_large"));
    settle(*masks_, *best, packer);
    return *best;
}

std::optional<Arranger::Found> Arranger::in_room(const ItemMasks& masks, const GivenRoom& given,
                                                 MaskPacker& packer, long long until) {
    if (given.room.rows < 1 || given.room.columns < 1 || !packer.each_fits(given.room) ||
        !may_hold(masks.problem, given.room))
        return {};
    MaskLayout layout = packer.laid_in_order(given.room, 0), best = layout;
    long long least = std::numeric_limits<long long>::max();
    for (int patience = 20; packer.work() < until && !packer.cancelled();
         patience = std::min(400, patience + 5)) {
        if (packer.separate(given.room, layout, patience, until))
            return Found{layout, given.room.heights, given.room, given.levels, given.space, given.walls};
        const long long clashes = packer.clashes(given.room, layout);
        if (clashes <= least) {
            least = clashes;
            best = layout;
        }
        const bool anew = packer.numbers().below(3) == 0;
        layout = anew ? packer.laid_in_order(given.room, 0.8) : best;
        for (int i = anew ? 0 : 1 + packer.numbers().below(3); i > 0; --i) packer.disturb(given.room, layout);
    }
    return {};
}

Result<Arranger::Found> Arranger::in_space(const PackedSpace& space, bool explain) {
    const BlockWalls walls = block_walls(design_.space, space.space.block_mm);
    auto masks = with_locked(*masks_, objects_, space.space, walls);
    if (!masks) return tl::unexpected(masks.error());
    MaskPacker packer(masks->problem, design_.search.seed, packing_watch());
    std::vector<std::vector<int>> choices;
    for (const int layers : layer_counts(design_)) {
        if (layers == 1)
            choices.push_back({space.space.blocks.x - walls.along(0)});
        else
            for (auto& heights : layer_heights(*masks, layers, walls, space.space.blocks.x))
                choices.push_back(std::move(heights));
    }
    if (choices.empty()) choices.push_back({space.space.blocks.x - walls.along(0)});
    long long before = -1;  // where nothing is worth a look no work is done
    for (long long slice = kFirstSlice; before != packer.work() && packer.work() < work_ && !cancelled_;
         slice *= 2) {
        before = packer.work();
        for (const auto& heights : choices) {
            const long long until = choices.size() == 1 ? work_ : std::min(work_, packer.work() + slice);
            auto found = in_room(*masks, given_room(space, *masks, design_, heights), packer, until);
            done_ = packer.work();
            if (!found) continue;
            found->heights = heights;
            tell(*masks, *found);
            settle(*masks, *found, packer);
            masks_ = std::move(*masks);
            return *found;
        }
    }
    if (cancelled_) return fail(ErrorKind::cancelled, say("cancelled"));
    if (!explain) return fail(ErrorKind::does_not_fit, say("arrange.too_large"));
    return tl::unexpected(does_not_fit(*masks, given_room(space, *masks, design_, choices.back())));
}

Result<Arrangement> Arranger::run(Design& design, bool explain) {
    std::optional<PackedSpace> space;
    if (given()) {
        auto found = space_for({}, 0, design_);
        if (!found) return tl::unexpected(found.error());
        space = std::move(*found);
    }
    const Progress progress = [&](double) { return !watch_.go_on || watch_.go_on(0, {}); };
    auto masks = item_masks(objects_, design_, space ? space->space.block_mm : design_.space.block_mm,
                            locked_, progress);
    if (!masks) return tl::unexpected(masks.error());
    masks_ = std::move(*masks);
    const auto least = space ? std::nullopt : least_blocks();
    auto found = space ? in_space(*space, explain) : in_free_space();
    if (!found) return tl::unexpected(found.error());
    design = written(*masks_, *found);
    // Such as parting levels that were chosen for another number of layers.
    if (const auto problem = problem_of(design)) return fail(ErrorKind::usage, problem->message);
    if (const auto problem = too_high_in_tray(objects_, design, space))
        return fail(ErrorKind::does_not_fit, *problem);
    Arrangement result;
    result.seed = design_.search.seed;
    result.work = done_;
    result.cancelled = cancelled_;
    DesignSpace last = found->space;
    if (!space) last.blocks = *design.space.blocks;
    result.volume_mm3 = static_cast<double>(last.block_count()) * last.block_volume();
    const bool tray = design_.space.open.has_value();
    if (least && !tray && !space) result.lower_bound_mm3 = static_cast<double>(*least) * last.block_volume();
    for (const LaidMask& at : found->layout)
        result.cut_blocks += masks_->ways[static_cast<std::size_t>(at.shape)].cut_blocks;
    return result;
}

}  // namespace snug

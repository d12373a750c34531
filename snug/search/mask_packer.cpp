#include "snug/search/mask_packer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "snug/base/vec.h"

namespace snug {
namespace {

constexpr std::uint16_t kFirstWeight = 16, kGreatestWeight = 16000;
constexpr std::uint32_t kRefused = 0xffffffff;
constexpr long long kRefusedDepth = 100;  // counts as much as a clash so deep
constexpr int kCellsOfStride = 16, kMostStride = 8;
constexpr std::size_t kClimbs = 5;
constexpr long long kAskedEvery = 1 << 20;  // of work

}  // namespace

MaskPacker::MaskPacker(MaskProblem problem, std::uint64_t seed, PackingWatch watch)
    : problem_(std::move(problem)), numbers_(seed), watch_(std::move(watch)) {
    const std::size_t shapes = problem_.shapes.size(), pieces = problem_.pieces.size();
    for (const MaskShape& shape : problem_.shapes) runs_.push_back(runs_of(shape.mask));
    for (const MaskPiece& piece : problem_.pieces) {
        long long least = problem_.shapes[static_cast<std::size_t>(piece.shapes.front())].mask.count();
        for (const int shape : piece.shapes)
            least = std::min(least, problem_.shapes[static_cast<std::size_t>(shape)].mask.count());
        size_.push_back(least);
    }
    int longest = 1;
    for (const MaskShape& shape : problem_.shapes)
        longest = std::max({longest, shape.mask.rows(), shape.mask.columns()});
    while (stride_ < kMostStride && longest >= 2 * stride_ * kCellsOfStride) stride_ *= 2;
    maps_.resize(shapes * shapes * 2);
    weights_.assign(pieces * pieces, kFirstWeight);
    all_.assign(pieces, 1);
}

const ClashMap& MaskPacker::clash_map(int fixed, int moved, bool gap) {
    const auto a = static_cast<std::size_t>(fixed), b = static_cast<std::size_t>(moved);
    auto& map = maps_[(a * problem_.shapes.size() + b) * 2 + (gap ? 1 : 0)];
    if (!map) {
        map = std::make_unique<ClashMap>(runs_[a], runs_[b], gap ? problem_.gap : MaskGap{}, stride_);
        work_ += static_cast<long long>(map->rows()) * map->columns() * 8;
    }
    return *map;
}

bool MaskPacker::keep_gap(std::size_t a, std::size_t b) const {
    const int group = problem_.pieces[a].group;
    return group < 0 || group != problem_.pieces[b].group;
}

int MaskPacker::clash(const MaskLayout& layout, std::size_t a, std::size_t b) {
    if (layout[a].bin != layout[b].bin) return 0;
    return clash_map(layout[a].shape, layout[b].shape, keep_gap(a, b))
        .depth(layout[b].row - layout[a].row, layout[b].column - layout[a].column);
}

long long MaskPacker::clashes(const MaskRoom& room, const MaskLayout& layout, std::size_t piece) {
    const LaidMask& at = layout[piece];
    const bool refused = !problem_.pieces[piece].locked && !room.refused.empty() &&
                         room.refused[static_cast<std::size_t>(at.shape)](at.row, at.column);
    long long sum = refused ? kRefusedDepth : 0;
    for (std::size_t other = 0; other < layout.size(); ++other)
        if (other != piece) sum += clash(layout, other, piece);
    return sum;
}

long long MaskPacker::clashes(const MaskRoom& room, const MaskLayout& layout) {
    long long sum = 0;
    for (std::size_t i = 0; i < layout.size(); ++i) sum += clashes(room, layout, i);
    return sum;
}

bool MaskPacker::goes_in(const MaskPiece& piece, int shape, int bin, const MaskRoom& room) const {
    const MaskShape& laid = problem_.shapes[static_cast<std::size_t>(shape)];
    return (piece.bin < 0 || piece.bin == bin) && laid.mask.rows() <= room.rows &&
           laid.mask.columns() <= room.columns && laid.height <= room.heights[static_cast<std::size_t>(bin)];
}

bool MaskPacker::each_fits(const MaskRoom& room) {
    const int bins = static_cast<int>(room.heights.size());
    for (const MaskPiece& piece : problem_.pieces) {
        bool fits = piece.locked.has_value();
        for (const int shape : piece.shapes)
            for (int bin = 0; bin < bins && !fits; ++bin) fits = goes_in(piece, shape, bin, room);
        if (!fits) return false;
    }
    return true;
}

MaskPacker::Places MaskPacker::fill_costs(const MaskRoom& room, const MaskLayout& layout, std::size_t piece,
                                          int shape, int bin, const std::vector<char>& present) {
    const BitMask& mask = problem_.shapes[static_cast<std::size_t>(shape)].mask;
    const Vec3i ends{0, room.rows - mask.rows() + 1, room.columns - mask.columns() + 1};
    const int s = stride_;
    const Places places{(ends.y + s - 1) / s, (ends.z + s - 1) / s, s};
    const auto width = static_cast<std::size_t>(places.columns);
    costs_.assign(static_cast<std::size_t>(places.rows) * width, 0);
    work_ += static_cast<long long>(costs_.size());
    for (std::size_t other = 0; other < layout.size(); ++other) {
        const LaidMask& fixed = layout[other];
        if (other == piece || present[other] == 0 || fixed.bin != bin) continue;
        const ClashMap& map = clash_map(fixed.shape, shape, keep_gap(piece, other));
        const int j0 = fixed.row + map.first_row(), k0 = fixed.column + map.first_column();
        const int k_first = (std::max(0, k0) + s - 1) / s;
        const int k_end = (std::min(ends.z, k0 + map.columns()) + s - 1) / s;
        const int j_end = (std::min(ends.y, j0 + map.rows()) + s - 1) / s;
        if (k_first >= k_end) continue;
        const std::uint16_t times = weight(piece, other);
        const auto count = static_cast<std::size_t>(k_end - k_first);
        for (int j = (std::max(0, j0) + s - 1) / s; j < j_end; ++j) {
            std::uint32_t* const sum =
                &costs_[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(k_first)];
            const std::uint16_t* const depth = map.places(j * s - j0, k_first * s - k0);
            for (std::size_t i = 0; i < count; ++i)
                sum[i] += static_cast<std::uint32_t>(times) * static_cast<std::uint32_t>(depth[i]);
            work_ += static_cast<long long>(count);
        }
    }
    if (!room.refused.empty()) {
        const BitMask& refused = room.refused[static_cast<std::size_t>(shape)];
        for (std::size_t i = 0; i < costs_.size(); ++i)
            if (const LaidMask at = places.at(i, shape, bin); refused(at.row, at.column))
                costs_[i] = kRefused;
    }
    return places;
}

std::uint32_t MaskPacker::cost_at(const MaskRoom& room, const MaskLayout& layout, std::size_t piece,
                                  const LaidMask& at, const std::vector<char>& present) {
    const BitMask& mask = problem_.shapes[static_cast<std::size_t>(at.shape)].mask;
    if (at.row < 0 || at.column < 0 || at.row + mask.rows() > room.rows ||
        at.column + mask.columns() > room.columns)
        return kRefused;
    if (!room.refused.empty() && room.refused[static_cast<std::size_t>(at.shape)](at.row, at.column))
        return kRefused;
    std::uint32_t sum = 0;
    for (std::size_t other = 0; other < layout.size(); ++other) {
        const LaidMask& fixed = layout[other];
        if (other == piece || present[other] == 0 || fixed.bin != at.bin) continue;
        const int depth = clash_map(fixed.shape, at.shape, keep_gap(piece, other))
                              .depth(at.row - fixed.row, at.column - fixed.column);
        sum += static_cast<std::uint32_t>(weight(piece, other)) * static_cast<std::uint32_t>(depth);
    }
    work_ += static_cast<long long>(layout.size());
    return sum;
}

/// Any of equals, with the same chance.
void MaskPacker::take_least(Places places, int shape, int bin, Least& least) {
    std::uint32_t lowest = kRefused;
    for (const std::uint32_t cost : costs_) lowest = std::min(lowest, cost);
    if (lowest == kRefused || lowest > least.cost) return;
    const int equals = static_cast<int>(std::count(costs_.begin(), costs_.end(), lowest));
    if (lowest < least.cost) least.equals = 0;
    least.cost = lowest;
    least.equals += equals;
    if (numbers_.below(least.equals) >= equals) return;
    int which = numbers_.below(equals);
    for (std::size_t i = 0; i < costs_.size(); ++i) {
        if (costs_[i] != lowest || which-- > 0) continue;
        least.at = places.at(i, shape, bin);
        return;
    }
}

void MaskPacker::climb_down(const MaskRoom& room, const MaskLayout& layout, std::size_t piece, Places places,
                            int shape, int bin, Least& least) {
    std::vector<std::pair<std::uint32_t, std::size_t>> starts;
    for (std::size_t i = 0; i < costs_.size(); ++i)
        if (costs_[i] != kRefused) starts.emplace_back(costs_[i], i);
    const auto kept = starts.begin() + static_cast<std::ptrdiff_t>(std::min(kClimbs, starts.size()));
    std::partial_sort(starts.begin(), kept, starts.end());
    for (auto start = starts.begin(); start != kept; ++start) {
        LaidMask at = places.at(start->second, shape, bin);
        std::uint32_t cost = start->first;
        for (int step = places.stride / 2; step > 0;) {
            LaidMask best = at;
            for (const auto& [j, k] :
                 {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1), std::pair(-1, -1),
                  std::pair(-1, 1), std::pair(1, -1), std::pair(1, 1)}) {
                const LaidMask beside{shape, bin, at.row + j * step, at.column + k * step};
                const std::uint32_t found = cost_at(room, layout, piece, beside, all_);
                if (found >= cost) continue;
                cost = found;
                best = beside;
            }
            if (best == at) step /= 2;
            at = best;
        }
        if (cost < least.cost) least = {at, cost, 0};
        if (cost == least.cost && numbers_.below(++least.equals) == 0) least.at = at;
    }
}

MaskPacker::Least MaskPacker::least_clash(const MaskRoom& room, const MaskLayout& layout, std::size_t piece) {
    Least least;
    const MaskPiece& moved = problem_.pieces[piece];
    for (int bin = 0; bin < static_cast<int>(room.heights.size()); ++bin)
        for (const int shape : moved.shapes)
            if (goes_in(moved, shape, bin, room)) {
                const Places places = fill_costs(room, layout, piece, shape, bin, all_);
                if (stride_ == 1)
                    take_least(places, shape, bin, least);
                else
                    climb_down(room, layout, piece, places, shape, bin, least);
            }
    if (least.equals == 0) least.at = layout[piece];
    return least;
}

LaidMask MaskPacker::lowest_place(const MaskRoom& room, const MaskLayout& layout, std::size_t piece,
                                  const std::vector<char>& present) {
    LaidMask best;
    std::array<long long, 3> lowest{};  // clash, the row where it ends, the column
    bool any = false;
    const MaskPiece& moved = problem_.pieces[piece];
    for (int bin = 0; bin < static_cast<int>(room.heights.size()); ++bin)
        for (const int shape : moved.shapes) {
            if (!goes_in(moved, shape, bin, room)) continue;
            const Places places = fill_costs(room, layout, piece, shape, bin, present);
            const auto least = std::min_element(costs_.begin(), costs_.end());
            if (*least == kRefused) continue;
            LaidMask laid = places.at(static_cast<std::size_t>(least - costs_.begin()), shape, bin);
            const auto free = [&](int rows, int columns) {
                const LaidMask moved_by{shape, bin, laid.row - rows, laid.column - columns};
                return stride_ > 1 && cost_at(room, layout, piece, moved_by, present) <= *least;
            };
            for (bool slides = true; slides;) {
                slides = false;
                for (; free(1, 0); slides = true) --laid.row;
                for (; free(0, 1); slides = true) --laid.column;
            }
            const std::array<long long, 3> key{
                *least, laid.row + problem_.shapes[static_cast<std::size_t>(shape)].mask.rows(), laid.column};
            if (any && !(key < lowest)) continue;
            any = true;
            lowest = key;
            best = laid;
        }
    if (!any) best = anywhere(room, piece);
    return best;
}

MaskLayout MaskPacker::laid_in_order(const MaskRoom& room, double shuffle) {
    const std::size_t count = problem_.pieces.size();
    std::vector<std::size_t> order;
    std::vector<double> key(count);
    std::vector<char> present(count, 0);
    MaskLayout layout(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (problem_.pieces[i].locked) {
            layout[i] = *problem_.pieces[i].locked;
            present[i] = 1;
            continue;
        }
        order.push_back(i);
        key[i] = static_cast<double>(size_[i]) * (1 - shuffle * numbers_.unit());
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key[a] > key[b]; });
    weights_.assign(weights_.size(), kFirstWeight);
    for (const std::size_t piece : order) {
        layout[piece] = lowest_place(room, layout, piece, present);
        present[piece] = 1;
    }
    return layout;
}

LaidMask MaskPacker::anywhere(const MaskRoom& room, std::size_t piece) {
    const MaskPiece& moved = problem_.pieces[piece];
    std::vector<LaidMask> ways;
    for (int bin = 0; bin < static_cast<int>(room.heights.size()); ++bin)
        for (const int shape : moved.shapes)
            if (goes_in(moved, shape, bin, room)) ways.push_back({shape, bin, 0, 0});
    if (ways.empty()) return {moved.shapes.front(), std::max(0, moved.bin), 0, 0};
    LaidMask at = ways[static_cast<std::size_t>(numbers_.below(static_cast<int>(ways.size())))];
    const BitMask& mask = problem_.shapes[static_cast<std::size_t>(at.shape)].mask;
    at.row = numbers_.below(room.rows - mask.rows() + 1);
    at.column = numbers_.below(room.columns - mask.columns() + 1);
    return at;
}

void MaskPacker::bring_inside(const MaskRoom& room, MaskLayout& layout) {
    const int bins = static_cast<int>(room.heights.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
        LaidMask& at = layout[i];
        if (problem_.pieces[i].locked) continue;
        if (at.bin >= bins || !goes_in(problem_.pieces[i], at.shape, at.bin, room)) {
            at = anywhere(room, i);
            continue;
        }
        const BitMask& mask = problem_.shapes[static_cast<std::size_t>(at.shape)].mask;
        at.row = std::min(at.row, room.rows - mask.rows());
        at.column = std::min(at.column, room.columns - mask.columns());
    }
}

void MaskPacker::disturb(const MaskRoom& room, MaskLayout& layout) {
    const int count = static_cast<int>(layout.size());
    const auto a = static_cast<std::size_t>(numbers_.below(count)),
               b = static_cast<std::size_t>(numbers_.below(count));
    if (a != b && numbers_.below(4) != 0 && !problem_.pieces[a].locked && !problem_.pieces[b].locked) {
        std::swap(layout[a].row, layout[b].row);
        std::swap(layout[a].column, layout[b].column);
        std::swap(layout[a].bin, layout[b].bin);
        bring_inside(room, layout);
    } else if (!problem_.pieces[a].locked) {
        layout[a] = anywhere(room, a);
    }
}

bool MaskPacker::go_on(long long most_work) {
    if (!cancelled_ && watch_ && work_ >= asked_at_) {
        asked_at_ = work_ + kAskedEvery;
        cancelled_ = !watch_(work_);
    }
    return !cancelled_ && work_ < most_work;
}

/// What clashes deepest weighs most from now on.
void MaskPacker::weigh(const MaskLayout& layout) {
    const std::size_t count = layout.size();
    std::vector<int> depth(count * count);
    int deepest = 1;
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < count; ++b)
            deepest = std::max(deepest, depth[a * count + b] = clash(layout, a, b));
    bool too_great = false;
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < count; ++b) {
            const int found = depth[a * count + b];
            if (found == 0) continue;
            std::uint16_t& here = weight(a, b);
            here = static_cast<std::uint16_t>(here + 1 + kFirstWeight * found / deepest);
            weight(b, a) = here;
            too_great = too_great || here > kGreatestWeight;
        }
    if (too_great)
        for (std::uint16_t& each : weights_) each = static_cast<std::uint16_t>(std::max(1, each / 2));
}

bool MaskPacker::separate(const MaskRoom& room, MaskLayout& layout, int idle_rounds, long long most_work) {
    weights_.assign(weights_.size(), kFirstWeight);
    MaskLayout best = layout;
    long long least = clashes(room, layout);
    std::vector<std::size_t> order;
    for (int idle = 0; least > 0 && idle < idle_rounds && go_on(most_work); ++idle) {
        order.clear();
        for (std::size_t i = 0; i < layout.size(); ++i)
            if (!problem_.pieces[i].locked && clashes(room, layout, i) > 0) order.push_back(i);
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[static_cast<std::size_t>(numbers_.below(static_cast<int>(i)))]);
        for (const std::size_t piece : order)
            if (clashes(room, layout, piece) > 0) layout[piece] = least_clash(room, layout, piece).at;
        const long long sum = clashes(room, layout);
        if (sum < least) {
            least = sum;
            best = layout;
            idle = -1;
        }
        weigh(layout);
    }
    layout = std::move(best);
    return least == 0;
}

void MaskPacker::refine(const MaskRoom& room, MaskLayout& layout, const LayoutCost& cost,
                        long long most_work) {
    for (bool better = true; better;) {
        better = false;
        for (std::size_t piece = 0; piece < layout.size() && go_on(most_work); ++piece) {
            const MaskPiece& moved = problem_.pieces[piece];
            if (moved.locked) continue;
            LaidMask best = layout[piece];
            long long least = cost(piece, best);
            for (int bin = 0; bin < static_cast<int>(room.heights.size()); ++bin)
                for (const int shape : moved.shapes) {
                    if (!goes_in(moved, shape, bin, room)) continue;
                    const Places places = fill_costs(room, layout, piece, shape, bin, all_);
                    for (std::size_t i = 0; i < costs_.size(); ++i) {
                        if (costs_[i] != 0) continue;
                        const LaidMask laid = places.at(i, shape, bin);
                        if (const long long found = cost(piece, laid); found < least) {
                            least = found;
                            best = laid;
                        }
                    }
                }
            better = better || !(best == layout[piece]);
            layout[piece] = best;
        }
    }
}

}  // namespace snug

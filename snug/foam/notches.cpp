#include "snug/foam/notches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

constexpr double kRounding = 1e-9;
constexpr int kNoEnd = -1;

/// The columns seen with the notches opposite each other along one axis: `out` counts along it, `along` on
/// the other. One end is the side at -y or -z, the other the one opposite.
class Sides {
  public:
    Sides(const BlockMap& blocks, const DesignSpace& space, int axis, int level)
        : blocks_(blocks), space_(space), axis_(axis) {
        for (auto& ends : ends_) ends.assign(static_cast<std::size_t>(along_count()), kNoEnd);
        for (int along = 0; along < along_count(); ++along)
            for (int out = 0; out < out_count(); ++out) {
                const CutRun run = at(out, along);
                if (run.none() || run.first >= level) continue;
                int& first = ends_[0][static_cast<std::size_t>(along)];
                if (first == kNoEnd) first = out;
                ends_[1][static_cast<std::size_t>(along)] = out;
            }
    }

    [[nodiscard]] int out_count() const { return space_.blocks[axis_]; }
    [[nodiscard]] int along_count() const { return space_.blocks[3 - axis_]; }
    [[nodiscard]] double out_mm() const { return space_.block_mm[axis_]; }
    [[nodiscard]] double along_mm() const { return space_.block_mm[3 - axis_]; }
    [[nodiscard]] double along_face(int i) const { return space_.face(3 - axis_, i); }
    [[nodiscard]] std::size_t column(int out, int along) const {
        return axis_ == 1 ? blocks_.index(out, along) : blocks_.index(along, out);
    }
    [[nodiscard]] CutRun at(int out, int along) const { return blocks_[column(out, along)]; }

    /// Where the cavity ends towards a side, on one line of columns.
    [[nodiscard]] int end(int side, int along) const {
        return ends_[static_cast<std::size_t>(side)][static_cast<std::size_t>(along)];
    }

    /// How many lines the object has below the level.
    [[nodiscard]] int length() const {
        const auto& ends = ends_[0];
        return static_cast<int>(
            std::count_if(ends.begin(), ends.end(), [](int end) { return end != kNoEnd; }));
    }

    /// The middle of what is cut, along the object's side, mm.
    [[nodiscard]] double middle() const {
        double sum = 0, weight = 0;
        for (int along = 0; along < along_count(); ++along)
            for (int out = 0; out < out_count(); ++out) {
                const double cut = at(out, along).blocks();
                weight += cut;
                sum += cut * (along_face(along) + along_face(along + 1)) / 2;
            }
        return weight > 0 ? sum / weight : 0;
    }

  private:
    const BlockMap& blocks_;
    const DesignSpace& space_;
    int axis_;
    std::array<std::vector<int>, 2> ends_;  ///< at -, at +
};

/// In blocks.
struct NotchSize {
    int width, room;
    int wall;                   ///< kept between notch and case
    int first_line, lines_end;  ///< where it may lie along the object, for the walls there
};

/// Where a notch of `size` that begins at a line lies; none where the object is not beside most of it or the
/// room is lacking.
struct Span {
    int innermost = 0;  ///< the first column outside the object, or its nearest line's
    int outermost = 0;
};
std::optional<Span> span(const Sides& sides, int side, int first, const NotchSize& size, int* lacking) {
    int furthest = kNoEnd, nearest = kNoEnd, beside = 0;
    for (int along = first; along < first + size.width; ++along) {
        const int end = sides.end(side, along);
        if (end == kNoEnd) continue;
        ++beside;
        const auto outer = [&](int a, int b) { return side == 0 ? std::min(a, b) : std::max(a, b); };
        const auto inner = [&](int a, int b) { return side == 0 ? std::max(a, b) : std::min(a, b); };
        furthest = furthest == kNoEnd ? end : outer(furthest, end);
        nearest = nearest == kNoEnd ? end : inner(nearest, end);
    }
    if (2 * beside < size.width) return {};
    const int outermost = side == 0 ? furthest - size.room : furthest + size.room;
    const int left = side == 0 ? outermost : sides.out_count() - 1 - outermost;
    if (left < size.wall) {
        if (lacking) *lacking = size.wall - left;
        return {};
    }
    return Span{side == 0 ? nearest - 1 : nearest + 1, outermost};
}

/// The first line of the notch nearest to `at` that a side has room for, or of the pair.
struct Found {
    std::array<int, 2> first{};
    double off = 0;     ///< mm from where it should be
    double across = 0;  ///< mm of object between the two
};

/// The line at which a notch begins that has its middle where it was asked for, as nearly as the walls allow.
int line_at(const Sides& sides, double at_mm, const NotchSize& size) {
    const double first = (at_mm - sides.along_face(0)) / sides.along_mm() - size.width / 2.0;
    const double last = size.lines_end - size.width;
    return static_cast<int>(std::clamp<double>(std::floor(first + 0.5), size.first_line, last));
}

/// Whether what others cut leaves a notch down to `bottom` there: it takes no foam from under them.
bool free_of_others(const Sides& sides, const BlockMap& layer, int side, const Span& where, int first,
                    const NotchSize& size, int bottom) {
    const auto [low, high] = std::minmax(where.innermost, where.outermost);
    for (int along = first; along < first + size.width; ++along)
        for (int out = low; out <= high; ++out) {
            const int end = sides.end(side, along);
            if (end != kNoEnd && (side == 0 ? out >= end : out <= end)) continue;
            const CutRun cut = layer[sides.column(out, along)], own = sides.at(out, along);
            const bool others = own.none() || cut.first < own.first;
            if (!cut.none() && others && cut.first > bottom) return false;
        }
    return true;
}

/// The foam that notches are cut from, and down to where.
struct NotchFoam {
    const BlockMap& layer;
    int bottom;
};

std::optional<Found> find_pair(const Sides& sides, const NotchFoam& foam,
                               const std::array<NotchSize, 2>& sizes, const NotchOptions& options,
                               int* lacking) {
    const int width = sizes[0].width;
    if (width > sizes[0].lines_end - sizes[0].first_line) return {};
    const double middle = sides.middle();
    std::optional<Found> best;
    for (int first = sizes[0].first_line; first + width <= sizes[0].lines_end; ++first) {
        Found found{{first, first}, 0, 0};
        if (options.first_mm) found.first[0] = line_at(sides, *options.first_mm, sizes[0]);
        if (options.second_mm) found.first[1] = line_at(sides, *options.second_mm, sizes[1]);
        std::array<int, 2> lacks{};
        const auto low = span(sides, 0, found.first[0], sizes[0], &lacks[0]);
        const auto high = span(sides, 1, found.first[1], sizes[1], &lacks[1]);
        const int lack = std::max(lacks[0], lacks[1]);
        if (lack > 0 && (*lacking == 0 || lack < *lacking)) *lacking = lack;
        if (!low || !high) continue;
        if (!free_of_others(sides, foam.layer, 0, *low, found.first[0], sizes[0], foam.bottom) ||
            !free_of_others(sides, foam.layer, 1, *high, found.first[1], sizes[1], foam.bottom))
            continue;
        const double centre = (sides.along_face(first) + sides.along_face(first + width)) / 2;
        found.off = std::fabs(centre - middle);
        found.across = (high->innermost - low->innermost - 1) * sides.out_mm();
        if (!best || found.off < best->off - kRounding) best = found;
    }
    return best;
}

Notch carve(BlockMap& blocks, const DesignSpace& space, const Sides& sides, int axis, int side, int first,
            const NotchSize& size, int bottom, int level) {
    const Span where = *span(sides, side, first, size, nullptr);
    for (int along = first; along < first + size.width; ++along) {
        const int end = sides.end(side, along);
        const int inner = end == kNoEnd ? where.innermost : side == 0 ? end - 1 : end + 1;
        for (int out = std::min(inner, where.outermost); out <= std::max(inner, where.outermost); ++out) {
            CutRun& run = blocks[sides.column(out, along)];
            const int upper = run.none() ? level : std::max<int>(run.end, level);
            const int lower = run.none() ? bottom : std::min<int>(run.first, bottom);
            run = {static_cast<std::int16_t>(lower), static_cast<std::int16_t>(upper)};
        }
    }
    const int low = std::min(where.innermost, where.outermost);
    const int high = std::max(where.innermost, where.outermost) + 1;
    Notch notch;
    notch.side = static_cast<Side>(2 * axis + side);
    notch.at_mm = (sides.along_face(first) + sides.along_face(first + size.width)) / 2;
    notch.size_mm.x = (level - bottom) * space.block_mm.x;
    notch.size_mm[axis] = (high - low) * space.block_mm[axis];
    notch.size_mm[3 - axis] = size.width * sides.along_mm();
    notch.where.x = space.face(0, level);
    notch.where[axis] = (space.face(axis, low) + space.face(axis, high)) / 2;
    notch.where[3 - axis] = notch.at_mm;
    return notch;
}

std::array<NotchSize, 2> sizes_of(const Sides& sides, const DesignSpace& space, int axis,
                                  const NotchOptions& options, const Walls& wanted_mm) {
    const auto wall = [&](int side_axis, std::size_t side) {
        const double mm = wanted_mm[2 * static_cast<std::size_t>(side_axis) + side];
        return std::max(1, whole_blocks(mm, space.block_mm[side_axis]));
    };
    const int along = 3 - axis;
    const int width = whole_blocks(options.width_mm, sides.along_mm());
    const int room = whole_blocks(options.room_mm, sides.out_mm());
    const int end = sides.along_count() - wall(along, 1);
    return {NotchSize{width, room, wall(axis, 0), wall(along, 0), end},
            NotchSize{width, room, wall(axis, 1), wall(along, 0), end}};
}

/// `lacking`: blocks on each side that would do; 0 where they would not help.
Message no_room_for(const NotchOptions& options, int lacking) {
    const std::string width = number(options.width_mm, 1), depth = number(options.depth_mm, 1),
                      room = number(options.room_mm, 1);
    if (lacking == 0) return say("no_notches", {{"width_mm", width}, {"depth_mm", depth}, {"room_mm", room}});
    return say("no_notches/blocks",
               {{"width_mm", width}, {"depth_mm", depth}, {"room_mm", room}, {"blocks", lacking}});
}

/// The lowest level that is cut below the parting.
int pocket_floor(const BlockMap& own, int parting_level) {
    int floor = parting_level;
    for (const CutRun run : own)
        if (!run.none()) floor = std::min<int>(floor, run.first);
    return floor;
}

/// 1 (y) or 2 (z).
std::optional<int> chosen_axis(const NotchOptions& options) {
    if (!options.axis) return {};
    return *options.axis == NotchAxis::y ? 1 : 2;
}

}  // namespace

NotchPair cut_notches(BlockMap& layer, const NotchedObject& object, const DesignSpace& space,
                      NotchLevels levels, const NotchOptions& options, const Walls& wanted_mm) {
    const int parting_level = levels.parting;
    const int floor = levels.under > 0 ? 1 : std::max(1, whole_blocks(wanted_mm[kFloor], space.block_mm.x));
    int bottom = parting_level - whole_blocks(options.depth_mm, space.block_mm.x);
    if (!object.alone) bottom = std::max(bottom, pocket_floor(object.own, parting_level));
    if (bottom < levels.under + floor)
        return {{},
                say("no_notches/floor",
                    {{"depth_mm", number(options.depth_mm, 1)},
                     {"high_mm", number((parting_level - levels.under) * space.block_mm.x, 1)}})};
    std::optional<Found> best;
    int best_axis = 1, lacking = 0;
    std::array<NotchSize, 2> best_sizes{};
    for (const int axis : {1, 2}) {
        if (chosen_axis(options).value_or(axis) != axis) continue;
        const Sides sides(object.own, space, axis, parting_level);
        std::array<NotchSize, 2> sizes = sizes_of(sides, space, axis, options, wanted_mm);
        if (!object.alone)
            for (NotchSize& size : sizes) size.width = std::clamp(sides.length() * 2 / 3, 1, size.width);
        int lacks = 0;
        const auto found = find_pair(sides, {layer, bottom}, sizes, options, &lacks);
        if (!found && lacks > 0) lacking = std::max(lacking, lacks);
        if (!found || (best && best->across <= found->across)) continue;
        best = found;
        best_axis = axis;
        best_sizes = sizes;
    }
    if (!best) return {{}, no_room_for(options, lacking)};
    const Sides sides(object.own, space, best_axis, parting_level);
    std::array<Notch, 2> notches;
    for (std::size_t side = 0; side < 2; ++side)
        notches[side] = carve(layer, space, sides, best_axis, static_cast<int>(side), best->first[side],
                              best_sizes[side], bottom, parting_level);
    return {notches, {}};
}

}  // namespace snug

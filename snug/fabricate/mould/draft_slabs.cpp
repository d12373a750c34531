#include "snug/fabricate/mould/draft_slabs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "snug/polygon/lattice.h"
#include "snug/polygon/plan_outline.h"

namespace snug {
namespace {

constexpr int kMostGrowth = kStepsPerMm / 2;  // of a slab: what closes within one is filled from its top
constexpr int kLeastGap = kStepsPerMm / 20;   // that stays open in every cross-section
constexpr int kLeastBridge = kLeastGap;       // by which what meets in a point is joined on each side

/// The columns that reach a level.
PlanRegion columns_at(const SteppedField& field, int level) {
    PlanRegion region;
    for (int j = 0; j < field.heights.ny(); ++j) {
        std::vector<PlanSpan> spans;
        for (int k = 0; k < field.heights.nz(); ++k) {
            if (field.heights(j, k) < level) continue;
            const int begin = field.z[static_cast<std::size_t>(k)],
                      end = field.z[static_cast<std::size_t>(k) + 1];
            if (!spans.empty() && spans.back().end == begin)
                spans.back().end = end;
            else
                spans.push_back({begin, end});
        }
        region.append(field.y[static_cast<std::size_t>(j)], field.y[static_cast<std::size_t>(j) + 1],
                      std::move(spans));
    }
    return region;
}

PlanBox dilated(const PlanBox& box, int by) {
    return {{box.least.y - by, box.least.z - by}, {box.greatest.y + by, box.greatest.z + by}};
}

/// The region and every gap in it that no square of twice `reach` fits into (its closing).
PlanRegion closing(const PlanRegion& region, int reach, const PlanBox& box) {
    return intersection(eroded(dilated(region, reach), reach), region_of(box));
}

/// The region and all between it and the box's sides that is no wider than `reach`.
PlanRegion closing_to_sides(const PlanRegion& region, int reach, const PlanBox& box) {
    PlanRegion result;
    for (const PlanBand& band : region.bands) {
        std::vector<PlanSpan> spans = band.spans;
        if (spans.front().begin <= box.least.z + reach) spans.front().begin = box.least.z;
        if (spans.back().end >= box.greatest.z - reach) spans.back().end = box.greatest.z;
        result.append(band.begin, band.end, std::move(spans));
    }
    for (const auto& [side, end] :
         {std::pair{box.least.y, box.least.y + reach}, std::pair{box.greatest.y - reach, box.greatest.y}}) {
        // Whatever lies near the side spreads to it.
        const bool least = side == box.least.y;
        const PlanRegion near = intersection(result, region_of({{side, box.least.z}, {end, box.greatest.z}}));
        PlanRegion strips;
        for (const PlanBand& band : near.bands) {
            PlanRegion strip;
            strip.append(least ? side : band.begin, least ? band.end : end, band.spans);
            strips = union_of(strips, strip);
        }
        result = union_of(result, strips);
    }
    return result;
}

/// The direction from a corner that turns outward into the gap: both signs of y and z, or none.
PlanPoint outward(const std::vector<OutlineCorner>& corners, const OutlineCorner& corner) {
    const PlanPoint before = corners[corner.previous].at, after = corners[corner.next].at, at = corner.at;
    const std::int64_t turn =
        std::int64_t{at.y - before.y} * (after.z - at.z) - std::int64_t{at.z - before.z} * (after.y - at.y);
    if (turn <= 0) return {};
    const auto sign = [](int value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
    return {sign(at.y - before.y + at.y - after.y), sign(at.z - before.z + at.z - after.z)};
}

PlanRegion all_of(std::span<const PlanBox> boxes) {
    if (boxes.empty()) return {};
    if (boxes.size() == 1) return region_of(dilated(boxes[0], kLeastBridge));
    const std::size_t half = boxes.size() / 2;
    return union_of(all_of(boxes.first(half)), all_of(boxes.subspan(half)));
}

/// Adds the boxes, dilated, as far as they lie within `within`; false if there are none.
bool bridged(PlanRegion& region, const std::vector<PlanBox>& gaps, const PlanBox& within) {
    if (gaps.empty()) return false;
    region = union_of(region, intersection(all_of(gaps), region_of(within)));
    return true;
}

/// Joins what meets in a point only. True if there was something.
bool join_points(PlanRegion& region, const PlanBox& box) {
    std::vector<PlanBox> points;
    for (std::size_t i = 0; i + 1 < region.bands.size(); ++i) {
        const PlanBand &before = region.bands[i], &behind = region.bands[i + 1];
        if (before.end != behind.begin) continue;
        for (std::size_t a = 0, b = 0; a < before.spans.size() && b < behind.spans.size();) {
            const PlanSpan &one = before.spans[a], &other = behind.spans[b];
            for (const auto& [end, begin] :
                 {std::pair{one.end, other.begin}, std::pair{other.end, one.begin}})
                if (end == begin) points.push_back({{before.end, end}, {before.end, end}});
            ++(one.end < other.end ? a : b);
        }
    }
    return bridged(region, points, box);
}

/// Joins convex corners that will meet where they grow towards each other. True if there were some.
bool join_corners(PlanRegion& region, int reach, const PlanBox& box) {
    const std::vector<OutlineCorner> corners = outline_corners(region);
    std::vector<PlanBox> gaps;
    const auto first_from = [&](int y) {
        return std::lower_bound(corners.begin(), corners.end(), y,
                                [](const OutlineCorner& corner, int at) { return corner.at.y < at; });
    };
    for (const OutlineCorner& corner : corners) {
        const PlanPoint way = outward(corners, corner);
        if (way.y <= 0) continue;
        for (auto other = first_from(corner.at.y);
             other != corners.end() && other->at.y <= corner.at.y + reach; ++other) {
            const int apart = (other->at.z - corner.at.z) * way.z;
            if (apart < 0 || apart > reach || !(outward(corners, *other) == PlanPoint{-1, -way.z})) continue;
            gaps.push_back({{corner.at.y, std::min(corner.at.z, other->at.z)},
                            {other->at.y, std::max(corner.at.z, other->at.z)}});
        }
    }
    return bridged(region, gaps, box);
}

}  // namespace

std::int64_t Draft::moved_at(int height) const {
    return height >= from ? 0 : static_cast<std::int64_t>(std::floor(slope * (from - height) + 0.5));
}

PlanRegion bottom_of(const DraftSlab& slab, const PlanBox& box) {
    return intersection(dilated(slab.region, slab.growth), region_of(box));
}

std::vector<DraftSlab> draft_slabs(const SteppedField& field, int first, int last, const Draft& draft,
                                   const PlanRegion& above) {
    const PlanBox box = field.box();
    std::vector<DraftSlab> slabs;
    PlanRegion before = above;
    for (int level = last; level > first; --level) {
        const int top = field.levels[static_cast<std::size_t>(level)],
                  bottom = field.levels[static_cast<std::size_t>(level) - 1];
        const std::int64_t growth = draft.moved_at(bottom) - draft.moved_at(top);
        const auto pieces = static_cast<int>(growth / kMostGrowth + 1);
        PlanRegion region = union_of(before, columns_at(field, level));
        for (int piece = 0; piece < pieces; ++piece) {
            const auto at = [&](int i) {
                return top - static_cast<int>(std::int64_t{top - bottom} * i / pieces);
            };
            DraftSlab slab{at(piece), at(piece + 1), 0, std::move(region)};
            slab.growth = static_cast<int>(draft.moved_at(slab.bottom) - draft.moved_at(slab.top));
            const int reach = slab.growth + kLeastGap;
            do slab.region = closing_to_sides(closing(slab.region, reach, box), reach, box);
            while (join_points(slab.region, box) || join_corners(slab.region, 2 * reach, box));
            region = before = bottom_of(slab, box);
            if (!slab.region.empty()) slabs.push_back(std::move(slab));
        }
    }
    return slabs;
}

}  // namespace snug

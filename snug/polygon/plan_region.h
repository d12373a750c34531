#pragma once

#include <cstdint>
#include <vector>

// Areas in plan whose outlines run along y and z only, at any places rather than on block lines, and what can
// be done with them: the cross-sections of a solid whose upright faces lean.

namespace snug {

/// In steps of lattice.h.
struct PlanPoint {
    int y = 0, z = 0;
    friend bool operator==(const PlanPoint&, const PlanPoint&) = default;
};

struct PlanSpan {
    int begin = 0, end = 0;  ///< along z
    friend bool operator==(const PlanSpan&, const PlanSpan&) = default;
};

/// The same spans all the way from `begin` to `end` along y: ascending, apart from each other, not empty.
struct PlanBand {
    int begin = 0, end = 0;
    std::vector<PlanSpan> spans;
    friend bool operator==(const PlanBand&, const PlanBand&) = default;
};

struct PlanBox {
    PlanPoint least, greatest;
};

/// An area as bands in ascending order; none is empty and bands that touch differ.
struct PlanRegion {
    std::vector<PlanBand> bands;

    [[nodiscard]] bool empty() const { return bands.empty(); }
    /// What lies inside just beside `y`: behind it (towards +y) or before it.
    [[nodiscard]] const std::vector<PlanSpan>& spans_behind(int y) const;
    [[nodiscard]] const std::vector<PlanSpan>& spans_before(int y) const;
    /// Appends a band behind all others; joins it with the last one where nothing changes.
    void append(int begin, int end, std::vector<PlanSpan> spans);
    friend bool operator==(const PlanRegion&, const PlanRegion&) = default;
};

[[nodiscard]] PlanRegion region_of(const PlanBox& box);
[[nodiscard]] PlanRegion union_of(const PlanRegion& a, const PlanRegion& b);
[[nodiscard]] PlanRegion intersection(const PlanRegion& a, const PlanRegion& b);
[[nodiscard]] PlanRegion difference(const PlanRegion& a, const PlanRegion& b);

/// Every point within `by` of the region along y and along z: dilation by a square.
[[nodiscard]] PlanRegion dilated(const PlanRegion& region, int by);
/// Every point that has nothing but the region within `by` along y and along z: erosion by a square.
[[nodiscard]] PlanRegion eroded(const PlanRegion& region, int by);

/// Where spans of one list and not of the other lie.
[[nodiscard]] std::vector<PlanSpan> symmetric_difference(const std::vector<PlanSpan>& a,
                                                         const std::vector<PlanSpan>& b);

/// In steps squared.
[[nodiscard]] std::int64_t area_of(const PlanRegion& region);

/// The parts of a region that share more than points.
[[nodiscard]] std::vector<PlanRegion> connected_components(const PlanRegion& region);

/// Whether a point lies in the region or on its outline.
[[nodiscard]] bool contains(const PlanRegion& region, PlanPoint point);

}  // namespace snug

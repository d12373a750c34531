#include "snug/polygon/plan_outline.h"

#include <algorithm>
#include <numeric>

namespace snug {
namespace {

void link(std::vector<OutlineCorner>& corners, std::uint32_t from, std::uint32_t to) {
    corners[from].next = to;
    corners[to].previous = from;
}

/// Adds the corners on the line `y` and links those that the outline joins along it.
void add_line(int y, const std::vector<PlanSpan>& before, const std::vector<PlanSpan>& behind,
              std::vector<OutlineCorner>& corners, std::vector<char>& leaves_along_y) {
    for (const PlanSpan& side : symmetric_difference(before, behind)) {
        const auto first = static_cast<std::uint32_t>(corners.size()), second = first + 1;
        corners.push_back({{y, side.begin}});
        corners.push_back({{y, side.end}});
        const bool area_before = std::any_of(before.begin(), before.end(), [&](const PlanSpan& span) {
            return span.begin <= side.begin && side.begin < span.end;
        });
        link(corners, area_before ? first : second, area_before ? second : first);
        leaves_along_y.push_back(area_before ? 0 : 1);
        leaves_along_y.push_back(area_before ? 1 : 0);
    }
}

}  // namespace

std::vector<OutlineCorner> outline_corners(const PlanRegion& region) {
    std::vector<OutlineCorner> corners;
    std::vector<char> leaves_along_y;
    static const std::vector<PlanSpan> kNone;
    const auto& bands = region.bands;
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const bool joined = i > 0 && bands[i - 1].end == bands[i].begin;
        add_line(bands[i].begin, joined ? bands[i - 1].spans : kNone, bands[i].spans, corners,
                 leaves_along_y);
        if (i + 1 == bands.size() || bands[i + 1].begin != bands[i].end)
            add_line(bands[i].end, bands[i].spans, kNone, corners, leaves_along_y);
    }
    std::vector<std::uint32_t> by_z(corners.size());
    std::iota(by_z.begin(), by_z.end(), 0u);
    std::stable_sort(by_z.begin(), by_z.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return corners[a].at.z < corners[b].at.z; });
    for (std::size_t i = 0; i + 1 < by_z.size(); i += 2) {
        const bool forward = leaves_along_y[by_z[i]] != 0;
        link(corners, forward ? by_z[i] : by_z[i + 1], forward ? by_z[i + 1] : by_z[i]);
    }
    return corners;
}

std::vector<PlanPoint> offset_corners(const std::vector<OutlineCorner>& corners, int by, const PlanBox& box) {
    std::vector<PlanPoint> grown;
    grown.reserve(corners.size());
    for (const OutlineCorner& corner : corners) {
        PlanPoint at = corner.at;
        for (const auto& [from, to] :
             {std::pair{corners[corner.previous].at, at}, std::pair{at, corners[corner.next].at}}) {
            const bool along_z = from.y == to.y;
            if (along_z && from.y != box.least.y && from.y != box.greatest.y)
                at.y = corner.at.y + (to.z > from.z ? by : -by);
            if (!along_z && from.z != box.least.z && from.z != box.greatest.z)
                at.z = corner.at.z + (to.y > from.y ? -by : by);
        }
        grown.push_back(at);
    }
    return grown;
}

}  // namespace snug

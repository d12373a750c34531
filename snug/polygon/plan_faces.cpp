#include "snug/polygon/plan_faces.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "snug/polygon/row_triangulator.h"

namespace snug {
namespace {

/// The vertex as the four cells around it see it; appended where any of them lies in the region.
void add_line_corner(const PlanVertex& there, const std::vector<PlanSpan>& before,
                     const std::vector<PlanSpan>& behind, std::vector<LineCorner>& corners) {
    const int z = there.at.z;
    const auto beside = [&](const std::vector<PlanSpan>& spans, bool left) {
        const auto span = std::lower_bound(spans.begin(), spans.end(), left ? z : z + 1,
                                           [](const PlanSpan& s, int at) { return s.end < at; });
        return span != spans.end() && (left ? span->begin < z : span->begin <= z) ? there.vertex : kNoVertex;
    };
    const LineCorner corner{z, beside(before, true), beside(before, false), beside(behind, true),
                            beside(behind, false)};
    const std::array<std::uint32_t, 4> around{corner.previous_left, corner.previous_right, corner.next_left,
                                              corner.next_right};
    if (std::any_of(around.begin(), around.end(), [](std::uint32_t v) { return v != kNoVertex; }))
        corners.push_back(corner);
}

}  // namespace

void triangulate(const PlanRegion& region, std::span<const PlanVertex> vertices, int face,
                 std::vector<Triangle>& triangles) {
    RowTriangulator triangulator(triangles);
    for (std::size_t at = 0; at < vertices.size();) {
        const int y = vertices[at].at.y;
        const auto &before = region.spans_before(y), &behind = region.spans_behind(y);
        std::vector<LineCorner> corners;
        for (; at < vertices.size() && vertices[at].at.y == y; ++at)
            add_line_corner(vertices[at], before, behind, corners);
        std::vector<FaceRun> runs;
        for (const PlanSpan& span : behind) runs.push_back({span.begin, span.end, face});
        if (!corners.empty()) triangulator.step(y, corners, runs);
    }
}

}  // namespace snug

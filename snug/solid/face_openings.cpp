#include "snug/solid/face_openings.h"

#include <algorithm>

namespace snug {
namespace {

/// The runs less the openings that the strip after `line` crosses.
std::vector<FaceRun> open_runs(std::span<const FaceRun> runs, std::span<const FaceOpening> openings,
                               int line) {
    std::vector<FaceRun> open(runs.begin(), runs.end());
    for (const FaceOpening& opening : openings) {
        if (line < opening.row_begin || line >= opening.row_end) continue;
        for (std::size_t i = 0; i < open.size(); ++i) {
            const FaceRun whole = open[i];
            if (opening.position_begin <= whole.begin || opening.position_end >= whole.end) continue;
            open[i].end = opening.position_begin;
            open.insert(open.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                        {opening.position_end, whole.end, whole.face});
            break;
        }
    }
    return open;
}

void add_opening_corners(std::span<const FaceOpening> openings, int line, std::vector<LineCorner>& corners) {
    for (const FaceOpening& opening : openings) {
        const std::uint32_t first = opening.first_vertex;
        if (line == opening.row_begin) {
            corners.push_back({opening.position_begin, first, first, first, kNoVertex});
            corners.push_back({opening.position_end, first + 1, first + 1, kNoVertex, first + 1});
        } else if (line == opening.row_end) {
            corners.push_back({opening.position_begin, first + 2, kNoVertex, first + 2, first + 2});
            corners.push_back({opening.position_end, kNoVertex, first + 3, first + 3, first + 3});
        }
    }
    std::sort(corners.begin(), corners.end(),
              [](const LineCorner& a, const LineCorner& b) { return a.position < b.position; });
}

}  // namespace

void step_row(RowTriangulator& triangulator, int first, int steps, std::vector<LineCorner>& corners,
              std::span<const FaceRun> runs, std::span<const FaceOpening> openings) {
    if (openings.empty()) {
        triangulator.step(first, corners, runs);
        return;
    }
    std::vector<int> lines{first};
    for (const FaceOpening& opening : openings)
        for (const int line : {opening.row_begin, opening.row_end})
            if (line > first && line < first + steps) lines.push_back(line);
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    for (const int line : lines) {
        add_opening_corners(openings, line, corners);
        triangulator.step(line, corners, open_runs(runs, openings, line));
        corners.clear();
    }
}

}  // namespace snug

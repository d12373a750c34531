#include "snug/fabricate/sheets/liner_slits.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "snug/polygon/lattice.h"
#include "snug/polygon/plan_region.h"

namespace snug {
namespace {

constexpr double kBesideSlit = 5;     // mm of foam between a slit and the sheet's edge
constexpr double kShortestSlit = 15;  // mm: less holds no liner

using Line = std::vector<Vec2d>;

/// Cells that `holds` (row, column), in steps from the half's corner: rows along y, columns along z.
template <class Holds>
PlanRegion region_of_cells(const SheetStack& stack, Holds holds) {
    PlanRegion region;
    const auto row_line = [&](int row) { return static_cast<int>(in_steps(row * stack.cell_mm.y)); };
    const auto column_line = [&](int column) { return static_cast<int>(in_steps(column * stack.cell_mm.x)); };
    for (int row = 0; row < stack.rows(); ++row) {
        std::vector<PlanSpan> spans;
        for (int column = 0; column < stack.columns(); ++column) {
            if (!holds(row, column)) continue;
            if (!spans.empty() && spans.back().end == column_line(column))
                spans.back().end = column_line(column + 1);
            else
                spans.push_back({column_line(column), column_line(column + 1)});
        }
        if (!spans.empty()) region.append(row_line(row), row_line(row + 1), std::move(spans));
    }
    return region;
}

std::vector<PlanSpan> common(const std::vector<PlanSpan>& a, const std::vector<PlanSpan>& b) {
    std::vector<PlanSpan> both;
    for (const PlanSpan& one : a)
        for (const PlanSpan& other : b)
            if (const PlanSpan span{std::max(one.begin, other.begin), std::min(one.end, other.end)};
                span.begin < span.end)
                both.push_back(span);
    return both;
}

struct Edge {
    PlanPoint from, to;
};

/// The outline of `area` as far as it runs inside `within`.
std::vector<Edge> outline_within(const PlanRegion& area, const PlanRegion& within) {
    std::vector<Edge> edges;
    const auto along_row = [&](int y) {
        const auto free = common(within.spans_before(y), within.spans_behind(y));
        const auto outline = symmetric_difference(area.spans_before(y), area.spans_behind(y));
        for (const PlanSpan& span : common(outline, free)) edges.push_back({{y, span.begin}, {y, span.end}});
    };
    for (const PlanBand& band : area.bands) {
        along_row(band.begin);
        if (area.spans_behind(band.end).empty()) along_row(band.end);
        for (const PlanBand& free : within.bands) {
            const int begin = std::max(band.begin, free.begin), end = std::min(band.end, free.end);
            if (begin >= end) continue;
            for (const PlanSpan& span : band.spans)
                for (const int z : {span.begin, span.end})
                    if (std::any_of(free.spans.begin(), free.spans.end(),
                                    [&](const PlanSpan& s) { return s.begin < z && z < s.end; }))
                        edges.push_back({{begin, z}, {end, z}});
        }
    }
    return edges;
}

/// Edges that meet, two in a point, joined from end to end.
class Chains {
  public:
    explicit Chains(const std::vector<Edge>& edges) : edges_(edges), used_(edges.size(), 0) {
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (const PlanPoint p : {edges[i].from, edges[i].to}) at_[key(p)].push_back(i);
    }

    /// Open ones first: what is left are loops.
    std::vector<Line> join() {
        for (const bool ends : {true, false})
            for (std::size_t i = 0; i < edges_.size(); ++i)
                for (const PlanPoint p : {edges_[i].from, edges_[i].to})
                    if (!used_[i] && (!ends || at_[key(p)].size() != 2)) follow(p, i);
        return std::move(lines_);
    }

  private:
    static std::pair<int, int> key(PlanPoint p) { return {p.y, p.z}; }
    static Vec2d mm(PlanPoint p) { return {in_mm(p.z), in_mm(p.y)}; }

    void follow(PlanPoint from, std::size_t edge) {
        Line line{mm(from)};
        while (true) {
            used_[edge] = 1;
            from = edges_[edge].from == from ? edges_[edge].to : edges_[edge].from;
            add(line, mm(from));
            const auto& meeting = at_[key(from)];
            const auto next =
                std::find_if(meeting.begin(), meeting.end(), [&](std::size_t e) { return !used_[e]; });
            if (meeting.size() != 2 || next == meeting.end()) break;
            edge = *next;
        }
        lines_.push_back(std::move(line));
    }

    /// Corners alone.
    static void add(Line& line, Vec2d p) {
        if (line.size() > 1) {
            const Vec2d a = line[line.size() - 2], b = line.back();
            if ((a.x == b.x && b.x == p.x) || (a.y == b.y && b.y == p.y)) line.pop_back();
        }
        line.push_back(p);
    }

    const std::vector<Edge>& edges_;
    std::vector<char> used_;
    std::map<std::pair<int, int>, std::vector<std::size_t>> at_;
    std::vector<Line> lines_;
};

double length_of(const Line& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += length(line[i] - line[i - 1]);
    return sum;
}

}  // namespace

std::vector<Line> liner_slits(const SheetStack& stack, const SheetPiece& piece, double away_mm) {
    if (piece.sheet != stack.count - 1 || away_mm <= 0) return {};
    const PlanRegion foam = region_of_cells(stack, [&](int row, int column) {
        return piece.mask.contains(column - piece.column, row - piece.row);
    });
    const PlanRegion cavities = region_of_cells(stack, [&](int row, int column) {
        return stack.kept(row, column) > stack.missing(row, column) && stack.kept(row, column) < stack.count;
    });
    const PlanRegion around = dilated(cavities, static_cast<int>(in_steps(away_mm)));
    const PlanRegion room = eroded(foam, static_cast<int>(in_steps(kBesideSlit)));
    const std::vector<Edge> edges = outline_within(around, room);
    std::vector<Line> slits;
    const Vec2d corner{piece.column * stack.cell_mm.x, piece.row * stack.cell_mm.y};
    for (Line& line : Chains(edges).join()) {
        if (length_of(line) < kShortestSlit) continue;
        for (Vec2d& p : line) p = p - corner;
        slits.push_back(std::move(line));
    }
    return slits;
}

}  // namespace snug

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
    for (std::size_t i = 0, k = 0; i < a.size() && k < b.size(); ++(a[i].end < b[k].end ? i : k))
        if (const PlanSpan span{std::max(a[i].begin, b[k].begin), std::min(a[i].end, b[k].end)};
            span.begin < span.end)
            both.push_back(span);
    return both;
}

/// Whether a place lies inside one of the spans, on none of their ends.
bool inside(const std::vector<PlanSpan>& spans, int z) {
    const auto after = std::upper_bound(spans.begin(), spans.end(), z,
                                        [](int at, const PlanSpan& span) { return at < span.end; });
    return after != spans.end() && after->begin < z;
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
    auto first = within.bands.begin();  // the first that may reach into the band
    for (const PlanBand& band : area.bands) {
        along_row(band.begin);
        if (area.spans_behind(band.end).empty()) along_row(band.end);
        while (first != within.bands.end() && first->end <= band.begin) ++first;
        for (auto free = first; free != within.bands.end() && free->begin < band.end; ++free)
            for (const PlanSpan& span : band.spans)
                for (const int z : {span.begin, span.end})
                    if (inside(free->spans, z))
                        edges.push_back(
                            {{std::max(band.begin, free->begin), z}, {std::min(band.end, free->end), z}});
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

std::vector<Line> liner_slits(const SheetStack& stack, double away_mm) {
    if (away_mm <= 0) return {};
    const int top = stack.count - 1;
    const PlanRegion foam =
        region_of_cells(stack, [&](int row, int column) { return stack.has(row, column, top); });
    const PlanRegion cavities = region_of_cells(stack, [&](int row, int column) {
        return stack.kept(row, column) > stack.missing(row, column) && stack.kept(row, column) < stack.count;
    });
    const PlanRegion around = dilated(cavities, static_cast<int>(in_steps(away_mm)));
    const PlanRegion room = eroded(foam, static_cast<int>(in_steps(kBesideSlit)));
    const std::vector<Edge> edges = outline_within(around, room);
    std::vector<Line> slits;
    for (Line& line : Chains(edges).join())
        if (length_of(line) >= kShortestSlit) slits.push_back(std::move(line));
    return slits;
}

}  // namespace snug

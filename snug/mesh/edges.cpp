#include "snug/mesh/edges.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <utility>

namespace snug {
namespace {

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

/// A triangle's use of the edge between `smaller` and a larger vertex, as one number that sorts by the
/// larger.
std::uint64_t edge_use(std::uint32_t larger, bool upward) {
    return static_cast<std::uint64_t>(larger) << 1 | (upward ? 1u : 0u);
}

/// Calls visit(from, to) for the three edges of each triangle that has three different welded corners.
template <class Visit>
void for_each_edge(const Mesh& mesh, const std::vector<std::uint32_t>& weld, Visit visit) {
    for (const Triangle& t : mesh.triangles) {
        const std::uint32_t a = weld[t[0]], b = weld[t[1]], c = weld[t[2]];
        if (a == b || b == c || c == a) continue;
        visit(a, b);
        visit(b, c);
        visit(c, a);
    }
}

/// Lists of edges, one for each vertex, in one array: those of vertex v stand from start[v] to start[v + 1].
template <class Value>
struct EdgesOfVertices {
    std::vector<std::size_t> start;
    std::vector<Value> edges;
};

/// The uses of every edge, filed at its smaller end.
EdgesOfVertices<std::uint64_t> uses_of_edges(const Mesh& mesh, const std::vector<std::uint32_t>& weld) {
    EdgesOfVertices<std::uint64_t> uses;
    uses.start.assign(weld.size() + 2, 0);
    for_each_edge(mesh, weld,
                  [&](std::uint32_t from, std::uint32_t to) { ++uses.start[std::min(from, to) + 2]; });
    for (std::size_t v = 2; v < uses.start.size(); ++v) uses.start[v] += uses.start[v - 1];
    uses.edges.resize(uses.start.back());
    for_each_edge(mesh, weld, [&](std::uint32_t from, std::uint32_t to) {
        uses.edges[uses.start[std::min(from, to) + 1]++] = edge_use(std::max(from, to), from < to);
    });
    return uses;
}

/// Walks along unused boundary edges and cuts a loop off whenever it comes back to a vertex of its path.
class LoopTracer {
  public:
    explicit LoopTracer(const std::vector<BoundaryEdge>& boundary)
        : boundary_(boundary), used_(boundary.size()) {
        std::uint32_t last = 0;
        for (const BoundaryEdge& edge : boundary) last = std::max({last, edge.from, edge.to});
        const std::size_t vertices = boundary.empty() ? 0 : std::size_t{last} + 1;
        at_.start.assign(vertices + 2, 0);
        for (const BoundaryEdge& edge : boundary) {
            ++at_.start[edge.from + 2];
            ++at_.start[edge.to + 2];
        }
        for (std::size_t v = 2; v < at_.start.size(); ++v) at_.start[v] += at_.start[v - 1];
        at_.edges.resize(2 * boundary.size());
        // Edges that leave a vertex stand before those that reach it, so that a loop runs as its triangles
        // do.
        for (std::size_t e = 0; e < boundary.size(); ++e) at_.edges[at_.start[boundary[e].from + 1]++] = e;
        for (std::size_t e = 0; e < boundary.size(); ++e) at_.edges[at_.start[boundary[e].to + 1]++] = e;
        next_.assign(at_.start.begin(), at_.start.end());
        place_on_path_.assign(vertices, kNowhere);
    }

    std::vector<std::vector<std::uint32_t>> loops() {
        for (std::size_t e = 0; e < boundary_.size(); ++e)
            if (!used_[e]) walk_from(boundary_[e].from);
        return std::move(loops_);
    }

  private:
    void walk_from(std::uint32_t start) {
        step_onto(start, false);
        for (std::size_t e = unused_edge_at(start); e != kNowhere; e = unused_edge_at(path_.back())) {
            used_[e] = true;
            const bool with_edge = boundary_[e].from == path_.back();
            const std::uint32_t next = with_edge ? boundary_[e].to : boundary_[e].from;
            if (place_on_path_[next] == kNowhere)
                step_onto(next, with_edge);
            else
                cut_off_loop(place_on_path_[next], with_edge);
        }
        assert(path_.size() ==
               1);  // an even number of edges at every vertex: a walk can end at its start only
        place_on_path_[start] = kNowhere;
        path_.clear();
        along_.clear();
    }

    std::size_t unused_edge_at(std::uint32_t vertex) {
        for (std::size_t& next = next_[vertex]; next < at_.start[vertex + 1]; ++next)
            if (!used_[at_.edges[next]]) return at_.edges[next];
        return kNowhere;
    }

    void step_onto(std::uint32_t vertex, bool with_edge) {
        place_on_path_[vertex] = path_.size();
        path_.push_back(vertex);
        along_.push_back(with_edge ? 1 : -1);
    }

    /// The path from its vertex `first` to its end is a loop; `first` stays on the path.
    void cut_off_loop(std::size_t first, bool last_with_edge) {
        std::vector<std::uint32_t> loop(path_.begin() + static_cast<std::ptrdiff_t>(first), path_.end());
        long long with_edges = last_with_edge ? 1 : -1;
        for (std::size_t i = first + 1; i < path_.size(); ++i) {
            with_edges += along_[i];
            place_on_path_[path_[i]] = kNowhere;
        }
        if (with_edges < 0) std::reverse(loop.begin() + 1, loop.end());
        path_.resize(first + 1);
        along_.resize(first + 1);
        loops_.push_back(std::move(loop));
    }

    const std::vector<BoundaryEdge>& boundary_;
    EdgesOfVertices<std::size_t> at_;  // indices into boundary_
    std::vector<std::size_t> next_;    // for each vertex: where in at_ to look for its next unused edge
    std::vector<bool> used_;           // for each edge
    std::vector<std::size_t> place_on_path_;  // for each vertex
    std::vector<std::uint32_t> path_;
    std::vector<int>
        along_;  // for each vertex of the path: 1 where the edge that led to it runs that way, or -1
    std::vector<std::vector<std::uint32_t>> loops_;
};

}  // namespace

EdgeCensus census_of_edges(const Mesh& mesh, const std::vector<std::uint32_t>& weld) {
    EdgesOfVertices<std::uint64_t> uses = uses_of_edges(mesh, weld);
    EdgeCensus census;
    census.watertight = !uses.edges.empty();
    for (std::uint32_t smaller = 0; smaller < weld.size(); ++smaller) {
        const auto first = uses.edges.begin() + static_cast<std::ptrdiff_t>(uses.start[smaller]);
        const auto end = uses.edges.begin() + static_cast<std::ptrdiff_t>(uses.start[smaller + 1]);
        std::sort(first, end);
        for (auto use = first; use != end;) {
            const auto larger = static_cast<std::uint32_t>(*use >> 1);
            std::size_t upward = 0, downward = 0;
            for (; use != end && *use >> 1 == larger; ++use) ++((*use & 1) != 0 ? upward : downward);
            if (upward != downward) census.watertight = false;
            if ((upward + downward) % 2 == 0) continue;
            census.boundary.push_back(upward > downward ? BoundaryEdge{smaller, larger}
                                                        : BoundaryEdge{larger, smaller});
        }
    }
    return census;
}

std::vector<std::vector<std::uint32_t>> boundary_loops(const std::vector<BoundaryEdge>& boundary) {
    return LoopTracer(boundary).loops();
}

}  // namespace snug

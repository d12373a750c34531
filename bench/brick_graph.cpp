#include "bench/brick_graph.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace snug::bench {
namespace {

/// The bricks that each is tied to.
std::vector<std::vector<int>> neighbours_of(const BrickBuild& build) {
    std::vector<std::vector<int>> neighbours(build.bricks.size());
    for (const BrickJoint& joint : brick_joints(build)) {
        neighbours[joint.lower].push_back(joint.upper);
        neighbours[joint.upper].push_back(joint.lower);
    }
    return neighbours;
}

/// One walk through the graph in depth, without recursion since builds are deep (Hopcroft and Tarjan 1973).
struct Walk {
    int pieces = 0, articulations = 0;

    explicit Walk(const std::vector<std::vector<int>>& neighbours) {
        const std::size_t count = neighbours.size();
        std::vector<int> entered(count), lowest(count), parent(count, -1);
        std::vector<std::size_t> next(count);
        std::vector<char> cuts(count);
        int time = 0;
        for (std::size_t root = 0; root < count; ++root) {
            if (entered[root]) continue;
            ++pieces;
            int branches = 0;
            std::vector<int> path{static_cast<int>(root)};
            entered[root] = lowest[root] = ++time;
            while (!path.empty()) {
                const int node = path.back();
                if (next[node] < neighbours[node].size()) {
                    const int other = neighbours[node][next[node]++];
                    if (entered[other]) {
                        lowest[node] = std::min(lowest[node], entered[other]);
                        continue;
                    }
                    parent[other] = node;
                    entered[other] = lowest[other] = ++time;
                    path.push_back(other);
                    continue;
                }
                path.pop_back();
                const int above = parent[node];
                if (above < 0) continue;
                lowest[above] = std::min(lowest[above], lowest[node]);
                if (above == static_cast<int>(root))
                    ++branches;
                else if (lowest[node] >= entered[above])
                    cuts[above] = 1;
            }
            if (branches > 1) cuts[root] = 1;
        }
        articulations = static_cast<int>(std::count(cuts.begin(), cuts.end(), 1));
    }
};

}  // namespace

int piece_count(const BrickBuild& build) {
    return Walk(neighbours_of(build)).pieces;
}

int articulation_bricks(const BrickBuild& build) {
    return Walk(neighbours_of(build)).articulations;
}

}  // namespace snug::bench

#include "bench/contest.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <tbb/global_control.h>

#include "snug/foam/block_map.h"
#include "snug/foam/depth_map.h"
#include "snug/foam/foam_pair.h"
#include "snug/foam/parting.h"
#include "snug/foam/placement.h"

#include "bench/measure_times.h"

namespace snug::bench {
namespace {

constexpr std::size_t kTurn = 5;  ///< rotations
const Reach kReach = reach(0, false);

struct Foams {
    BlockMap blocks;
    FoamPair pair;
};

Foams foams_of(const DepthMap& depths, const DesignSpace& space, const Placement& placement) {
    Foams foams;
    foams.blocks = block_map(depths, space, kReach);
    foams.pair = split(foams.blocks, space, auto_parting_level(foams.blocks, space, placement.bounds));
    return foams;
}

/// Every column and every block that must be cut, and what samples make of them.
struct Sampled {
    long long columns = 0, equal = 0;
    long long blocks = 0, missed = 0, added = 0;

    void compare(const BlockMap& sampled, const BlockMap& exact) {
        for (std::size_t i = 0; i < exact.size(); ++i) {
            if (exact[i].none() && sampled[i].none()) continue;
            const CutRun both{std::max(exact[i].first, sampled[i].first),
                              std::min(exact[i].end, sampled[i].end)};
            columns += 1;
            equal += exact[i] == sampled[i];
            blocks += exact[i].blocks();
            missed += exact[i].blocks() - both.blocks();
            added += sampled[i].blocks() - both.blocks();
        }
    }
};

/// The times of every method, and what they made of the rotations of this turn.
struct Turns {
    const Contest& contest;
    const DesignSpace& space;
    std::vector<double> paper, loop, snug, threads;
    Sampled sampled;

    void take(const std::vector<Vec3d>& turn, std::size_t paper_rotations) {
        std::vector<BlockMap> by_paper, exact;
        for (std::size_t i = 0; i < paper_rotations; ++i) by_paper.push_back(take_paper(turn[i]));
        {
            const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
            for (const Vec3d& rotation : turn)
                exact.push_back(timed(loop, [&] { return placed(contest.mesh, rotation); }));
            for (std::size_t i = 0; i < turn.size(); ++i) take_snug(snug, turn[i], exact[i]);
        }
        for (std::size_t i = 0; i < turn.size(); ++i) take_snug(threads, turn[i], exact[i]);
        for (std::size_t i = 0; i < by_paper.size(); ++i) sampled.compare(by_paper[i], exact[i]);
    }

  private:
    template <class Work>
    static BlockMap timed(std::vector<double>& times, const Work& work) {
        Foams foams;
        times.push_back(time_of([&] { foams = work(); }));
        return foams.blocks;
    }

    /// `Surface`: a mesh (the plain loop) or a prepared surface (Snug).
    template <class Surface>
    [[nodiscard]] Foams placed(const Surface& surface, Vec3d rotation) const {
        const Placement placement = place(surface, rotation, {});
        return foams_of(depth_map(surface, placement, space, kReach), space, placement);
    }

    /// Without the time to place the object, which the paper does not describe.
    BlockMap take_paper(Vec3d rotation) {
        const Placement placement = place(contest.prepared, rotation, {});
        return timed(paper,
                     [&] { return foams_of(contest.paper->depth_map(placement, space), space, placement); });
    }

    void take_snug(std::vector<double>& times, Vec3d rotation, const BlockMap& exact) const {
        if (timed(times, [&] { return placed(contest.prepared, rotation); }) == exact) return;
        std::fprintf(stderr, "the prepared surface and the plain loop cut different blocks\n");
        std::exit(1);
    }
};

}  // namespace

DesignSpace space_of(int columns, int layers) {
    const double side = kDiagonal * 1.1;
    return {{layers, columns, columns}, {side / layers, side / columns, side / columns}};
}

nlohmann::json Contest::run(const DesignSpace& space, int paper_rotations) const {
    Turns turns{*this, space, {}, {}, {}, {}, {}};
    const std::vector<Vec3d> all = rotations(kRotations);
    const std::size_t of_paper =
        paper == nullptr ? 0 : static_cast<std::size_t>(paper_rotations) * kTurn / all.size();
    for (std::size_t first = 0; first < all.size(); first += kTurn) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
        turns.take({begin, begin + kTurn}, of_paper);
    }
    nlohmann::json result{{"blocks", {space.blocks.x, space.blocks.y, space.blocks.z}},
                          {"loop", summary(turns.loop)},
                          {"snug", summary(turns.snug)},
                          {"threads", summary(turns.threads)}};
    if (of_paper == 0) return result;
    const auto share = [](long long part, long long whole) {
        return static_cast<double>(part) / static_cast<double>(whole);
    };
    const Sampled& sampled = turns.sampled;
    result["paper"] = summary(turns.paper);
    result["paper_equal"] = share(sampled.equal, sampled.columns);
    result["paper_missed"] = share(sampled.missed, sampled.blocks);
    result["paper_added"] = share(sampled.added, sampled.blocks);
    return result;
}

}  // namespace snug::bench

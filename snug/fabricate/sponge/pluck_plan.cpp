#include "snug/fabricate/sponge/pluck_plan.h"

#include <algorithm>

namespace snug {
namespace {

/// What the levels of a half, from the case's side, lose; and where a level loses other columns than the one
/// below it.
class LevelCounts {
  public:
    explicit LevelCounts(int layers)
        : plucked_(static_cast<std::size_t>(layers) + 1), cut_off_(plucked_), changes_(plucked_) {}

    void pluck(Run run) { add(run, plucked_); }
    void cut_off(Run run) { add(run, cut_off_); }

    [[nodiscard]] std::vector<LayerRun> layer_runs() const {
        const int layers = static_cast<int>(changes_.size()) - 1;
        std::vector<LayerRun> runs;
        LayerRun all;
        for (int level = 0; level < layers; ++level) {
            const auto i = static_cast<std::size_t>(level);
            all.plucked += plucked_[i];
            all.cut_off += cut_off_[i];
            all.first = all.last = layers - level;
            if (level > 0 && changes_[i] == 0)
                runs.back().first = all.first;
            else
                runs.push_back(all);
        }
        std::reverse(runs.begin(), runs.end());
        return runs;
    }

  private:
    void add(Run run, std::vector<long long>& counts) {
        if (run.none()) return;
        const auto first = static_cast<std::size_t>(run.first), end = static_cast<std::size_t>(run.end);
        ++counts[first];
        --counts[end];
        ++changes_[first];
        ++changes_[end];
    }

    std::vector<long long> plucked_, cut_off_;  ///< what begins at a level less what ends there
    std::vector<long long> changes_;
};

Run moved_down(Run run, int by) {
    return {static_cast<std::int16_t>(run.first - by), static_cast<std::int16_t>(run.end - by)};
}

}  // namespace

int PluckPlan::deepest() const {
    return removed.size() == 0 ? 0 : *std::max_element(removed.begin(), removed.end());
}

PluckPlan pluck_plan(const FoamDesign& design, Piece piece) {
    const int nx = design.space.blocks.x;
    const auto [kept, under] = design.seen(piece);
    PluckPlan plan;
    plan.piece = piece;
    plan.half = piece.half();
    for (const Run run : kept) plan.layers = std::max<int>(plan.layers, run.end);
    plan.removed = plan.behind = Grid<std::uint16_t>(kept.ny(), kept.nz());
    plan.exists = Grid<Run>(kept.ny(), kept.nz());
    plan.row_mm = design.space.block_mm.y;
    plan.column_mm = design.space.block_mm.z;
    plan.layer_mm = design.space.block_mm.x;
    const Run all{0, static_cast<std::int16_t>(plan.layers)};
    LevelCounts counts(plan.layers);
    for (int row = 0; row < kept.ny(); ++row)
        for (int column = 0; column < kept.nz(); ++column) {
            const std::size_t at = kept.index(plan.row_from_back(row), column);
            const Run there = moved_down(design.available[at], under);
            Run exists = (plan.half == Half::lower ? there : from_other_end(there, nx)).common(all);
            if (exists.none()) exists = {};
            const int behind = piece.middle() && !kept[at].none() ? kept[at].first - exists.first : 0;
            const int removed = exists.blocks() - kept[at].blocks() - behind;
            plan.exists(row, column) = exists;
            plan.removed(row, column) = static_cast<std::uint16_t>(removed);
            plan.behind(row, column) = static_cast<std::uint16_t>(behind);
            plan.plucked += removed + behind;
            plan.cut_off += plan.layers - exists.blocks();
            counts.pluck({static_cast<std::int16_t>(exists.end - removed), exists.end});
            counts.pluck({exists.first, static_cast<std::int16_t>(exists.first + behind)});
            counts.cut_off({0, exists.first});
            counts.cut_off({exists.end, all.end});
        }
    plan.runs = counts.layer_runs();
    return plan;
}

PluckPlan seen_from_below(const PluckPlan& plan) {
    PluckPlan turned = plan;
    turned.half = Half::lid;
    for (int row = 0; row < plan.removed.ny(); ++row)
        for (int column = 0; column < plan.removed.nz(); ++column) {
            const int other = plan.removed.ny() - 1 - row;
            const Run exists = plan.exists(row, column);
            const bool through = plan.removed(row, column) == exists.blocks();
            turned.exists(other, column) = from_other_end(exists, plan.layers);
            turned.removed(other, column) = through ? plan.removed(row, column) : plan.behind(row, column);
            turned.behind(other, column) = through ? std::uint16_t{0} : plan.removed(row, column);
        }
    std::reverse(turned.runs.begin(), turned.runs.end());
    for (LayerRun& run : turned.runs) {
        const int first = run.first;
        run.first = plan.layers + 1 - run.last;
        run.last = plan.layers + 1 - first;
    }
    return turned;
}

Message layers_text(const LayerRun& run) {
    const std::string first = std::to_string(run.first);
    if (run.first == run.last) return say("sponge.layer", {{"layer", first}});
    return say("sponge.layers", {{"first", first}, {"last", std::to_string(run.last)}});
}

}  // namespace snug

#include "snug/fabricate/pluck_plan.h"

#include <algorithm>

namespace snug {
namespace {

/// From the number of columns that lose just 0, 1, 2, ... blocks.
std::vector<LayerRun> layer_runs(const std::vector<long long>& columns_losing, int layers) {
    std::vector<LayerRun> runs;
    long long plucked = 0;
    for (const long long columns : columns_losing) plucked += columns;
    for (int layer = 1; layer <= layers; ++layer) {
        const long long ending = columns_losing[static_cast<std::size_t>(layer) - 1];
        plucked -= ending;
        // Layers nest, so equal counts are equal maps.
        if (!runs.empty() && ending == 0)
            runs.back().last = layer;
        else
            runs.push_back({layer, layer, plucked});
    }
    return runs;
}

}  // namespace

int PluckPlan::deepest() const {
    return removed.size() == 0 ? 0 : *std::max_element(removed.begin(), removed.end());
}

PluckPlan pluck_plan(const FoamDesign& design, Half half) {
    const bool lower = half == Half::lower;
    const Grid<std::uint16_t>& kept = lower ? design.foams.lower : design.foams.upper;
    const int ny = kept.ny(), nz = kept.nz();
    PluckPlan plan;
    plan.half = half;
    plan.layers = *std::max_element(kept.begin(), kept.end());
    plan.removed = Grid<std::uint16_t>(ny, nz);
    plan.row_mm = design.space.block_mm.y;
    plan.column_mm = design.space.block_mm.z;
    plan.layer_mm = design.space.block_mm.x;
    std::vector<long long> columns_losing(static_cast<std::size_t>(plan.layers) + 1, 0);
    for (int row = 0; row < ny; ++row)
        for (int column = 0; column < nz; ++column) {
            const int removed = plan.layers - kept(plan.row_from_back(row), column);
            plan.removed(row, column) = static_cast<std::uint16_t>(removed);
            plan.plucked += removed;
            ++columns_losing[static_cast<std::size_t>(removed)];
        }
    plan.runs = layer_runs(columns_losing, plan.layers);
    return plan;
}

std::string row_name(int row_from_back) {
    std::string name;
    for (int rest = row_from_back; rest >= 0; rest = rest / 26 - 1)
        name.insert(name.begin(), static_cast<char>('A' + rest % 26));
    return name;
}

std::string column_name(int column) {
    return std::to_string(column + 1);
}

std::string layers_text(const LayerRun& run) {
    if (run.first == run.last) return "layer " + std::to_string(run.first);
    return "layers " + std::to_string(run.first) + " to " + std::to_string(run.last);
}

}  // namespace snug

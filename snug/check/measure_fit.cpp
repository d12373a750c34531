#include "snug/check/measure_fit.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "snug/space/placed_mesh.h"

namespace snug {
namespace {

void add(BearingReport& all, const BearingReport& one) {
    for (std::size_t i = 0; i < kSinking.size(); ++i) {
        all.lower_mm2[i] += one.lower_mm2[i];
        all.upper_mm2[i] += one.upper_mm2[i];
    }
}

/// Each item by itself, so that one that hangs in the air is not lost among others.
Result<std::vector<BearingReport>> bearings_of(std::span<const Object> objects, Packing& packing,
                                               const Design& design, const Progress& progress) {
    std::vector<BearingReport> all;
    const double share = 1 / static_cast<double>(packing.items.size());
    for (std::size_t i = 0; i < packing.items.size(); ++i) {
        const Item& item = packing.items[i];
        const double done = share * static_cast<double>(i);
        const auto own = bearing_report(objects[item.object].mesh, item.placement, packing.space,
                                        *packing.foams, item.layer, part_of(progress, done, done + share));
        if (!own) return tl::unexpected(own.error());
        all.push_back(*own);
        std::vector<Finding> findings;
        find_bearing_problems(*own, *packing.foams, item.layer, item.mass_kg, design.fit, findings);
        for (Finding& finding : findings) {
            if (packing.items.size() > 1) finding.of = item.name;
            packing.findings.push_back(std::move(finding));
        }
    }
    return all;
}

/// What is cut of the foam below a level.
BlockMap below(BlockMap blocks, int level) {
    for (CutRun& run : blocks) run = run.common({0, static_cast<std::int16_t>(level)});
    return blocks;
}

/// Above a tray there is no gap.
Result<std::vector<GapReport>> gaps_of_layers(std::span<const Object> objects, const Packing& packing,
                                              const Progress& progress) {
    std::vector<GapReport> gaps;
    const int layers = packing.foams->layers();
    for (int i = 0; i < layers; ++i) {
        const PlacedMesh together(objects, of_layer(packing.items, i + 1));
        const auto at = static_cast<std::size_t>(i);
        const int parting = packing.foams->parting[at];
        const bool uncovered = packing.foams->open() && i + 1 == layers;
        auto gap = gap_report(together.mesh(), together.placement(), packing.space,
                              uncovered ? below(packing.layers[at], parting) : packing.layers[at], parting,
                              together.closed(), part_of(progress, 1.0 * i / layers, (i + 1.0) / layers));
        if (!gap) return tl::unexpected(gap.error());
        gaps.push_back(std::move(*gap));
    }
    return gaps;
}

}  // namespace

Result<MeasuredFit> measure_fit(std::span<const Object> objects, Packing& packing, const Design& design,
                                const Progress& progress) {
    for (const Item& item : packing.items)
        if (!objects[item.object].whole()) return MeasuredFit{};
    auto gaps = gaps_of_layers(objects, packing, part_of(progress, 0, 0.8));
    if (!gaps) return tl::unexpected(gaps.error());
    auto bearings = bearings_of(objects, packing, design, part_of(progress, 0.8, 1));
    if (!bearings) return tl::unexpected(bearings.error());
    BearingReport bearing;
    for (const BearingReport& own : *bearings) add(bearing, own);
    sort_by_severity(packing.findings);
    const GapFigures whole = united(*gaps);
    return MeasuredFit{whole, std::move(*gaps), bearing, std::move(*bearings)};
}

}  // namespace snug

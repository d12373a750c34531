#include "snug/check/measure_fit.h"

#include <utility>

namespace snug {

Result<MeasuredFit> measure_fit(const Object& object, Packing& packing, const Design& design,
                                const Progress& progress) {
    if (!object.whole()) return MeasuredFit{};
    auto gap =
        gap_report(object.mesh, packing.placement, packing.space, packing.blocks,
                   packing.foams->parting.front(), object.measure.watertight, part_of(progress, 0, 0.8));
    if (!gap) return tl::unexpected(gap.error());
    auto bearing = bearing_report(object.mesh, packing.placement, packing.space, *packing.foams,
                                  part_of(progress, 0.8, 1));
    if (!bearing) return tl::unexpected(bearing.error());
    find_bearing_problems(*bearing, design.workshop.mass_kg, design.fit.creep_kpa, packing.findings);
    return MeasuredFit{std::move(*gap), *bearing};
}

}  // namespace snug

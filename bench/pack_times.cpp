#include <cstdio>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/mesh/samples.h"
#include "snug/workshop.h"

#include "bench/measure_times.h"

// How long the packs for the workshop take, in the library: drawings, solids and their files, without PDF and
// zip.

namespace snug::bench {
namespace {

using json = nlohmann::json;
constexpr int kRepetitions = 5;

/// The camera in the default space, its blocks divided by `finer`.
json pack_time(Workshop work, int finer) {
    Project project;
    project.object.name = "camera";
    Design& design = project.design;
    design.object.units = Unit::mm;
    design.space.blocks = Vec3i{30 * finer, 18 * finer, 18 * finer};
    design.space.block_mm = design.space.block_mm * (1.0 / finer);
    design.workshop.work = work;
    const Object object = *prepare(*sample("camera"), design);
    const Packing packing = *pack(object, design);
    std::vector<double> times;
    std::size_t files = 0, pages = 0;
    for (int i = 0; i < kRepetitions; ++i) {
        times.push_back(time_of([&] {
            const auto made = workshop_pack(object, packing, project);
            if (!made) return;
            files = made->files.size() + made->containers.size();
            pages = 0;
            for (const DrawingDocument& document : made->documents) pages += document.pages.size();
        }));
    }
    return {{"pack", workshop_name(work)},
            {"blocks", {packing.space.blocks.x, packing.space.blocks.y, packing.space.blocks.z}},
            {"time", summary(times)},
            {"files", files},
            {"pages", pages}};
}

}  // namespace
}  // namespace snug::bench

int main() {
    using namespace snug;
    nlohmann::json report = nlohmann::json::array();
    for (const Workshop work : {Workshop::sponge, Workshop::sheets, Workshop::print})
        for (const int finer : {1, 10}) report.push_back(bench::pack_time(work, finer));
    std::puts(report.dump(1).c_str());
    return 0;
}

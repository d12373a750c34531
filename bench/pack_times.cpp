#include <algorithm>
#include <cstdio>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/make.h"
#include "snug/samples/samples.h"

#include "bench/measure_times.h"
#include "bench/refine.h"

// How long the packs for the workshop take, in the library: drawings, solids and their files, without PDF and
// zip.

namespace snug::bench {
namespace {

using json = nlohmann::json;
constexpr int kRepetitions = 5;

/// The default space, its blocks divided by `finer`.
Design finer_blocks(Workshop work, int finer) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks = Vec3i{30 * finer, 18 * finer, 18 * finer};
    design.space.block_mm = design.space.block_mm * (1.0 / finer);
    design.workshop.work = work;
    return design;
}

/// Blocks of another size; the camera's longest side fills two thirds of the space's.
Design other_blocks(Workshop work, Vec3i blocks, Vec3d block_mm) {
    Design design;
    design.object.longest_mm =
        std::max({blocks.x * block_mm.x, blocks.y * block_mm.y, blocks.z * block_mm.z}) * 2 / 3;
    design.space.blocks = blocks;
    design.space.block_mm = block_mm;
    design.workshop.work = work;
    design.workshop.mill.flute_mm = 400;
    return *checked(design);
}

/// The camera, packed and handed to the workshop.
json pack_time(const Design& chosen) {
    Project project;
    project.objects.front().file.name = "camera";
    Design& design = project.design;
    design = chosen;
    const Object object = *prepare(*sample("camera"), design);
    const Packing packing = *pack(object, design);
    std::vector<double> times;
    std::size_t files = 0, pages = 0;
    for (int i = 0; i < kRepetitions; ++i) {
        times.push_back(time_of([&] {
            const auto made = workshop_pack(std::span(&object, 1), packing, project);
            if (!made) return;
            files = made->files.size() + made->containers.size();
            pages = 0;
            for (const DrawingDocument& document : made->documents) pages += document.pages.size();
        }));
    }
    return {{"pack", name_of(design.workshop.work)},
            {"blocks", {packing.space.blocks.x, packing.space.blocks.y, packing.space.blocks.z}},
            {"time", summary(times)},
            {"files", files},
            {"pages", pages}};
}

/// Five items of about 100,000 triangles in the default space, each by itself against a wall of it; one is
/// moved and all are packed again, as while somebody drags it.
json moved_item_time() {
    constexpr int kMoves = 31, kItems = 5;
    Design design;
    design.object.units = Unit::mm;
    design.object.longest_mm = 90;
    std::vector<Object> objects;
    design.items.clear();
    std::size_t triangles = 0;
    for (int i = 0; i < kItems; ++i) {
        Mesh mesh = *sample(i % 2 == 0 ? "vase" : "figurine");
        while (mesh.triangles.size() < 100'000) mesh = refined(mesh);
        triangles = std::max(triangles, mesh.triangles.size());
        objects.push_back(*prepare(std::move(mesh), design));
        objects.back().edition = static_cast<std::uint64_t>(i) + 1;
        prepare_for_many(objects.back());
        ItemOptions item;
        item.object = i;
        item.offset_mm = Vec3d{0, i % 2 == 0 ? -60.0 : 60.0, 75.0 * (i - 2)};
        design.items.push_back(item);
    }
    KeptDepths kept;
    if (!pack(objects, design, {}, &kept)) return {};
    std::vector<double> times;
    for (int move = 0; move < kMoves; ++move) {
        design.items[2].offset_mm->y += move % 2 == 0 ? 1.37 : -1.21;
        times.push_back(time_of([&] { (void)pack(objects, design, {}, &kept); }));
    }
    return {{"moved", "one of five"}, {"triangles", triangles}, {"time", summary(times)}};
}

}  // namespace
}  // namespace snug::bench

int main() {
    using namespace snug;
    nlohmann::json report = nlohmann::json::array();
    for (const Workshop work : {Workshop::sponge, Workshop::sheets, Workshop::print, Workshop::mould})
        for (const int finer : {1, 10}) report.push_back(bench::pack_time(bench::finer_blocks(work, finer)));
    // Bricks without the linear program, which the library leaves to others; a mill's smooth contours.
    report.push_back(bench::pack_time(bench::other_blocks(Workshop::bricks, {30, 18, 18}, {9.6, 8, 8})));
    report.push_back(bench::pack_time(bench::other_blocks(Workshop::mill, {30, 18, 18}, {15, 15, 22})));
    report.push_back(bench::pack_time(bench::other_blocks(Workshop::mill, {60, 450, 400}, {5, 1, 1})));
    report.push_back(bench::moved_item_time());
    std::puts(report.dump(1).c_str());
    return 0;
}

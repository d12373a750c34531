#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>
#include <tbb/global_control.h>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/search/exact_cut.h"
#include "snug/search/greedy_climb.h"
#include "snug/search/placement_search.h"
#include "snug/space/available.h"

#include "bench/search_objects.h"

// How little the searches cut, and after how long, beside the least that any of them ever found.
//
// Usage: snug_search_quality [--seeds N] [--object NAME] [--exhaustive SECONDS]
// Writes JSON to standard output. With --exhaustive it searches that long from every seed instead, and keeps
// the best placements in bench/least_placements.json.
// Times are those of this thread's processor, so that other work on the machine does not count.

namespace {

using namespace snug;
using Json = nlohmann::ordered_json;

constexpr std::array<double, 4> kSeconds{0.1, 0.3, 1, 10};
const char* const kLeastFile = SNUG_SOURCE_DIR "/bench/least_placements.json";

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

Json load_least() {
    std::ifstream file(kLeastFile);
    return file ? Json::parse(file) : Json::object();
}

Vec3d vector_from(const Json& json) {
    return {json[0], json[1], json[2]};
}

/// The least placement that was ever stored, looked at again; none where there is none.
long long stored_least(const Json& least, const bench::NamedMesh& object, const PreparedSurface& surface,
                       const Design& design, const DesignSpace& space) {
    constexpr long long kNever = 1LL << 60;
    if (!least.contains(object.name)) return kNever;
    const Json& at = least[object.name];
    const auto exact = exact_cut(surface, space, design.cut, vector_from(at["rotation_deg"]),
                                 vector_from(at["offset_mm"]), all_blocks(space.blocks));
    return exact ? exact->cut_blocks : kNever;
}

void store_least(Json& least, const std::string& name, const FoundPlacement& found) {
    least[name] = {{"rotation_deg", {found.rotation_deg.x, found.rotation_deg.y, found.rotation_deg.z}},
                   {"offset_mm", {found.offset_mm.x, found.offset_mm.y, found.offset_mm.z}},
                   {"cut_blocks", found.cut_blocks}};
}

struct Arguments {
    int seeds = 10;
    double exhaustive = 0;
    std::string object;
    bool quick = false;
};

/// The cut after each of kSeconds, preparing included.
std::array<long long, kSeconds.size()> searched(const bench::NamedMesh& object, const Design& design,
                                                const DesignSpace& space, std::uint64_t seed, bool quick,
                                                FoundPlacement& best, long long& evaluations) {
    const double begun = processor_seconds();
    const PreparedSurface surface = prepare_surface(object.mesh);
    auto search = PlacementSearch::start(object.mesh, surface, design, space, seed, all_blocks(space.blocks));
    std::array<long long, kSeconds.size()> cut{};
    std::size_t mark = 0;
    const std::size_t marks = quick ? kSeconds.size() - 1 : kSeconds.size();
    while (mark < marks) {
        const long long before = search->best().cut_blocks;
        search->step();
        const double spent = processor_seconds() - begun;
        while (mark < marks && spent > kSeconds[mark]) cut[mark++] = before;
        if (mark == 3 && evaluations == 0) evaluations = search->evaluations();
    }
    best = search->best();
    if (quick) cut.back() = cut[marks - 1];
    return cut;
}

void exhaust(const bench::NamedMesh& object, const Design& design, const DesignSpace& space,
             const Arguments& arguments, Json& least) {
    const PreparedSurface surface = prepare_surface(object.mesh);
    long long record = stored_least(least, object, surface, design, space);
    for (int seed = 1; seed <= arguments.seeds; ++seed) {
        const double begun = processor_seconds();
        auto search =
            PlacementSearch::start(object.mesh, surface, design, space,
                                   static_cast<std::uint64_t>(1000 + seed), all_blocks(space.blocks));
        while (processor_seconds() - begun < arguments.exhaustive) search->step();
        std::fprintf(stderr, "%s seed %d: %lld (%lld)\n", object.name.c_str(), seed,
                     search->best().cut_blocks, record);
        if (search->best().cut_blocks >= record) continue;
        record = search->best().cut_blocks;
        store_least(least, object.name, search->best());
    }
}

Json measured(const bench::NamedMesh& object, const Design& design, const DesignSpace& space,
              const Arguments& arguments, Json& least) {
    const PreparedSurface surface = prepare_surface(object.mesh);
    const long long stored = stored_least(least, object, surface, design, space);
    const double begun = processor_seconds();
    const auto greedy = greedy_climb(object.mesh, design, space);
    Json row = {{"object", object.name},
                {"triangles", object.mesh.triangles.size()},
                {"start", start_climb(surface, design, space)->cut_blocks},
                {"greedy", greedy->cut_blocks},
                {"greedy_seconds", processor_seconds() - begun}};
    std::array<std::vector<long long>, kSeconds.size()> cuts;
    long long record = stored, evaluations = 0;
    for (int seed = 1; seed <= arguments.seeds; ++seed) {
        FoundPlacement best;
        const auto cut = searched(object, design, space, static_cast<std::uint64_t>(seed), arguments.quick,
                                  best, evaluations);
        for (std::size_t i = 0; i < cut.size(); ++i) cuts[i].push_back(cut[i]);
        if (best.cut_blocks < record) store_least(least, object.name, best);
        record = std::min(record, best.cut_blocks);
    }
    row["least"] = record;
    row["evaluations_a_second"] = evaluations;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        std::sort(cuts[i].begin(), cuts[i].end());
        row["snug"].push_back(
            {{"seconds", kSeconds[i]},
             {"median", cuts[i][cuts[i].size() / 2]},
             {"worst", cuts[i].back()},
             {"above_least_percent",
              100.0 * (static_cast<double>(cuts[i][cuts[i].size() / 2]) / static_cast<double>(record) - 1)}});
    }
    return row;
}

}  // namespace

int main(int count, char** words) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = words[i];
        if (word == "--seeds" && i + 1 < count) arguments.seeds = std::atoi(words[++i]);
        if (word == "--exhaustive" && i + 1 < count) arguments.exhaustive = std::atof(words[++i]);
        if (word == "--object" && i + 1 < count) arguments.object = words[++i];
        if (word == "--quick") arguments.quick = true;
    }
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Design design;
    const DesignSpace space;
    Json least = load_least();
    Json rows = Json::array();
    for (const bench::NamedMesh& object : bench::search_objects()) {
        if (!arguments.object.empty() && arguments.object != object.name) continue;
        if (arguments.exhaustive > 0) {
            exhaust(object, design, space, arguments, least);
        } else {
            rows.push_back(measured(object, design, space, arguments, least));
            std::fprintf(stderr, "%s\n", rows.back().dump().c_str());
        }
        std::ofstream(kLeastFile) << least.dump(2) << "\n";
    }
    if (arguments.exhaustive <= 0) std::printf("%s\n", rows.dump(2).c_str());
    return 0;
}

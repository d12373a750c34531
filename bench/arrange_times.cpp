// How small several items are packed, and how soon: two items against all arrangements that there are, kits
// against the least that is known and against peers, nesting instances against what is published. JSON on
// the standard output, lines for people beside it.
//
// Usage: snug_arrange_times [--seconds S] [--reference S] [--strip S] [two] [five] [ten] [many] [strips]
// --seconds: of a kit (10); --reference: of each of two other seeds that tell the least (60; 600 is the
// whole bench); --strip: of an instance, and of a hundred items (60).

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/object/prepare.h"
#include "snug/search/arrange.h"
#include "snug/search/arranged_items.h"
#include "snug/search/layer_heights.h"
#include "snug/search/mask_rooms.h"

#include "bench/arrange_peers.h"
#include "bench/nesting_instances.h"
#include "bench/search_objects.h"

namespace snug::bench {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

Design kit_design(int items, Vec3d block_mm, double wall_mm) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = block_mm;
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(wall_mm);
    design.items.clear();
    design.items.resize(static_cast<std::size_t>(items));
    for (int i = 0; i < items; ++i) design.items[static_cast<std::size_t>(i)].object = i;
    return design;
}

std::vector<Object> objects_of(const std::vector<NamedMesh>& meshes, const std::vector<std::size_t>& which) {
    std::vector<Object> objects;
    for (const std::size_t i : which) {
        objects.push_back(prepare(meshes[i].mesh, kit_design(1, {15, 15, 15}, 0)).value());
        objects.back().name = meshes[i].name;
        prepare_for_many(objects.back());
    }
    return objects;
}

/// When each better volume was found, within so many seconds.
struct Course {
    std::vector<std::pair<double, double>> better;  ///< seconds and mm3
    double lower_bound_mm3 = 0;
    [[nodiscard]] double after(double seconds) const {
        double volume = std::numeric_limits<double>::infinity();
        for (const auto& [at, mm3] : better)
            if (at <= seconds) volume = mm3;
        return volume;
    }
};

Course arranged_for(double seconds, std::vector<Object>& objects, Design design, std::uint32_t seed) {
    design.search.seed = seed;
    Course course;
    const auto begun = Clock::now();
    ArrangeWatch watch;
    watch.go_on = [&](double, std::optional<double>) { return seconds_since(begun) < seconds; };
    watch.better = [&](const Design& found) {
        const Vec3i n = *found.space.blocks;
        const Vec3d block = found.space.block_mm;
        course.better.push_back({seconds_since(begun), 1.0 * n.x * n.y * n.z * block.x * block.y * block.z});
    };
    const auto found = arrange(objects, design, true, std::numeric_limits<long long>::max() / 4, watch);
    if (found) course.lower_bound_mm3 = found->lower_bound_mm3.value_or(0);
    return course;
}

/// All ways to lay two items, all places of one beside the other: the fewest blocks without walls.
long long least_of_two(const ItemMasks& masks) {
    const MaskProblem& problem = masks.problem;
    const MaskGap gap = problem.gap;
    std::vector<BitMask> wide;
    for (const MaskShape& shape : problem.shapes) wide.push_back(grown(shape.mask, gap));
    long long least = std::numeric_limits<long long>::max();
    for (const int one : problem.pieces[0].shapes)
        for (const int other : problem.pieces[1].shapes) {
            const auto a = static_cast<std::size_t>(one), b = static_cast<std::size_t>(other);
            const BitMask &first = problem.shapes[a].mask, &second = problem.shapes[b].mask;
            const long long high = std::max(problem.shapes[a].height, problem.shapes[b].height);
            for (int j = -second.rows() - gap.rows; j <= first.rows() + gap.rows; ++j)
                for (int k = -second.columns() - gap.columns; k <= first.columns() + gap.columns; ++k) {
                    const int rows = std::max(first.rows(), j + second.rows()) - std::min(0, j);
                    const int columns = std::max(first.columns(), k + second.columns()) - std::min(0, k);
                    if (high * rows * columns < least && !wide[a].meets(wide[b], j, k))
                        least = high * rows * columns;
                }
        }
    return least;
}

Json two_items(const std::vector<NamedMesh>& meshes) {
    Json rows = Json::array();
    for (std::size_t i = 0; i + 1 < meshes.size(); i += 2) {
        std::vector<Object> objects = objects_of(meshes, {i, i + 1});
        // About 18 columns for both together.
        Design design = kit_design(2, {15, 15, 22}, 0);
        design.search.turns = Turns::quarter;
        const auto masks = item_masks(objects, design, design.space.block_mm, {false, false});
        const Course course = arranged_for(1, objects, design, 1);
        const double block = 15.0 * 15 * 22;
        const auto begun = Clock::now();
        const long long least = least_of_two(*masks);
        const double exhaustive = seconds_since(begun);
        const auto found = static_cast<long long>(std::llround(course.after(1) / block));
        rows.push_back({{"items", meshes[i].name + ", " + meshes[i + 1].name},
                        {"ways", masks->ways.size()},
                        {"least_blocks", least},
                        {"exhaustive_s", exhaustive},
                        {"found_blocks", found},
                        {"found_s", course.better.empty() ? 0 : course.better.back().first}});
        std::fprintf(stderr, "two: %s\n", rows.back().dump().c_str());
    }
    return rows;
}

Json one_kit(const std::vector<NamedMesh>& meshes, int count, double seconds, double reference) {
    std::vector<std::size_t> which;
    for (int i = 0; i < count; ++i)
        which.push_back(static_cast<std::size_t>(i) * meshes.size() / static_cast<std::size_t>(count));
    std::vector<Object> objects = objects_of(meshes, which);
    const Design design = kit_design(count, {15, 15, 15}, 50);
    const double block = 15.0 * 15 * 15;
    Json found = Json::array();
    double least = std::numeric_limits<double>::infinity(), bound = 0;
    std::vector<Course> courses;
    for (const std::uint32_t seed : {1u, 2u, 3u})
        courses.push_back(arranged_for(seconds, objects, design, seed));
    for (const std::uint32_t seed : {11u, 12u})
        least = std::min(least, arranged_for(reference, objects, design, seed).after(reference));
    for (const Course& course : courses) {
        least = std::min(least, course.after(seconds));
        bound = course.lower_bound_mm3;
    }
    for (const Course& course : courses)
        found.push_back({{"after_1_s", course.after(1) / block},
                         {"after_1_s_over_least", course.after(1) / least - 1},
                         {"after_all", course.after(seconds) / block},
                         {"after_all_over_least", course.after(seconds) / least - 1}});
    const auto masks =
        item_masks(objects, design, design.space.block_mm, std::vector<bool>(which.size(), false));
    const BlockWalls walls = block_walls(design.space, design.space.block_mm);
    const int high = height_of_layers(layer_heights(*masks, 1, walls, 4096).front(), walls);
    RoomTask task;
    task.price = [&](int rows, int columns) {
        return 1LL * high * (rows + walls.along(1)) * (columns + walls.along(2));
    };
    task.most_rows = task.most_columns = 120;
    task.heights = {4096};
    const long long shelves = shelf_price(masks->problem, task);
    const auto nested = nested_price(masks->problem, task, 120);
    Json row{{"items", count},
             {"least_blocks", least / block},
             {"lower_bound_blocks", bound / block},
             {"seeds", found},
             {"shelves_blocks", shelves},
             {"libnest2d_blocks", nested ? Json(*nested) : Json(nullptr)}};
    std::fprintf(stderr, "kit: %s\n", row.dump().c_str());
    return row;
}

/// A hundred items of twenty kinds: the bench objects, and some of them half as large.
Json many_items(const std::vector<NamedMesh>& meshes, double seconds) {
    constexpr std::size_t kKinds = 20, kItems = 100;
    std::vector<NamedMesh> kinds;
    for (std::size_t i = 0; i < kKinds; ++i) {
        kinds.push_back(meshes[i % meshes.size()]);
        if (i >= meshes.size()) kinds.back().mesh = scaled(std::move(kinds.back().mesh), 0.5);
    }
    std::vector<std::size_t> which(kKinds);
    for (std::size_t i = 0; i < kKinds; ++i) which[i] = i;
    std::vector<Object> objects = objects_of(kinds, which);
    Design design = kit_design(kItems, {15, 15, 15}, 50);
    for (std::size_t i = 0; i < kItems; ++i) design.items[i].object = static_cast<int>(i % kKinds);
    const Course course = arranged_for(seconds, objects, design, 1);
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const double block = 15.0 * 15 * 15, blocks = course.after(seconds) / block;
    Json row{{"items", kItems},
             {"kinds", kKinds},
             {"placed", std::isfinite(blocks)},
             {"first_s", course.better.empty() ? Json(nullptr) : Json(course.better.front().first)},
             {"blocks", std::isfinite(blocks) ? Json(blocks) : Json(nullptr)},
             {"lower_bound_blocks", course.lower_bound_mm3 / block},
             {"peak_mb", static_cast<double>(used.ru_maxrss) / 1024}};
    std::fprintf(stderr, "many: %s\n", row.dump().c_str());
    return row;
}

Json one_strip(const NestingInstance& instance, int cells, double seconds) {
    const double cell = instance.strip_height / cells;
    const MaskProblem problem = masks_of(instance, cell);
    double taken = 0;
    for (const MaskPiece& piece : problem.pieces)
        taken +=
            static_cast<double>(problem.shapes[static_cast<std::size_t>(piece.shapes.front())].mask.count()) *
            cell * cell;
    const auto begun = Clock::now();
    MaskPacker packer(problem, 1, [&](long long) { return seconds_since(begun) < seconds; });
    const auto packed = shortest_strip(packer, cells, std::numeric_limits<long long>::max() / 4);
    const double area = area_of(instance);
    const auto usage = [&](double length) { return 100 * area / (instance.strip_height * length); };
    Json row{{"instance", instance.name},
             {"cells", cells},
             {"area_over_cells_area", area / taken},
             {"usage", packed ? Json(usage(packed->rows * cell)) : Json(nullptr)},
             {"work", packer.work()}};
    std::fprintf(stderr, "strip: %s\n", row.dump().c_str());
    return row;
}

Json strips(double seconds) {
    Json rows = Json::array();
    const auto instances = nesting_instances();
    if (instances.empty()) std::fprintf(stderr, "strips: no instances, ../shared/nesting is absent\n");
    for (const NestingInstance& instance : instances) {
        for (const int cells : {300, 1000}) rows.push_back(one_strip(instance, cells, seconds));
        const double length = area_of(instance) / instance.strip_height;
        const auto nested = nested_strip(all_polygons(instance), instance.strip_height, 2.5 * length,
                                         instance.half_turns, seconds);
        rows.push_back({{"instance", instance.name},
                        {"libnest2d_usage", nested ? Json(100 * length / *nested) : Json(nullptr)}});
        std::fprintf(stderr, "strip: %s\n", rows.back().dump().c_str());
    }
    return rows;
}

int run(int count, char** arguments) {
    double seconds = 10, reference = 60, strip = 60;
    std::vector<std::string> parts;
    for (int i = 1; i < count; ++i) {
        const std::string text = arguments[i];
        if (text.rfind("--", 0) != 0)
            parts.push_back(text);
        else if (i + 1 < count)
            (text == "--seconds"     ? seconds
             : text == "--reference" ? reference
                                     : strip) = std::atof(arguments[++i]);
    }
    const auto wanted = [&](const char* part) {
        return parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end();
    };
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    Json report;
    if (wanted("two") || wanted("five") || wanted("ten") || wanted("many")) {
        const std::vector<NamedMesh> meshes = search_objects();
        if (wanted("two")) report["two"] = two_items(meshes);
        if (wanted("many")) report["many"] = many_items(meshes, strip);
        if (wanted("five")) report["kits"].push_back(one_kit(meshes, 5, seconds, reference));
        if (wanted("ten")) report["kits"].push_back(one_kit(meshes, 10, seconds, reference));
    }
    if (wanted("strips")) report["strips"] = strips(strip);
    std::printf("%s\n", report.dump(1).c_str());
    return 0;
}

}  // namespace
}  // namespace snug::bench

int main(int count, char** arguments) {
    return snug::bench::run(count, arguments);
}

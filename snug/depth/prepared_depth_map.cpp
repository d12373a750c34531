#include <cstddef>
#include <memory>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/depth/cluster_walk.h"
#include "snug/depth/depth_builder.h"
#include "snug/depth/depth_map.h"

namespace snug {
namespace {

/// Groups of one level that are shared out among the workers: enough that none waits long for the last.
constexpr std::size_t kFewestTasks = 16;

/// The highest level with enough groups; the lowest where none has.
std::size_t task_level(const SurfaceClusters& surface) {
    std::size_t level = surface.levels.size() - 1;
    while (level > 0 && surface.levels[level].groups.size() < kFewestTasks) --level;
    return level;
}

/// A worker's own depth map: it begins with the samples, and ends with some of the surface.
struct Worker {
    DepthMapBuilder builder;
    ClusterWalk walk;

    Worker(const DepthMapBuilder& start, const SurfaceClusters& surface, const Placement& placement,
           const DesignSpace& space, Reach reach)
        : builder(start), walk(surface, placement, space, reach, builder) {}
};

void add_surface(DepthMapBuilder& builder, const SurfaceClusters& surface, const Placement& placement,
                 const DesignSpace& space, Reach reach) {
    if (surface.clusters.empty()) return;
    const auto walk = std::make_unique<ClusterWalk>(surface, placement, space, reach, builder);
    walk->add_samples();
    const std::size_t level = task_level(surface);
    const std::size_t tasks = surface.levels[level].groups.size();
    if (worker_count() == 1 || tasks < kFewestTasks) return walk->add_group(surface.levels.size() - 1, 0);

    // Extremes of extremes: the same whatever each worker got.
    std::vector<std::unique_ptr<Worker>> workers(worker_count());
    parallel_for_workers(tasks, [&](std::size_t task, std::size_t number) {
        std::unique_ptr<Worker>& worker = workers[number];
        if (!worker) worker = std::make_unique<Worker>(builder, surface, placement, space, reach);
        worker->walk.add_group(level, task);
    });
    for (const auto& worker : workers)
        if (worker) builder.include(worker->builder);
}

}  // namespace

DepthMap depth_map(const PreparedSurface& surface, const Placement& placement, const DesignSpace& space,
                   Reach reach) {
    DepthMapBuilder builder(space, reach);
    add_surface(builder, surface.body, placement, space, reach);
    add_surface(builder, surface.caps, placement, space, reach);
    return builder.take();
}

}  // namespace snug

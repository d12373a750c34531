#include "snug/base/parallel.h"

#ifndef __EMSCRIPTEN__
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace snug {

#ifdef __EMSCRIPTEN__

void parallel_for_workers(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) work(i, 0);
}

std::size_t worker_count() {
    return 1;
}

#else

void parallel_for_workers(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) {
    tbb::parallel_for(
        std::size_t{0}, count,
        [&work](std::size_t i) {
            work(i, static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()));
        },
        tbb::simple_partitioner());
}

std::size_t worker_count() {
    const std::size_t allowed =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    if (allowed == 1) return 1;
    return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
}

#endif

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work) {
    parallel_for_workers(count, [&work](std::size_t i, std::size_t) { work(i); });
}

}  // namespace snug

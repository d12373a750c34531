#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/depth/depth_builder.h"

namespace snug {

/// Adds items 0 to count - 1 with add(builder, item). Each worker fills a depth map of its own: extremes of
/// extremes are the same whatever each got. `at_once`: items that one task treats.
template <class Add>
void add_in_parallel(DepthMapBuilder& builder, std::size_t count, Add add,
                     std::size_t at_once = std::size_t{1} << 14) {
    const std::size_t chunks = (count + at_once - 1) / at_once;
    const auto add_chunk = [&](DepthMapBuilder& own, std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * at_once);
        for (std::size_t item = chunk * at_once; item < end; ++item) add(own, item);
    };
    if (worker_count() == 1 || chunks < 2) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) add_chunk(builder, chunk);
        return;
    }
    std::vector<std::unique_ptr<DepthMapBuilder>> workers(worker_count());
    parallel_for_workers(chunks, [&](std::size_t chunk, std::size_t worker) {
        if (!workers[worker]) workers[worker] = std::make_unique<DepthMapBuilder>(builder);
        add_chunk(*workers[worker], chunk);
    });
    for (const auto& own : workers)
        if (own) builder.include(*own);
}

}  // namespace snug

#pragma once

#include <cstddef>
#include <functional>

namespace snug {

/// Calls work(0) to work(count - 1), natively on as many threads as the caller's oneTBB arena allows, in the
/// browser one after the other. In any order: results may not depend on it. Returns when all are done.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work);

/// The same with the number of the worker that makes the call, from 0 to worker_count() - 1: no two calls
/// that run at the same time have the same one, so a worker can keep a result of its own.
void parallel_for_workers(std::size_t count,
                          const std::function<void(std::size_t index, std::size_t worker)>& work);
[[nodiscard]] std::size_t worker_count();

}  // namespace snug

#include "cli/make_search.h"

#include <chrono>
#include <limits>

#include <fmt/core.h>

#include "snug/object/prepare.h"
#include "snug/search/placement_search.h"

#include "cli/interrupt.h"

namespace snug::cli {

Result<SearchReport> search(Object& object, Design& design, const SearchArguments& arguments,
                            StatusLine& status) {
    if (auto done = mark_stand_in(object, status.progress(say("status.thinning"))); !done)
        return tl::unexpected(done.error());
    prepare_for_many(object);
    SearchTask task;
    task.fit_case = arguments.fit_case;
    task.placement = arguments.optimize;
    task.evaluations = arguments.seconds ? std::numeric_limits<long long>::max() : kSearchEvaluations;

    InterruptGuard guard;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begun = Clock::now();
    bool out_of_time = false;
    auto report = search_design(
        object.mesh, *object.prepared, design, task, [&](double share, std::optional<long long> cut_blocks) {
            const std::chrono::duration<double> spent = Clock::now() - begun;
            if (arguments.seconds) share = spent.count() / *arguments.seconds;
            const std::string percent = fmt::format("{:.0f}", share * 100);
            status.show(cut_blocks ? say("status.searching",
                                         {{"percent", percent}, {"blocks", std::to_string(*cut_blocks)}})
                                   : say("status.fitting", {{"percent", percent}}));
            out_of_time = arguments.seconds && share >= 1;
            return !out_of_time && !InterruptGuard::interrupted();
        });
    if (report && out_of_time) report->cancelled = false;
    // The interrupt is answered by keeping what was found.
    InterruptGuard::forget();
    return report;
}

}  // namespace snug::cli

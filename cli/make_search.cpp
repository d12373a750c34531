#include "cli/make_search.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/design/object_argument.h"
#include "snug/make.h"
#include "snug/object/prepare.h"
#include "snug/search/placement_search.h"

#include "cli/interrupt.h"

namespace snug::cli {

bool SearchArguments::searches(const Design& design) const {
    return optimize || (fit_case && design.items.size() == 1);
}

bool SearchArguments::arranges(const Design& design, bool typed) const {
    if (design.items.size() < 2 || no_arrange) return false;
    return arrange || fit_case || known_case || (typed && wants_arrangement(design));
}

Result<SearchReport> search(Object& object, Design& design, const SearchArguments& arguments,
                            StatusLine& status) {
    if (auto done = mark_stand_in(object, status.progress(say("status.thinning"))); !done)
        return tl::unexpected(done.error());
    prepare_for_many(object);
    SearchTask task;
    task.fit_case = arguments.fit_case;
    task.placement = arguments.optimize;
    task.evaluations = arguments.seconds ? std::numeric_limits<long long>::max() : kSearchEvaluations;
    task.pack_it = [&object](const Design& tried) { return pack(object, tried); };

    InterruptGuard guard;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begun = Clock::now();
    bool out_of_time = false;
    auto report = search_design(object, design, task, [&](double share, std::optional<long long> cut_blocks) {
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

Result<Arrangement> arrange(std::span<Object> objects, Design& design, const SearchArguments& arguments,
                            const std::vector<KnownCase>& cases, StatusLine& status) {
    if (arguments.fit_case && design.case_options.inside_mm)
        return fail(ErrorKind::usage, say("search.case_given"));
    Design searched = design;
    if (arguments.fit_case) searched.space.blocks.reset();
    const bool all = arguments.arrange || arguments.fit_case || arguments.known_case;
    const long long work =
        arguments.seconds ? std::numeric_limits<long long>::max() / 4 : usual_arranging_work(design);
    InterruptGuard guard;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begun = Clock::now();
    bool out_of_time = false;
    ArrangeWatch watch;
    watch.go_on = [&](double share, std::optional<double> volume_mm3) {
        const std::chrono::duration<double> spent = Clock::now() - begun;
        if (arguments.seconds) share = spent.count() / *arguments.seconds;
        const std::string percent = fmt::format("{:.0f}", std::min(1.0, share) * 100);
        std::vector<Message> best;
        if (volume_mm3) best.push_back(say("status.litres", {{"litres", number(*volume_mm3 * 1e-6, 1)}}));
        status.show(say("status.arranging", {{"percent", percent}, {"best", best}}));
        out_of_time = arguments.seconds && share >= 1;
        return !out_of_time && !InterruptGuard::interrupted();
    };
    watch.pack_it = [&](const Design& tried) { return pack(objects, tried); };
    const auto look = [&](long long most, const ArrangeWatch& told) {
        return arguments.known_case ? arrange_in_known_case(objects, searched, all, cases, most, told)
                                    : snug::arrange(objects, searched, all, most, told);
    };
    auto found = look(work, watch);
    // Where time ran out before all went in: who is left is said as after fixed work.
    if (!found && out_of_time && found.error().kind == ErrorKind::cancelled)
        found = look(usual_arranging_work(design) / 4, {{}, {}, watch.pack_it});
    if (!found) return found;
    if (out_of_time) found->cancelled = false;
    InterruptGuard::forget();
    design = std::move(searched);
    return found;
}

}  // namespace snug::cli

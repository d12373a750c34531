#include "cli/make_search.h"

#include <chrono>
#include <cstdint>
#include <limits>
#include <sstream>

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/object/prepare.h"
#include "snug/search/placement_search.h"

#include "cli/interrupt.h"
#include "cli/option_values.h"

namespace snug::cli {
namespace {

/// "cut=1,bearing=0.5"; a name alone weighs 1.
Result<void> apply_objectives(const std::string& text, SearchOptions& search) {
    search.weight.fill(0);
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const auto objective = objective_from_name(name);
        double weight = 1;
        bool number = true;
        if (equals != std::string::npos) {
            const char* const end = word.data() + word.size();
            const auto parsed = fast_float::from_chars(word.data() + equals + 1, end, weight);
            number = parsed.ec == std::errc() && parsed.ptr == end;
        }
        if (!objective || !number)
            return fail(
                ErrorKind::usage,
                fmt::format("--objective takes cut, gap, depth, bearing or flat, each with a weight if "
                            "you like, as in cut=1,bearing=0.5; not \"{}\"",
                            word));
        search.weight[static_cast<std::size_t>(*objective)] = weight;
    }
    return {};
}

}  // namespace

void add_search_options(CLI::App& make, SearchArguments& a) {
    make.add_flag("--optimize", a.optimize,
                  "Search the rotation and offset that are best; Ctrl-C keeps the best so far");
    make.add_flag("--fit-case", a.fit_case,
                  "Choose the smallest block counts that hold the object and its walls (50)");
    make.add_flag("--billed-weight", a.billed_weight, "With --fit-case: the least billed weight, not volume");
    make.add_option("--objective", a.objective,
                    "What --optimize weighs: cut, gap, depth, bearing, flat (cut)")
        ->type_name("NAME[=WEIGHT],...");
    make.add_option("--upright", a.upright, "Keep this axis of the object upward")
        ->type_name("x|y|z|-x|-y|-z");
    make.add_option("--seed", a.seed, "Another search; the same seed finds the same (1)")->type_name("N");
    make.add_option("--search-seconds", a.seconds,
                    "Search this long instead of a fixed amount of work; results then depend on the machine")
        ->type_name("S")
        ->check(CLI::Validator(
            [](std::string& text) {
                // Written so that what is no number at all fails as well.
                double seconds = 0;
                return CLI::detail::lexical_cast(text, seconds) && seconds >= 0.01 && seconds <= 86400
                           ? std::string()
                           : "takes 0.01 to 86400 seconds, not " + snug::quoted(text);
            },
            "0.01 to 86400"));
}

Result<void> apply(const SearchArguments& a, SearchOptions& search) {
    if (a.objective)
        if (auto done = apply_objectives(*a.objective, search); !done) return done;
    if (a.upright) {
        search.upright = upright_from_name(*a.upright);
        if (!search.upright)
            return fail(ErrorKind::usage,
                        fmt::format("--upright takes x, y, z, -x, -y or -z, not \"{}\"", *a.upright));
    }
    if (a.seed) {
        const auto seed = parse_integer("--seed", *a.seed);
        if (!seed) return tl::unexpected(seed.error());
        if (*seed < 0) return fail(ErrorKind::usage, "--seed takes a whole number from 0 upward");
        search.seed = static_cast<std::uint32_t>(*seed);
    }
    if (a.billed_weight) search.case_goal = CaseGoal::billed_weight;
    return {};
}

Result<SearchReport> search(Object& object, Design& design, const SearchArguments& arguments,
                            StatusLine& status) {
    if (auto done = mark_stand_in(object, status.progress("Thinning")); !done)
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
            status.show(cut_blocks
                            ? fmt::format("Searching {:.0f} %: {} blocks cut", share * 100, *cut_blocks)
                            : fmt::format("Fitting the case {:.0f} %", share * 100));
            out_of_time = arguments.seconds && share >= 1;
            return !out_of_time && !InterruptGuard::interrupted();
        });
    if (report && out_of_time) report->cancelled = false;
    // The interrupt is answered by keeping what was found.
    InterruptGuard::forget();
    return report;
}

}  // namespace snug::cli

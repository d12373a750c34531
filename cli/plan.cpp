#include "snug/plan.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <tbb/global_control.h>
#include <vector>

#include "snug/base/text.h"
#include "snug/object/prepare.h"

#include "cli/arguments.h"
#include "cli/clp_solver.h"
#include "cli/console.h"
#include "cli/folder_run.h"
#include "cli/make_task.h"
#include "cli/plan_text.h"
#include "cli/user_cases.h"
#include "cli/user_foams.h"

namespace snug::cli {
namespace {

struct PlanArguments {
    Language language;
    TaskArguments task;
    std::optional<std::string> folder;
    std::string carrier = std::string(name_of(Carrier::parcel));
    std::optional<std::string> ways;
    std::string cases = std::string(name_of(CaseChoice::cartons));
    std::optional<double> seconds_each;
    bool quiet = false, json = false;
    int threads = 0;
};

std::vector<Argument> arguments_of(PlanArguments& a) {
    const auto help = [&](const char* code) { return text(say(code), a.language); };
    const auto of_names = [&](const char* code, std::span<const std::string_view> names) {
        return text(say(code, {{"names", each_as_it_is(names)}}), a.language);
    };
    std::vector<Argument> all{
        {"OBJECT", "", text(say("help.make.object", {{"example", "lens.stl:count=2,mass=0.6"}}), a.language),
         &a.task.objects, true},
        {"-o,--output", "DIR", help("help.plan.output"), &a.folder},
        {"--carrier", "WHO", of_names("help.plan.carrier", names_of<Carrier>()), &a.carrier},
        {"--ways", "WAY,...", of_names("help.plan.ways", names_of<Workshop>().subspan(1)), &a.ways},
        {"--choose-case", "FROM", of_names("help.plan.cases", names_of<CaseChoice>()), &a.cases},
        {"--seconds-each", "S", help("help.plan.seconds"), &a.seconds_each, false, {{0, 86400}}}};
    for (const Flag& flag : design_flags(a.language))
        all.push_back(
            {flag.name, flag.takes, flag.help, DesignFlag{&a.task.design, flag.many, flag.repeats}});
    const std::vector<Argument> rest{
        {"--object", "FILE", help("help.project_object"), &a.task.replacement_object},
        {"--threads", "N", help("help.make.threads"), &a.threads, false, {{1, 1024}}},
        {"--quiet", "", help("help.make.quiet"), &a.quiet},
        {"--json", "", help("help.plan.json"), &a.json}};
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

Error wrong_word(const char* option, std::span<const std::string_view> names, std::string_view word) {
    return {
        ErrorKind::usage,
        say("plan.one_kind", {{"option", option}, {"names", each_as_it_is(names)}, {"word", quoted(word)}})};
}

Result<std::vector<Workshop>> ways_of(const PlanArguments& a, const Design& design) {
    if (design.workshop.work != Workshop::none) return std::vector{design.workshop.work};
    if (!a.ways) return PlanWishes().ways;
    std::vector<Workshop> ways;
    for (std::string_view rest = *a.ways; !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find(','));
        const auto way = value_named<Workshop>(word);
        if (!way || *way == Workshop::none)
            return tl::unexpected(wrong_word("--ways", names_of<Workshop>().subspan(1), word));
        if (std::find(ways.begin(), ways.end(), *way) == ways.end()) ways.push_back(*way);
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    }
    if (ways.empty()) return tl::unexpected(wrong_word("--ways", names_of<Workshop>().subspan(1), ""));
    return ways;
}

Result<void> put_cases(const PlanArguments& a, PlanWishes& wishes) {
    const auto choice = value_named<CaseChoice>(a.cases);
    if (!choice) return tl::unexpected(wrong_word("--choose-case", names_of<CaseChoice>(), a.cases));
    const auto known = known_cases(a.language);
    if (!known) return tl::unexpected(known.error());
    choose_cases(*known, *choice, wishes);
    return {};
}

Result<PlanWishes> wishes_of(const PlanArguments& a, const Design& design) {
    PlanWishes wishes;
    const auto carrier = value_named<Carrier>(a.carrier);
    if (!carrier) return tl::unexpected(wrong_word("--carrier", names_of<Carrier>(), a.carrier));
    wishes.carrier = *carrier;
    auto ways = ways_of(a, design);
    if (!ways) return tl::unexpected(ways.error());
    wishes.ways = std::move(*ways);
    wishes.own_blocks = was_typed(a.task.design, "--preset") || was_typed(a.task.design, "--block-size");
    auto foams = known_foams();
    if (!foams) return tl::unexpected(foams.error());
    wishes.foams = std::move(*foams);
    if (auto done = put_cases(a, wishes); !done) return tl::unexpected(done.error());
    wishes.seconds_each = a.seconds_each;
    return wishes;
}

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

Result<void> write_proposals(std::span<const Proposal> proposals, const std::string& report,
                             FolderRun&& run) {
    if (auto done = run.open(); !done) return done;
    for (const Proposal& proposal : proposals) {
        const std::string name(name_of(proposal.kind));
        if (auto done = run.write(name + ".snug.json", bytes_of(project_json(proposal.project))); !done)
            return done;
        if (auto done = run.write(name + ".svg", bytes_of(proposal.preview_svg)); !done) return done;
    }
    if (auto done = run.write("plan.json", bytes_of(report)); !done) return done;
    if (auto earlier = run.look_back({}); !earlier) return tl::unexpected(earlier.error());
    return run.commit();
}

int plan(const PlanArguments& a) {
    std::optional<tbb::global_control> limit;
    if (a.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(a.threads));
    auto task = task_from(a.task, a.language);
    if (!task) return report(task.error(), a.language);
    if (task->expected.empty() && !was_typed(a.task.design, "--blocks"))
        task->project.design.space.blocks.reset();
    const auto wishes = wishes_of(a, task->project.design);
    if (!wishes) return report(wishes.error(), a.language);
    std::optional<StatusLine> status(std::in_place, a.quiet, a.language);
    const auto give_up = [&](const Error& error) {
        status.reset();
        return report(error, a.language);
    };
    auto read = read_objects_of(*task, *status);
    if (!read) return give_up(read.error());
    for (Object& object : read->objects) {
        if (auto done = mark_stand_in(object, status->progress(say("status.thinning"))); !done)
            return give_up(done.error());
        prepare_for_many(object);
    }
    Tools tools;
    tools.solve_lp = clp_solver();
    tools.language = a.language;
    const auto proposals =
        snug::plan(read->objects, task->project, *wishes, tools, status->progress(say("status.planning")));
    if (!proposals) {
        const Error& error = proposals.error();
        const bool of_object = error.kind == ErrorKind::input || error.kind == ErrorKind::does_not_fit;
        return give_up(of_object ? Error{error.kind, in_its_file(*task, error)} : error);
    }
    const std::string json = plan_json(*proposals, a.language);
    if (a.folder)
        if (auto done = write_proposals(*proposals, json, {*a.folder, {}, inputs_of(a.task, *task)}); !done)
            return give_up(done.error());
    status.reset();
    if (a.quiet && !a.json) return kDone;
    const auto done = print(a.json ? json : plan_text(*proposals, {task->paths, a.folder}, a.language));
    return done ? kDone : report(done.error(), a.language);
}

}  // namespace

CommandSpec plan_command(Language language) {
    const auto a = std::make_shared<PlanArguments>();
    a->language = language;
    return {"plan", text(say("help.plan"), language),
            "snug plan camera.stl --mass 0.9 --fragility 85 --carrier parcel -o camera-plan",
            arguments_of(*a), [a] {
                (void)take_protecting_walls(a->task);  // a plan does so anyway
                return within_memory(a->task.objects.front(), a->language, [&] { return plan(*a); });
            }};
}

}  // namespace snug::cli

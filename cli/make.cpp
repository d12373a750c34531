#include "snug/make.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tbb/global_control.h>
#include <vector>

#include <fmt/core.h>

#include "snug/base/stopwatch.h"
#include "snug/design/project.h"
#include "snug/words/words.h"

#include "cli/arguments.h"
#include "cli/clp_solver.h"
#include "cli/console.h"
#include "cli/folder_run.h"
#include "cli/interrupt.h"
#include "cli/make_object.h"
#include "cli/make_search.h"
#include "cli/make_task.h"
#include "cli/make_workshop.h"
#include "cli/object_file.h"
#include "cli/summary.h"
#include "cli/user_cases.h"
#include "cli/user_foams.h"
#include "cli/user_presets.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

/// What was typed.
struct MakeArguments {
    Language language;
    TaskArguments task;
    std::string folder;
    std::optional<std::string> font;
    SearchArguments search;
    bool protecting_walls = false;  ///< --wall protect
    bool dry_run = false, quiet = false, json = false;
    int threads = 0;
};

/// Of an object with all the choices that an item has.
constexpr const char* kExample =
    "lens.stl:count=2,rotate=0x90x0,move=0x40x0,clearance=1x2x2,mass=0.6,name=lens,group=a,units=cm";

std::vector<Argument> arguments_of(MakeArguments& a) {
    const auto help = [&](const char* code) { return text(say(code), a.language); };
    std::vector<Argument> all{
        {"OBJECT", "", text(say("help.make.object", {{"example", kExample}}), a.language), &a.task.objects,
         true},
        {"-o,--output", "DIR", help("help.make.output"), &a.folder, true}};
    for (const Flag& flag : design_flags(a.language))
        all.push_back(
            {flag.name, flag.takes, flag.help, DesignFlag{&a.task.design, flag.many, flag.repeats}});
    const std::vector<Argument> rest{
        {"--optimize", "", help("help.make.optimize"), &a.search.optimize},
        {"--fit-case", "", help("help.make.fit_case"), &a.search.fit_case},
        {"--arrange", "", help("help.make.arrange"), &a.search.arrange},
        {"--no-arrange",
         "",
         help("help.make.no_arrange"),
         &a.search.no_arrange,
         false,
         {},
         {},
         {"--arrange"}},
        {"--known-case",
         "",
         help("help.make.known_case"),
         &a.search.known_case,
         false,
         {},
         {},
         {"--no-arrange", "--case"}},
        {"--search-seconds", "S", help("help.make.seconds"), &a.search.seconds, false, {{0.01, 86400}}},
        {"--no-stream", "", help("help.make.no_stream"), &a.task.no_stream},
        {"--stream", "", help("help.make.stream"), &a.task.stream, false, {}, {}, {"--no-stream"}},
        {"--object", "FILE", help("help.project_object"), &a.task.replacement_object},
        {"--font", "FILE", help("help.make.font"), &a.font},
        {"--dry-run", "", help("help.make.dry_run"), &a.dry_run},
        {"--threads", "N", help("help.make.threads"), &a.threads, false, {{1, 1024}}},
        {"--quiet", "", help("help.make.quiet"), &a.quiet},
        {"--json", "", help("help.make.json"), &a.json}};
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

/// Writes everything, the report last, since it tells how long the rest took and what of earlier runs stays.
Result<std::string> write_outputs(std::span<const Object> objects, const Project& project, Made& made,
                                  const PdfLetters& letters, FolderRun&& run) {
    WorkshopFiles of_pack;
    if (made.pack) {
        auto files = workshop_files(*made.pack, letters);
        if (!files) return tl::unexpected(files.error());
        of_pack = std::move(*files);
        made.packing.findings.insert(made.packing.findings.end(), of_pack.findings.begin(),
                                     of_pack.findings.end());
    }
    const InterruptGuard guard;
    if (auto done = run.open(); !done) return tl::unexpected(done.error());
    Packing& packing = made.packing;
    packing.timing.write = 0;
    const auto write = [&](const PackFile& file) {
        Stopwatch watch;
        auto done = run.write(file.name, file.bytes);
        packing.timing.write += watch.lap();
        return done;
    };
    if (auto done = make_output_files(objects, project, made, write); !done)
        return tl::unexpected(done.error());
    for (const PackFile& file : of_pack.files)
        if (auto done = write(file); !done) return tl::unexpected(done.error());
    const std::string report_name = "report.json";
    const auto earlier = run.look_back({&report_name, 1});
    if (!earlier) return tl::unexpected(earlier.error());
    packing.findings.insert(packing.findings.end(), earlier->begin(), earlier->end());
    sort_by_severity(packing.findings);
    const std::string report = report_json(objects, project, made);
    if (auto done = run.write(report_name, std::as_bytes(std::span(report))); !done)
        return tl::unexpected(done.error());
    if (auto done = run.commit(); !done) return tl::unexpected(done.error());
    InterruptGuard::finished();
    return report;
}

/// What this program has, and the status line that long work moves.
Tools tools_for(const Task& task, const MakeArguments& arguments, StatusLine& status) {
    const SearchArguments& searched = arguments.search;
    Tools tools;
    tools.solve_lp = clp_solver();
    tools.language = arguments.language;
    tools.protecting_walls = arguments.protecting_walls;
    if (searched.searches(task.project.design))
        tools.search = [&](Object& object, Design& design) -> Result<SearchReport> {
            auto found = search(object, design, searched, status);
            if (!found) return fail(found.error().kind, in_its_file(task, found.error()));
            return found;
        };
    if (searched.arranges(task.project.design, task.expected.empty()))
        tools.arrange = [&](std::span<Object> objects, Design& design) -> Result<Arrangement> {
            std::vector<KnownCase> cases;
            if (searched.known_case) {
                auto known = known_cases(arguments.language);
                if (!known) return tl::unexpected(known.error());
                cases = std::move(*known);
            }
            return arrange(objects, design, searched, cases, status);
        };
    tools.progress = [&status](Stage stage) {
        if (stage == Stage::workshop) status.show(say("status.workshop"));
        return status.progress(say(stage == Stage::walls      ? "status.walls"
                                   : stage == Stage::cut      ? "status.cutting"
                                   : stage == Stage::workshop ? "status.bricks"
                                   : stage == Stage::gaps     ? "status.gaps"
                                                              : "status.drops"));
    };
    return tools;
}

int say_that_it_does_not_fit(const Task& task, std::span<const Object> objects, const Made& made,
                             const MakeArguments& arguments) {
    if (arguments.json)
        if (auto done = print(report_json(objects, task.project, made)); !done)
            return report(done.error(), arguments.language);
    const Finding& first = made.packing.findings.front();
    const Message message =
        task.paths.size() == 1 ? in_file(task.paths.front().string(), first.message) : said_of_item(first);
    return report({ErrorKind::does_not_fit, message}, arguments.language);
}

/// What is typed for a search does nothing without one, and not both may choose the space.
std::optional<Error> search_lacking(const MakeArguments& arguments, const Task& task) {
    const Design& design = task.project.design;
    if (arguments.protecting_walls && arguments.search.fit_case)
        return Error{ErrorKind::usage, say("protect.fit_case", {{"option", "--fit-case"}})};
    if (!was_typed(arguments.task.design, "--objective") || arguments.search.searches(design) ||
        arguments.search.arranges(design, task.expected.empty()))
        return {};
    return Error{ErrorKind::usage,
                 say("search.objective_alone",
                     {{"option", "--objective"}, {"search", "--optimize"}, {"arrange", "--arrange"}})};
}

int make(const MakeArguments& arguments) {
    std::optional<tbb::global_control> limit;
    if (arguments.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(arguments.threads));
    const Language language = arguments.language;
    auto task = task_from(arguments.task, language);
    if (!task) return report(task.error(), language);
    if (const auto error = search_lacking(arguments, *task)) return report(*error, language);
    if (arguments.search.known_case && task->project.design.items.size() == 1)
        return report(
            {ErrorKind::usage, say("search.known_case_of_one", {{"command", "snug cases --for FILE"}})},
            language);

    std::optional<StatusLine> status(std::in_place, arguments.quiet, language);
    const auto give_up = [&](const Error& error) {
        status.reset();
        return report(error, language);
    };
    auto read = read_objects_of(*task, *status);
    if (!read) return give_up(read.error());
    const std::span<Object> objects = read->objects;
    Project& project = task->project;
    auto made = snug::make(objects, project, tools_for(*task, arguments, *status));
    // What is read in pieces is read all the while.
    if (!made && made.error().kind == ErrorKind::input)
        return give_up({made.error().kind, in_its_file(*task, made.error())});
    if (!made) return give_up(made.error());
    made->packing.timing.read = read->read_ms;
    status.reset();
    if (!made->packing.foams) return say_that_it_does_not_fit(*task, objects, *made, arguments);

    // What it takes is said before anything is written.
    if (made->pack && !arguments.quiet && !arguments.json)
        if (auto done = print(workshop_summary(*made->pack, project.design, language)); !done)
            return report(done.error(), language);
    const bool dry = arguments.dry_run;
    status.emplace(arguments.quiet || dry, language);
    status->show(say("status.writing"));
    const auto report_text =
        dry ? Result<std::string>(report_json(objects, project, *made))
            : write_outputs(objects, project, *made, {language, arguments.font},
                            {arguments.folder, workshop_folders(), inputs_of(arguments.task, *task)});
    status.reset();
    if (!report_text) return report(report_text.error(), language);
    if (arguments.json) {
        if (auto done = print(*report_text); !done) return report(done.error(), language);
    } else if (!arguments.quiet) {
        if (auto done =
                print(summary(objects, project, *made, dry ? std::string() : arguments.folder, language));
            !done)
            return report(done.error(), language);
    }
    return kDone;
}

}  // namespace

CommandSpec make_command(Language language) {
    const auto a = std::make_shared<MakeArguments>();
    a->language = language;
    return {
        "make", text(say("help.make"), language),
        "\n"
        "  snug make vase.stl -o vase-foam\n"
        "  snug make scan.ply --units m --preset slit-10 --blocks auto --clearance 1 -o scan-foam\n"
        "  snug make vase.stl:count=2,upright=z camera.stl:clearance=1x2x2,mass=0.9 --blocks auto -o kit\n"
        "  snug make scan-foam/project.snug.json --object scan.ply --rotate 0,90,0 -o turned",
        arguments_of(*a), [a] {
            a->protecting_walls = take_protecting_walls(a->task);
            return within_memory(a->task.objects.front(), a->language, [&] { return make(*a); });
        }};
}

}  // namespace snug::cli

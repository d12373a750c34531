#include "snug/make.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
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
#include "cli/make_workshop.h"
#include "cli/object_file.h"
#include "cli/summary.h"
#include "cli/user_cases.h"
#include "cli/user_presets.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

/// What was typed.
struct MakeArguments {
    std::string object;
    std::string folder;
    std::vector<TypedFlag> design;
    std::optional<std::string> replacement_object;
    SearchArguments search;
    bool dry_run = false, quiet = false, json = false;
    bool stream = false, no_stream = false;
    int threads = 0;
};

std::vector<Argument> arguments_of(MakeArguments& a) {
    std::vector<Argument> all{
        {"OBJECT", "",
         "A mesh (STL, OBJ, PLY, OFF, glTF, 3MF), a point cloud (PLY, XYZ, PTS) or a project (*.snug.json)",
         &a.object, true},
        {"-o,--output", "DIR",
         "The folder for the files that are made; what an earlier run made there and this one does not goes, "
         "unless somebody changed it",
         &a.folder, true}};
    for (const Flag& flag : design_flags())
        all.push_back({flag.name, flag.takes, flag.help, DesignFlag{&a.design, flag.many, flag.repeats}});
    const std::vector<Argument> rest{
        {"--optimize", "", "Search the rotation and offset that are best; Ctrl-C keeps the best so far",
         &a.search.optimize},
        {"--fit-case", "", "Choose the smallest block counts that hold the object and its walls (50)",
         &a.search.fit_case},
        {"--search-seconds",
         "S",
         "Search this long instead of a fixed amount of work; results then depend on the machine",
         &a.search.seconds,
         false,
         {{0.01, 86400}}},
        {"--no-stream", "", "Read even a large file whole", &a.no_stream},
        {"--stream",
         "",
         "Read the object in pieces, so that it need not fit into memory (chosen by itself for large files)",
         &a.stream,
         false,
         {},
         {},
         {"--no-stream"}},
        {"--object", "FILE", "The object's file, for a project that does not lie beside it",
         &a.replacement_object},
        {"--dry-run", "", "Say what would be made and what it takes; write nothing", &a.dry_run},
        {"--threads",
         "N",
         "Threads to use at most; the files are the same for any number",
         &a.threads,
         false,
         {{1, 1024}}},
        {"--quiet", "", "Print nothing but errors", &a.quiet},
        {"--json", "", "Print the report to standard output instead of the summary", &a.json}};
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

/// The design with what was typed.
Result<Design> design_from(const MakeArguments& a, Design design, bool from_project) {
    auto typed = with_flags(a.design, std::move(design), from_project, {known_presets, known_cases});
    return typed ? checked(std::move(*typed)) : typed;
}

Result<Task> task_from(const MakeArguments& arguments) {
    auto source = find_object(arguments.object, arguments.replacement_object);
    if (!source) return tl::unexpected(source.error());
    Task task;
    if (arguments.stream || arguments.no_stream) task.stream = arguments.stream;
    task.units_typed = was_typed(arguments.design, "--units");
    task.object_path = source->object;
    if (source->project) {
        task.project = std::move(*source->project);
        task.expected = task.project.object;
    }
    auto design = design_from(arguments, task.project.design, source->project.has_value());
    if (!design) return tl::unexpected(design.error());
    task.project.design = std::move(*design);
    return task;
}

/// Writes everything, the report last, since it tells how long the rest took and what of earlier runs stays.
Result<std::string> write_outputs(const Object& object, const Project& project, Made& made, FolderRun&& run) {
    std::vector<PackFile> of_pack;
    if (made.pack) {
        auto files = workshop_files(*made.pack);
        if (!files) return tl::unexpected(files.error());
        of_pack = std::move(*files);
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
    if (auto done = make_output_files(object, project, made, write); !done)
        return tl::unexpected(done.error());
    for (const PackFile& file : of_pack)
        if (auto done = write(file); !done) return tl::unexpected(done.error());
    const std::string report_name = "report.json";
    const auto earlier = run.look_back({&report_name, 1});
    if (!earlier) return tl::unexpected(earlier.error());
    packing.findings.insert(packing.findings.end(), earlier->begin(), earlier->end());
    sort_by_severity(packing.findings);
    const std::string report = report_json(object, project, made);
    if (auto done = run.write(report_name, std::as_bytes(std::span(report))); !done)
        return tl::unexpected(done.error());
    if (auto done = run.commit(); !done) return tl::unexpected(done.error());
    InterruptGuard::finished();
    return report;
}

Message in_its_file(const Task& task, const Error& error) {
    return in_file(task.object_path.string(), error.message);
}

/// What this program has, and the status line that long work moves.
Tools tools_for(const Task& task, const SearchArguments& searched, StatusLine& status) {
    Tools tools;
    tools.solve_lp = clp_solver();
    if (searched.asked())
        tools.search = [&](Object& object, Design& design) -> Result<SearchReport> {
            auto found = search(object, design, searched, status);
            if (!found) return fail(found.error().kind, in_its_file(task, found.error()));
            return found;
        };
    tools.progress = [&status](Stage stage) {
        if (stage == Stage::workshop) status.show("Drawing for the workshop");
        return status.progress(stage == Stage::cut        ? "Cutting"
                               : stage == Stage::workshop ? "Checking how firmly the bricks hold"
                                                          : "Measuring gaps");
    };
    return tools;
}

int say_that_it_does_not_fit(const Task& task, const Object& object, const Made& made, bool json) {
    if (json)
        if (auto done = print(report_json(object, task.project, made)); !done) return report(done.error());
    return report(
        {ErrorKind::does_not_fit, in_file(task.object_path.string(), made.packing.findings.front().message)});
}

int make(const MakeArguments& arguments) {
    std::optional<tbb::global_control> limit;
    if (arguments.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(arguments.threads));
    auto task = task_from(arguments);
    if (!task) return report(task.error());

    std::optional<StatusLine> status(std::in_place, arguments.quiet);
    const auto give_up = [&](const Error& error) {
        status.reset();
        return report(error);
    };
    auto read = read_object_of(*task, *status);
    if (!read) return give_up(read.error());
    Object& object = read->object;
    Project& project = task->project;
    auto made = snug::make(object, project, tools_for(*task, arguments.search, *status));
    // What is read in pieces is read all the while.
    if (!made && made.error().kind == ErrorKind::input)
        return give_up({made.error().kind, in_its_file(*task, made.error())});
    if (!made) return give_up(made.error());
    made->packing.timing.read = read->read_ms;
    status.reset();
    if (!made->packing.foams) return say_that_it_does_not_fit(*task, object, *made, arguments.json);

    // What it takes is said before anything is written.
    if (made->pack && !arguments.quiet && !arguments.json)
        if (auto done = print(workshop_summary(*made->pack, project.design, Language::english)); !done)
            return report(done.error());
    const bool dry = arguments.dry_run;
    status.emplace(arguments.quiet || dry);
    status->show("Writing");
    const auto report_text =
        dry ? Result<std::string>(report_json(object, project, *made))
            : write_outputs(object, project, *made,
                            {arguments.folder, workshop_folders(), {arguments.object, task->object_path}});
    status.reset();
    if (!report_text) return report(report_text.error());
    if (arguments.json) {
        if (auto done = print(*report_text); !done) return report(done.error());
    } else if (!arguments.quiet) {
        if (auto done = print(
                summary(object, project, *made, dry ? std::string() : arguments.folder, Language::english));
            !done)
            return report(done.error());
    }
    return kDone;
}

}  // namespace

CommandSpec make_command() {
    const auto a = std::make_shared<MakeArguments>();
    return {"make", "Make foams from an object, or from a project file",
            "Examples:\n"
            "  snug make vase.stl -o vase-foam\n"
            "  snug make scan.ply --units m --preset slit-10 --blocks auto --clearance 1 -o scan-foam\n"
            "  snug make scan-foam/project.snug.json --object scan.ply --rotate 0,90,0 -o turned",
            arguments_of(*a), [a] { return within_memory(a->object, [&] { return make(*a); }); }};
}

}  // namespace snug::cli

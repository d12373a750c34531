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

#include "cli/clp_solver.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/folder_run.h"
#include "cli/interrupt.h"
#include "cli/make_case.h"
#include "cli/make_clean.h"
#include "cli/make_fit.h"
#include "cli/make_object.h"
#include "cli/make_search.h"
#include "cli/make_workshop.h"
#include "cli/object_file.h"
#include "cli/option_values.h"
#include "cli/summary.h"
#include "cli/user_presets.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

/// The options as they were typed; none where they were not.
struct MakeArguments {
    std::string object;
    std::string folder;
    std::optional<std::string> units, preset, blocks, block_size, rotate, move, parting, wall,
        replacement_object;
    std::optional<double> scale, longest;
    std::vector<std::string> formats;
    SearchArguments search;
    WorkshopArguments workshop;
    FitArguments fit;
    CleanArguments clean;
    std::optional<double> point_radius;
    bool cap = false, quiet = false, json = false;
    bool stream = false, no_stream = false;
    int threads = 0;
    CaseArguments case_arguments;
};

void add_options(CLI::App& make, MakeArguments& arguments) {
    auto& a = arguments;
    make.add_option("OBJECT", a.object,
                    "A mesh (STL, OBJ, PLY, OFF, glTF, 3MF), a point cloud (PLY, XYZ, PTS) or a project "
                    "(*.snug.json)")
        ->required();
    make.add_option(
            "-o,--output", a.folder,
            "The folder for the files that are made; what an earlier run made there and this one does not "
            "goes, unless somebody changed it")
        ->required()
        ->type_name("DIR");
    make.add_option("--units", a.units, "The unit of the file (mm)")->type_name("mm|cm|m|in");
    make.add_option("--scale", a.scale, "Multiply every length by this (1)")->type_name("S");
    make.add_option("--longest", a.longest, "Scale the object's longest side to this")->type_name("MM");
    make.add_option("--preset", a.preset,
                    "A foam that `snug presets` lists: block size and clearance (paper)")
        ->type_name("NAME");
    make.add_option("--blocks", a.blocks, "Blocks along x, y, z, or auto: the object plus walls (30x18x18)")
        ->type_name("30x18x18|auto");
    make.add_option("--block-size", a.block_size, "Size of a block in mm (15x15x22)")->type_name("15x15x22");
    make.add_option("--rotate", a.rotate, "Degrees about the fixed axes x, then y, then z (0,0,0)")
        ->type_name("PSI,THETA,PHI");
    make.add_option("--move", a.move, "Shift from the centre of the space, mm (0,0,0)")->type_name("X,Y,Z");
    make.add_option(
            "--wall", a.wall,
            "Least foam between object and case: all sides, or X,Y,Z, or floor,roof,back,front,left,right "
            "(0; 50 with --blocks auto)")
        ->type_name("MM|X,Y,Z|SIX");
    add_case_options(make, a.case_arguments);
    make.add_option("--parting", a.parting, "Blocks of the lower foam where the object does not touch (auto)")
        ->type_name("auto|LEVEL");
    make.add_flag("--cap", a.cap, "Close the holes of an open object before cutting");
    make.add_option("--point-radius", a.point_radius,
                    "Point clouds: each point counts as a ball of this radius (0: from the spacing)")
        ->type_name("MM");
    CLI::Option* whole = make.add_flag("--no-stream", a.no_stream, "Read even a large file whole");
    make.add_flag(
            "--stream", a.stream,
            "Read the object in pieces, so that it need not fit into memory (chosen by itself for large "
            "files)")
        ->excludes(whole);
    add_clean_options(make, a.clean);
    add_fit_options(make, a.fit);
    add_search_options(make, a.search);
    make.add_option("--object", a.replacement_object,
                    "The object's file, for a project that does not lie beside it")
        ->type_name("FILE");
    make.add_option("--formats", a.formats, "Formats of the foams: stl, ply (both)")
        ->type_name("stl,ply")
        ->delimiter(',');
    add_workshop_options(make, a.workshop);
    make.add_option("--threads", a.threads, "Threads to use at most; the files are the same for any number")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    make.add_flag("--quiet", a.quiet, "Print nothing but errors");
    make.add_flag("--json", a.json, "Print the report to standard output instead of the summary");
    make.footer(
        "Examples:\n"
        "  snug make vase.stl -o vase-foam\n"
        "  snug make scan.ply --units m --preset slit-10 --blocks auto --clearance 1 -o scan-foam\n"
        "  snug make scan-foam/project.snug.json --object scan.ply --rotate 0,90,0 -o turned");
}

/// Applies what was typed to the design, presets first so that explicit sizes win.
Result<Design> design_from(const MakeArguments& a, Design design, bool from_project) {
    const auto implied = implied_preset(a.workshop, {a.preset.has_value(), from_project});
    if (!implied) return tl::unexpected(implied.error());
    if (const auto& name = a.preset ? a.preset : *implied) {
        const auto presets = known_presets();
        if (!presets) return tl::unexpected(presets.error());
        const auto preset = find_preset(*presets, *name);
        if (!preset) return tl::unexpected(preset.error());
        apply(*preset, design);
        design.workshop.density_kg_m3 = preset->density_kg_m3;
        // The default count of blocks belongs to the default foam.
        if (*implied) design.space.blocks.reset();
    }
    if (auto done = apply_workshop(a.workshop, design); !done) return tl::unexpected(done.error());
    if (a.units) {
        design.object.units = unit_from_name(*a.units);
        if (!design.object.units)
            return fail(ErrorKind::usage, fmt::format("--units takes mm, cm, m or in, not \"{}\"", *a.units));
    }
    if (a.scale) design.object.scale = *a.scale;
    if (a.longest) design.object.longest_mm = *a.longest;
    if (a.cap) design.object.cap = true;
    if (auto done = take_clean(a.clean, design.object.clean); !done) return tl::unexpected(done.error());
    if (a.point_radius) design.object.point_radius_mm = *a.point_radius;
    if (a.blocks && *a.blocks == "auto") {
        design.space.blocks.reset();
    } else if (a.blocks) {
        const auto counts = parse_counts("--blocks", *a.blocks);
        if (!counts) return tl::unexpected(counts.error());
        design.space.blocks = *counts;
    }
    const auto take = [](const char* option, const std::optional<std::string>& text, auto parse,
                         Vec3d& target) {
        if (!text) return std::optional<Error>();
        const auto value = parse(option, *text);
        if (!value) return std::optional<Error>(value.error());
        target = *value;
        return std::optional<Error>();
    };
    if (auto error = take("--block-size", a.block_size, parse_sizes, design.space.block_mm))
        return tl::unexpected(*error);
    if (auto error = take("--rotate", a.rotate, parse_vector, design.placement.rotation_deg))
        return tl::unexpected(*error);
    if (auto error = take("--move", a.move, parse_vector, design.placement.offset_mm))
        return tl::unexpected(*error);
    if (auto done = take_fit(a.fit, design); !done) return tl::unexpected(done.error());
    if (a.wall) {
        const auto walls = parse_walls("--wall", *a.wall);
        if (!walls) return tl::unexpected(walls.error());
        design.space.wall_mm = *walls;
    }
    if (auto done = take_case(a.case_arguments, a.blocks.has_value(), design); !done)
        return tl::unexpected(done.error());
    if (a.parting && *a.parting == "auto") {
        design.parting.level.reset();
    } else if (a.parting) {
        const auto level = parse_integer("--parting", *a.parting);
        if (!level) return tl::unexpected(level.error());
        design.parting.level = *level;
    }
    if (!a.formats.empty()) design.output.formats = a.formats;
    if (auto done = apply(a.search, design.search); !done) return tl::unexpected(done.error());
    return checked(design);
}

Result<Task> task_from(const MakeArguments& arguments) {
    auto source = find_object(arguments.object, arguments.replacement_object);
    if (!source) return tl::unexpected(source.error());
    Task task;
    if (arguments.stream || arguments.no_stream) task.stream = arguments.stream;
    task.units_typed = arguments.units.has_value();
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
    if (!made && object.is_streamed())  // whose file is read all the while
        return give_up({made.error().kind, in_its_file(*task, made.error())});
    if (!made) return give_up(made.error());
    made->packing.timing.read = read->read_ms;
    status.reset();
    if (!made->packing.foams) return say_that_it_does_not_fit(*task, object, *made, arguments.json);

    // What it takes is said before anything is written.
    if (made->pack && !arguments.quiet && !arguments.json)
        if (auto done = print(workshop_summary(*made->pack, project.design, Language::english)); !done)
            return report(done.error());
    const bool dry = arguments.workshop.dry_run;
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

void add_make(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("make", "Make foams from an object, or from a project file");
    const auto arguments = std::make_shared<MakeArguments>();
    add_options(*command, *arguments);
    command->callback([arguments, &chosen] {
        chosen = [arguments] { return within_memory(arguments->object, [&] { return make(*arguments); }); };
    });
}

}  // namespace snug::cli

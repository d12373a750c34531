#include "cli/make_task.h"

#include <utility>

#include "snug/design/project.h"

#include "cli/object_file.h"
#include "cli/user_cases.h"
#include "cli/user_foams.h"
#include "cli/user_presets.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

Result<Design> design_from(const TaskArguments& a, Language language, Design design, bool from_project) {
    auto typed = with_flags(a.design, std::move(design), from_project,
                            {known_presets, [&] { return known_cases(language); }, known_foams});
    return typed && from_project ? checked(std::move(*typed)) : typed;
}

}  // namespace

Result<Task> task_from(const TaskArguments& arguments, Language language) {
    auto source = find_objects(arguments.objects, arguments.replacement_object);
    if (!source) return tl::unexpected(source.error());
    Task task;
    if (arguments.stream || arguments.no_stream) task.stream = arguments.stream;
    task.units_typed = was_typed(arguments.design, "--units");
    const bool from_project = source->project.has_value();
    if (from_project) {
        task.project = std::move(*source->project);
        take_over_one_item(task.project);
        task.expected = task.project.objects;
        task.paths = std::move(source->paths);
    }
    auto design = design_from(arguments, language, task.project.design, from_project);
    if (!design) return tl::unexpected(design.error());
    task.project.design = std::move(*design);
    if (from_project) return task;

    std::vector<std::string> files;
    auto project = with_objects(source->typed, std::move(task.project.design), files);
    if (!project) return tl::unexpected(project.error());
    task.project = std::move(*project);
    task.paths.assign(files.begin(), files.end());
    auto all = checked(std::move(task.project.design));
    if (!all) return tl::unexpected(all.error());
    task.project.design = std::move(*all);
    take_over_one_item(task.project);
    return task;
}

std::vector<fs::path> inputs_of(const TaskArguments& arguments, const Task& task) {
    std::vector<fs::path> inputs = task.paths;
    if (!task.expected.empty()) inputs.emplace_back(arguments.objects.front());
    return inputs;
}

bool take_protecting_walls(TaskArguments& arguments) {
    const auto asks = [](const TypedFlag& typed) {
        return typed.flag == "--wall" && typed.text == "protect";
    };
    return std::erase_if(arguments.design, asks) > 0;
}

Message in_its_file(const Task& task, const Error& error) {
    return task.paths.size() == 1 ? in_file(task.paths.front().string(), error.message) : error.message;
}

}  // namespace snug::cli

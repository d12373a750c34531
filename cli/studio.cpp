#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "snug/base/text.h"
#include "snug/design/project.h"
#include "snug/formats/mesh_files.h"
#include "snug/formats/read_object.h"
#include "snug/mesh/thin.h"
#include "snug/words/words.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/files.h"
#include "cli/object_file.h"
#include "cli/scene_tools.h"
#include "cli/web_server.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

/// What a page can hold beside its foams.
constexpr std::uintmax_t kBrowserLimit = 200'000'000;
/// Enough to choose a placement by.
constexpr std::size_t kThinTriangles = 500'000;

struct StudioArguments {
    Language language;
    std::optional<std::string> object;
    std::optional<std::string> replacement_object;
    std::optional<std::string> files;
    int port = 0;
    std::uintmax_t most_bytes = kBrowserLimit;
    bool quiet = false;
};

/// Beside the program where it was built, or below share/ where it was installed.
fs::path studio_folder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path installed = program.parent_path() / "share" / "snug" / "studio";
    return fs::exists(installed, error) ? installed : program.parent_path() / "studio" / "dist";
}

std::vector<std::byte> as_vector(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

/// At least `value`, in three digits or a few more.
std::string rounded_up(double value) {
    int decimals = 0;
    double power = 1;
    for (; decimals < 9 && value * power < 100; ++decimals) power *= 10;
    return number(std::ceil(value * power) / power, decimals);
}

/// A copy for looking instead of a file that no page can hold. Its lengths are the file's own.
void offer_thin_copy(Site& site, nlohmann::json& info, const Mesh& mesh, const fs::path& path) {
    const ThinMesh thin = thinned(mesh, kThinTriangles);
    info["name"] = path.stem().string() + "-thin.ply";
    info["shown_triangles"] = thin.mesh.triangles.size();
    info["deviation"] = thin.deviation;
    site.contents["/object/file"] = write_ply(thin.mesh.vertices, thin.mesh.triangles, {});
}

/// The tools that read the object; what it takes from beside itself is offered to the page, by number, and
/// its name noted.
SceneTools offering_tools(Site& site, nlohmann::json& beside, const fs::path& path) {
    SceneTools tools = scene_tools(path);
    tools.beside = [&site, &beside, read = std::move(tools.beside)](const std::string& name) {
        auto content = read(name);
        if (content) {
            site.contents[fmt::format("/object/beside/{}", beside.size())] = *content;
            beside.push_back(name);
        }
        return content;
    };
    return tools;
}

/// Puts the object, and its project if it has one, where the page looks for it.
Result<nlohmann::json> offer_object(Site& site, const StudioArguments& arguments, StatusLine& status) {
    const auto source = find_object(*arguments.object, arguments.replacement_object);
    if (!source) return tl::unexpected(source.error());
    status.show(say("status.reading_file", {{"file", source->object.string()}}));
    auto bytes = read_file(source->object);
    if (!bytes) return tl::unexpected(bytes.error());
    const ObjectFile file = describe(source->object, *bytes);
    nlohmann::json beside = nlohmann::json::array();
    const auto mesh = snug::read_object(*bytes, file.name, offering_tools(site, beside, source->object));
    if (!mesh) return fail(mesh.error().kind, in_file(source->object.string(), mesh.error().message));
    const bool thin = bytes->size() > arguments.most_bytes;
    const std::size_t triangles = mesh->triangles.size();
    nlohmann::json info{{"name", file.name},      {"original", file.name},
                        {"bytes", file.bytes},    {"sha256", file.sha256},
                        {"thinned", thin},        {"project", source->project.has_value()},
                        {"triangles", triangles}, {"shown_triangles", triangles},
                        {"deviation", 0},         {"beside", beside}};
    if (thin) {
        status.show(say("status.thinning_file", {{"file", source->object.string()}}));
        offer_thin_copy(site, info, *mesh, source->object);
    } else {
        site.contents["/object/file"] = std::move(*bytes);
    }
    if (source->project) site.contents["/object/project"] = as_vector(project_json(*source->project));
    site.contents["/object/info"] = as_vector(info.dump());
    return info;
}

int studio(const StudioArguments& arguments) {
    const Language language = arguments.language;
    auto site = site_of_folder(arguments.files ? fs::path(*arguments.files) : studio_folder());
    if (!site) return report(site.error(), language);
    std::string thinned_note;
    if (arguments.object) {
        std::optional<StatusLine> status(std::in_place, arguments.quiet, language);
        const auto info = offer_object(*site, arguments, *status);
        status.reset();
        if (!info) return report(info.error(), language);
        if ((*info)["thinned"])
            thinned_note =
                text(say("studio.thinned",
                         {{"file", *arguments.object},
                          {"triangles", std::to_string((*info)["shown_triangles"].get<std::size_t>())},
                          {"off", rounded_up((*info)["deviation"].get<double>())}}),
                     language) +
                "\n";
    }
    const auto done = serve(*site, arguments.port, [&](int port) {
        const std::string address =
            fmt::format("http://127.0.0.1:{}/{}", port, arguments.object ? "?object" : "");
        (void)print((arguments.quiet
                         ? address
                         : thinned_note + text(say("studio.at", {{"address", address}}), language)) +
                    "\n");
    });
    return done ? kDone : report(done.error(), language);
}

}  // namespace

CommandSpec studio_command(Language language) {
    const auto a = std::make_shared<StudioArguments>();
    a->language = language;
    const auto help = [&](const Message& message) { return text(message, language); };
    return {"studio",
            help(say("help.studio")),
            "\n  snug studio\n  snug studio vase.stl",
            {{"OBJECT", "", help(say("help.studio.object")), &a->object},
             {"--object",
              "FILE",
              help(say("help.project_object")),
              &a->replacement_object,
              false,
              {},
              {"OBJECT"}},
             {"--port", "N", help(say("help.studio.port")), &a->port, false, {{0, 65535}}},
             {"--files", "DIR", help(say("help.studio.files")), &a->files},
             {"--most-bytes", "N", help(say("help.studio.most_bytes")), &a->most_bytes},
             {"--quiet", "", help(say("help.studio.quiet")), &a->quiet}},
            [a] { return studio(*a); }};
}

}  // namespace snug::cli

#include "cli/make_pack.h"

#include <cstdint>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "snug/base/stopwatch.h"
#include "snug/pack_stream.h"

#include "cli/file_source.h"
#include "cli/files.h"
#include "cli/scene_file.h"

namespace snug::cli {
namespace {

tl::unexpected<Error> in_file(const Task& task, const Error& error) {
    return fail(error.kind, fmt::format("{}: {}", task.object_path.string(), error.message));
}

void look_for_change(const Task& task, Packing& packing) {
    if (!task.expected) return;
    const ObjectFile &was = *task.expected, &is = task.project.object;
    const bool hashed = !was.sha256.empty() && !is.sha256.empty();
    if (hashed ? was.sha256 == is.sha256 : was.bytes == is.bytes) return;
    packing.findings.push_back(
        {Severity::warning,
         "object_changed",
         "the object " + is.name + " is not the one that the project was made with: check the result",
         {}});
    sort_by_severity(packing.findings);
}

/// Figures of a search with a stand-in are the stand-in's.
void note_stand_in(Packing& packing) {
    packing.findings.push_back({Severity::note,
                                "searched_stand_in",
                                "the search worked with a stand-in that holds the object, so its own figures "
                                "are a little too high; the foams are of the object itself",
                                {}});
}

Result<Packed> pack_in_memory(Task& task, const SearchArguments& search_arguments, StatusLine& status) {
    const std::string path = task.object_path.string();
    status.show("Reading " + path);
    Stopwatch watch;
    const auto bytes = read_file(task.object_path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto mesh = read_object(*bytes, task.object_path);
    const double read_ms = watch.lap();
    if (!mesh) return in_file(task, mesh.error());
    if (const auto error = unwanted_units(*mesh, task.units_typed)) return in_file(task, *error);
    task.project.object = describe(task.object_path, *bytes);

    status.show("Cutting");
    auto object = prepare(std::move(*mesh), task.project.design);
    if (!object) return in_file(task, object.error());
    std::optional<SearchReport> searched;
    if (search_arguments.asked()) {
        auto found = search(*object, task.project.design, search_arguments, status);
        if (!found) return in_file(task, found.error());
        searched = std::move(*found);
    }
    auto packing = pack(*object, task.project.design);
    if (!packing) return tl::unexpected(packing.error());
    packing->timing.read = read_ms;
    if (searched && object->kind != ObjectKind::mesh) note_stand_in(*packing);
    return Packed{std::move(*object), std::move(*packing), std::move(searched)};
}

Result<Packed> pack_in_pieces(Task& task, const TriangleStream& stream, std::uint64_t file_size,
                              const SearchArguments& search_arguments, StatusLine& status) {
    // No hash: it would take longer than all the rest.
    task.project.object = {task.object_path.filename().string(), file_size, ""};
    std::optional<SearchReport> searched;
    if (search_arguments.asked()) {
        auto object = stand_in(stream, task.project.design, status.progress("Thinning"));
        if (!object) return in_file(task, object.error());
        auto found = search(*object, task.project.design, search_arguments, status);
        if (!found) return in_file(task, found.error());
        searched = std::move(*found);
    }
    auto packed = pack_stream(stream, task.project.design, status.progress("Cutting"));
    if (!packed) return in_file(task, packed.error());
    if (searched) note_stand_in(packed->packing);
    return Packed{std::move(packed->object), std::move(packed->packing), std::move(searched)};
}

/// Whether to try: a file that is too large for memory, and nothing asked that needs the whole object.
bool should_stream(const Task& task) {
    std::error_code error;
    const auto size = std::filesystem::file_size(task.object_path, error);
    return !error && too_large_for_memory(size) && !task.project.design.object.cap &&
           task.project.design.object.clean.none();
}

}  // namespace

Result<Packed> read_and_pack(Task& task, const SearchArguments& search, StatusLine& status) {
    auto packed = [&]() -> Result<Packed> {
        if (!task.stream.value_or(should_stream(task))) return pack_in_memory(task, search, status);
        const auto source = open_source(task.object_path);
        if (!source) return tl::unexpected(source.error());
        const auto stream = TriangleStream::open(*source, status.progress("Reading"));
        if (stream) return pack_in_pieces(task, *stream, source->size, search, status);
        // What nobody wanted in pieces may be of a kind that is only read whole, and says itself what is
        // wrong.
        const bool asked = task.stream.has_value();
        if (asked || stream.error().kind != ErrorKind::input) return in_file(task, stream.error());
        return pack_in_memory(task, search, status);
    }();
    if (packed) look_for_change(task, packed->packing);
    return packed;
}

}  // namespace snug::cli

#include "cli/make_object.h"

#include <cstdint>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "snug/base/stopwatch.h"
#include "snug/object/prepare.h"
#include "snug/words/words.h"

#include "cli/file_source.h"
#include "cli/files.h"
#include "cli/scene_file.h"

namespace snug::cli {
namespace {

tl::unexpected<Error> of_object(const Task& task, const Error& error) {
    return fail(error.kind, in_file(task.object_path.string(), error.message));
}

void look_for_change(const Task& task, std::vector<Finding>& findings) {
    if (!task.expected) return;
    const ObjectFile &was = *task.expected, &is = task.project.object;
    const bool hashed = !was.sha256.empty() && !is.sha256.empty();
    if (hashed ? was.sha256 == is.sha256 : was.bytes == is.bytes) return;
    findings.push_back({Severity::warning, say("object_changed", {{"name", is.name}})});
}

Result<ReadObject> read_whole(Task& task, StatusLine& status) {
    status.show(say("status.reading_file", {{"file", task.object_path.string()}}));
    Stopwatch watch;
    const auto bytes = read_file(task.object_path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto mesh = read_object(*bytes, task.object_path);
    const double read_ms = watch.lap();
    if (!mesh) return of_object(task, mesh.error());
    if (const auto error = unwanted_units(*mesh, task.units_typed)) return of_object(task, *error);
    task.project.object = describe(task.object_path, *bytes);

    status.show(say("status.cutting"));
    auto object = prepare(std::move(*mesh), task.project.design);
    if (!object) return of_object(task, object.error());
    return ReadObject{std::move(*object), read_ms};
}

Result<ReadObject> read_in_pieces(Task& task, TriangleStream stream, std::uint64_t file_size,
                                  StatusLine& status) {
    // No hash: it would take longer than all the rest.
    task.project.object = {task.object_path.filename().string(), file_size, ""};
    auto object = prepare(std::move(stream), task.project.design, status.progress(say("status.measuring")));
    if (!object) return of_object(task, object.error());
    return ReadObject{std::move(*object), 0};
}

/// Whether to try: a file that is too large for memory, and nothing asked that needs the whole object.
bool should_stream(const Task& task) {
    std::error_code error;
    const auto size = std::filesystem::file_size(task.object_path, error);
    return !error && too_large_for_memory(size) && !task.project.design.object.cap &&
           task.project.design.object.clean.none();
}

}  // namespace

Result<ReadObject> read_object_of(Task& task, StatusLine& status) {
    auto read = [&]() -> Result<ReadObject> {
        if (!task.stream.value_or(should_stream(task))) return read_whole(task, status);
        const auto source = open_source(task.object_path);
        if (!source) return tl::unexpected(source.error());
        auto stream = TriangleStream::open(*source, status.progress(say("status.reading")));
        if (stream) return read_in_pieces(task, std::move(*stream), source->size, status);
        // What nobody wanted in pieces may be of a kind that is only read whole, and says itself what is
        // wrong.
        const bool asked = task.stream.has_value();
        if (asked || stream.error().kind != ErrorKind::input) return of_object(task, stream.error());
        return read_whole(task, status);
    }();
    if (read) look_for_change(task, read->object.findings);
    return read;
}

}  // namespace snug::cli

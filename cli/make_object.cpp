#include "cli/make_object.h"

#include <cstddef>
#include <cstdint>
#include <span>
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

/// One of the task's objects, and what is known of it.
struct Reading {
    const Task& task;
    std::size_t index;
    ProjectObject& object;
    const std::filesystem::path& path = task.paths[index];
    Design design = design_for(task.project, index);
};

struct ReadObject {
    Object object;
    double read_ms = 0;
};

tl::unexpected<Error> of_object(const Reading& reading, const Error& error) {
    return fail(error.kind, in_file(reading.path.string(), error.message));
}

void look_for_change(const Reading& reading, std::vector<Finding>& findings) {
    if (reading.task.expected.empty()) return;
    const ObjectFile &was = reading.task.expected[reading.index].file, &is = reading.object.file;
    const bool hashed = !was.sha256.empty() && !is.sha256.empty();
    if (hashed ? was.sha256 == is.sha256 : was.bytes == is.bytes) return;
    findings.push_back({Severity::warning, say("object_changed", {{"name", is.name}})});
}

/// Typed for all objects or for this one.
bool units_typed(const Reading& reading) {
    return reading.task.units_typed ||
           (reading.task.expected.empty() && reading.object.own && reading.object.own->units.has_value());
}

/// A project that is of measurements needs no file beside it.
Result<FileBytes> bytes_of(const Reading& reading) {
    auto bytes = read_file(reading.path);
    if (bytes || reading.task.expected.empty()) return bytes;
    const std::string& shape = reading.task.expected[reading.index].file.shape;
    std::error_code error;
    if (shape.empty() || std::filesystem::exists(reading.path, error)) return bytes;
    const auto text = std::as_bytes(std::span(shape));
    return FileBytes(text.begin(), text.end());
}

Result<ReadObject> read_whole(const Reading& reading, StatusLine& status) {
    status.show(say("status.reading_file", {{"file", reading.path.string()}}));
    Stopwatch watch;
    const auto bytes = bytes_of(reading);
    if (!bytes) return tl::unexpected(bytes.error());
    auto mesh = read_object(*bytes, reading.path);
    const double read_ms = watch.lap();
    if (!mesh) return of_object(reading, mesh.error());
    if (const auto error = unwanted_units(*mesh, units_typed(reading))) return of_object(reading, *error);
    reading.object.file = describe(reading.path, *bytes);

    status.show(say("status.cutting"));
    auto object = prepare(std::move(*mesh), reading.design);
    if (!object) return of_object(reading, object.error());
    return ReadObject{std::move(*object), read_ms};
}

Result<ReadObject> read_in_pieces(const Reading& reading, TriangleStream stream, std::uint64_t file_size,
                                  StatusLine& status) {
    // No hash: it would take longer than all the rest.
    reading.object.file = {reading.path.filename().string(), file_size, ""};
    auto object = prepare(std::move(stream), reading.design, status.progress(say("status.measuring")));
    if (!object) return of_object(reading, object.error());
    return ReadObject{std::move(*object), 0};
}

/// Whether to try: a file that is too large for memory, and nothing asked that needs the whole object.
bool should_stream(const Reading& reading) {
    std::error_code error;
    const auto size = std::filesystem::file_size(reading.path, error);
    return !error && too_large_for_memory(size) && !reading.design.object.cap &&
           reading.design.object.clean.none();
}

Result<ReadObject> read(const Reading& reading, StatusLine& status) {
    if (!reading.task.stream.value_or(should_stream(reading))) return read_whole(reading, status);
    const auto source = open_source(reading.path);
    if (!source) return tl::unexpected(source.error());
    auto stream = TriangleStream::open(*source, status.progress(say("status.reading")));
    if (stream) return read_in_pieces(reading, std::move(*stream), source->size, status);
    // What nobody wanted in pieces may be of a kind that is only read whole, and says itself what is wrong.
    const bool asked = reading.task.stream.has_value();
    if (asked || stream.error().kind != ErrorKind::input) return of_object(reading, stream.error());
    return read_whole(reading, status);
}

/// Different files of one name, which a project could not tell apart.
void look_for_equal_names(const Project& project, std::vector<Object>& objects) {
    for (std::size_t i = 1; i < objects.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const ObjectFile &one = project.objects[i].file, &other = project.objects[k].file;
            if (one.name != other.name || (one.bytes == other.bytes && one.sha256 == other.sha256)) continue;
            objects[i].findings.push_back({Severity::warning, say("object_same_name", {{"name", one.name}})});
            break;
        }
}

}  // namespace

Result<ReadObjects> read_objects_of(Task& task, StatusLine& status) {
    ReadObjects all;
    for (std::size_t i = 0; i < task.paths.size(); ++i) {
        const Reading reading{task, i, task.project.objects[i]};
        auto one = read(reading, status);
        if (!one) return tl::unexpected(one.error());
        one->object.name = task.project.objects[i].file.name;
        look_for_change(reading, one->object.findings);
        all.objects.push_back(std::move(one->object));
        all.read_ms += one->read_ms;
    }
    look_for_equal_names(task.project, all.objects);
    return all;
}

}  // namespace snug::cli

#include <algorithm>
#include <cstddef>
#include <utility>

#include "snug/mesh/left_out.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/object/prepare.h"
#include "snug/object/scale_to_mm.h"
#include "snug/object/streamed_bounds.h"

namespace snug {
namespace {

std::optional<Error> needs_all_at_once(const ObjectOptions& options) {
    if (options.cap) return Error{ErrorKind::usage, say("pieces.cap")};
    if (!options.clean.none()) return Error{ErrorKind::usage, say("pieces.clean")};
    return {};
}

/// As the rounding of a mesh's vertices has it.
Box3d relative_to(Vec3d origin, const Box3d& file) {
    const FileToObject moved{origin, 1};
    const auto rounded = [&](Vec3d p) { return vec_cast<double>(moved(vec_cast<float>(p))); };
    return {rounded(file.min), rounded(file.max)};
}

/// For cubes of the object in its own coordinates, in mm. `box`: before it is scaled.
Box3d room_for_cubes(const Box3d& box, double factor) {
    // Rounding of the box and of the corners differ by less than this.
    const double rounding = box.longest_side() * factor * 1e-5;
    const Vec3d room{rounding, rounding, rounding};
    return {box.min * factor - room, box.max * factor + room};
}

}  // namespace

Result<Object> prepare(TriangleStream stream, const Design& design, const Progress& progress) {
    if (const auto error = needs_all_at_once(design.object)) return tl::unexpected(*error);
    const Vec3d rotation_deg = design.placement.rotation_deg;
    const Rotation rotation = rotation_from_euler(rotation_deg);
    const bool by_length = design.object.longest_mm.has_value();
    FileToObject to_object;
    if (!by_length) to_object.factor = millimetres_per_unit({}, design.object);
    auto bounds = streamed_bounds(stream, to_object, rotation, part_of(progress, 0, 0.5));
    if (!bounds) return tl::unexpected(bounds.error());

    Object object;
    object.options = design.object;
    ReadNotes& read = object.mesh.read;
    read.faces = static_cast<std::size_t>(stream.triangles());
    read.left_out_faces = static_cast<std::size_t>(stream.triangles() - bounds->triangles);
    if (auto error = too_much_left_out(read)) return tl::unexpected(std::move(*error));
    object.read = {static_cast<std::size_t>(stream.vertices().value_or(0)), read.faces - read.left_out_faces};
    const Vec3d origin = origin_for(bounds->file);
    const Box3d box = relative_to(origin, bounds->file);
    const Vec3d size = box.size();
    if (std::max({size.x, size.y, size.z}) <= 0) return fail(ErrorKind::input, say("object.one_point"));
    if (const auto error = implausible_size(size, design)) return tl::unexpected(*error);
    // The first pass could not know the way from the file to the object.
    if (by_length || !(origin == Vec3d{})) {
        to_object = {origin, millimetres_per_unit(size, design.object)};
        bounds = streamed_bounds(stream, to_object, rotation, part_of(progress, 0.5, 1));
        if (!bounds) return tl::unexpected(bounds.error());
    }
    const double factor = to_object.factor;
    object.measure.bounds = {box.min * factor, box.max * factor};
    object.surface =
        StreamedTriangles{std::move(stream), to_object, rotation_deg, bounds->turned,
                          std::make_shared<MetCubes>(room_for_cubes(box, factor), kStandInCubes)};
    return object;
}

void take_stand_in(Object& object) {
    const auto* const streamed = std::get_if<StreamedTriangles>(&object.surface);
    if (streamed == nullptr || !object.mesh.triangles.empty()) return;
    const ReadNotes read = object.mesh.read;
    object.mesh = streamed->cubes->shell();
    object.mesh.read = read;
}

Result<void> mark_stand_in(Object& object, const Progress& progress) {
    if (const auto* const streamed = std::get_if<StreamedTriangles>(&object.surface)) {
        if (auto done = mark_cubes(streamed->stream, streamed->to_object, *streamed->cubes, progress); !done)
            return done;
        take_stand_in(object);
    }
    return {};
}

}  // namespace snug

#include "snug/pack_stream.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "snug/depth/streamed_surface.h"
#include "snug/foam/space_for.h"
#include "snug/mesh/left_out.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/shell.h"
#include "snug/object/read_findings.h"
#include "snug/pack_placed.h"

namespace snug {
namespace {

/// The box and the way from the file's coordinates to the object's; a second pass only where the first could
/// not know that way.
struct Measured {
    FileToObject to_object;
    Box3d box;  ///< of the object as prepare() sees it before it is scaled
    Box3d turned;
    ReadNotes read;
};

/// As the rounding of a mesh's vertices has it.
Box3d relative_to(Vec3d origin, const Box3d& file) {
    const FileToObject moved{origin, 1};
    const auto rounded = [&](Vec3d p) { return vec_cast<double>(moved(vec_cast<float>(p))); };
    return {rounded(file.min), rounded(file.max)};
}

Result<Measured> measured(const TriangleStream& stream, const Design& design, const Progress& progress) {
    if (design.object.cap)
        return fail(ErrorKind::usage, "holes cannot be closed in an object that is read in pieces");
    if (!design.object.clean.none())
        return fail(
            ErrorKind::usage,
            "parts cannot be dropped from an object that is read in pieces, nor can it be cut by a plane");
    const Rotation rotation = rotation_from_euler(design.placement.rotation_deg);
    Measured result;
    const bool by_length = design.object.longest_mm.has_value();
    if (!by_length) result.to_object.factor = millimetres_per_unit({}, design.object);
    auto bounds = streamed_bounds(stream, result.to_object, rotation, part_of(progress, 0, 0.5));
    if (!bounds) return tl::unexpected(bounds.error());
    result.read.faces = static_cast<std::size_t>(stream.triangles());
    result.read.left_out_faces = static_cast<std::size_t>(stream.triangles() - bounds->triangles);
    if (auto error = too_much_left_out(result.read)) return tl::unexpected(std::move(*error));
    const Vec3d origin = origin_for(bounds->file);
    result.box = relative_to(origin, bounds->file);
    const Vec3d size = result.box.size();
    if (std::max({size.x, size.y, size.z}) <= 0)
        return fail(ErrorKind::input, "the object has no size: all its points are one");
    if (const auto error = implausible_size(size, design)) return tl::unexpected(*error);
    if (by_length || !(origin == Vec3d{})) {
        result.to_object = {origin, millimetres_per_unit(size, design.object)};
        bounds = streamed_bounds(stream, result.to_object, rotation, part_of(progress, 0.5, 1));
        if (!bounds) return tl::unexpected(bounds.error());
    }
    result.turned = bounds->turned;
    return result;
}

/// Cubes of the object in its own coordinates, in mm.
MetCubes cubes_for(const Measured& object) {
    const double factor = object.to_object.factor;
    // Rounding of the box and of the corners differ by less than this.
    const double rounding = object.box.longest_side() * factor * 1e-5;
    const Vec3d room{rounding, rounding, rounding};
    return {{object.box.min * factor - room, object.box.max * factor + room}, kStandInCubes};
}

Object object_of(const TriangleStream& stream, const Measured& measured, const MetCubes& cubes) {
    Object object;
    object.kind = ObjectKind::streamed;
    object.read_triangles = measured.read.faces - measured.read.left_out_faces;
    object.read_vertices = static_cast<std::size_t>(stream.vertices().value_or(0));
    object.mesh = cubes.shell();
    object.mesh.read = measured.read;
    const double factor = measured.to_object.factor;
    object.measure.bounds = {measured.box.min * factor, measured.box.max * factor};
    return object;
}

Result<HalfDepths> half_depths(const TriangleStream& stream, const FileToObject& object,
                               const Placement& placement, const DesignSpace& space, Vec3d clearance_mm,
                               bool cut_on_touch, MetCubes* cubes, const Progress& progress) {
    const Reach grown = reach(clearance_mm, cut_on_touch);
    auto depths = depth_map(stream, object, placement, space, grown, cubes, progress);
    if (!depths) return tl::unexpected(depths.error());
    return HalfDepths{std::move(*depths), grown};
}

}  // namespace

Result<Object> stand_in(const TriangleStream& stream, const Design& design, const Progress& progress) {
    const auto object = measured(stream, design, part_of(progress, 0, 0.5));
    if (!object) return tl::unexpected(object.error());
    MetCubes cubes = cubes_for(*object);
    const auto marked = mark_cubes(stream, object->to_object, cubes, part_of(progress, 0.5, 1));
    if (!marked) return tl::unexpected(marked.error());
    return object_of(stream, *object, cubes);
}

Result<StreamedPacking> pack_stream(const TriangleStream& stream, const Design& design,
                                    const Progress& progress) {
    const auto object = measured(stream, design, part_of(progress, 0, 0.4));
    if (!object) return tl::unexpected(object.error());
    const Clearance clearance = design.cut.whole_clearance_mm();
    MetCubes cubes = cubes_for(*object);

    PackSteps steps;
    steps.depths = [&](const Placement& placement, const DesignSpace& space) -> Result<ObjectDepths> {
        const bool touch = design.cut.cut_on_touch, both = clearance.same_in_both();
        auto lower = half_depths(stream, object->to_object, placement, space, clearance.lower, touch, &cubes,
                                 part_of(progress, 0.4, both ? 1 : 0.7));
        if (!lower) return tl::unexpected(lower.error());
        ObjectDepths depths{std::move(*lower), {}};
        if (both) return depths;
        auto upper = half_depths(stream, object->to_object, placement, space, clearance.upper, touch, nullptr,
                                 part_of(progress, 0.7, 1));
        if (!upper) return tl::unexpected(upper.error());
        depths.upper = std::move(*upper);
        return depths;
    };
    steps.find_object_problems = [](const Packing&, const ObjectDepths&, const HalfCuts&,
                                    std::vector<Finding>&) {};
    steps.find_object_notes = [&](const Packing&, std::vector<Finding>& findings) {
        find_read_notes(object->read, 0, design.object.units, findings);
        findings.push_back(
            {Severity::note,
             "streamed",
             "the object was read in pieces: whether it is closed, in how many parts, and what it "
             "has of undercuts is not known; foam may grow inside where it is open",
             {}});
    };
    const bool in_case = design.case_options.inside_mm.has_value();
    const Vec3d offset = design.placement.offset_mm + shift_between_walls(design.space, in_case);
    const Rotation rotation = rotation_from_euler(design.placement.rotation_deg);
    auto packing = pack_placed(place(object->turned, rotation, offset), design, steps);
    if (!packing) return tl::unexpected(packing.error());
    return StreamedPacking{object_of(stream, *object, cubes), std::move(*packing)};
}

}  // namespace snug

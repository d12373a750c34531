#include "snug/formats/threemf_mesh.h"

#include <cmath>
#include <limits>
#include <utility>

#include "snug/formats/text_scan.h"
#include "snug/formats/threemf_extensions.h"

namespace snug {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

Vec3d vertex_of(XmlReader& xml) {
    Vec3d p;
    constexpr std::string_view kNames[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
        if (!to_number(xml.attribute(kNames[axis]).value_or(""), p[axis]))
            p[axis] = std::numeric_limits<double>::quiet_NaN();
    return p;
}

Triangle triangle_of(XmlReader& xml) {
    Triangle triangle;
    constexpr std::string_view kNames[] = {"v1", "v2", "v3"};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        std::int64_t index = -1;
        const bool good = to_number(xml.attribute(kNames[corner]).value_or(""), index);
        triangle[corner] = good && index >= 0 && index < kNone ? static_cast<std::uint32_t>(index) : kNone;
    }
    return triangle;
}

/// Whether a lattice has beams or balls at all; stops behind its end.
Result<bool> has_beams(XmlReader& xml) {
    bool found = false;
    for (int depth = 1; depth > 0;) {
        const auto event = xml.next();
        if (!event) return tl::unexpected(event.error());
        depth += *event == XmlEvent::start ? 1 : -1;
        found = found || (*event == XmlEvent::start && (xml.name() == "beam" || xml.name() == "ball"));
    }
    return found;
}

/// Adds the triangles whose corners are numbers, and the vertices that those use.
void append(const RawMesh& read, ThreeMfObject& object) {
    const auto is_number = [](Vec3d p) {
        return std::fabs(p.x) <= kGreatestCoordinate && std::fabs(p.y) <= kGreatestCoordinate &&
               std::fabs(p.z) <= kGreatestCoordinate;
    };
    std::vector<std::uint32_t> number(read.vertices.size(), kNone);
    RawMesh& mesh = object.mesh;
    for (const Triangle& triangle : read.triangles) {
        bool good = true;
        for (const std::uint32_t v : triangle)
            good = good && v < read.vertices.size() && is_number(read.vertices[v]);
        if (!good) {
            ++object.left_out;
            continue;
        }
        Triangle placed;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::uint32_t& v = number[triangle[corner]];
            if (v == kNone) {
                v = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(read.vertices[triangle[corner]]);
            }
            placed[corner] = v;
        }
        mesh.triangles.push_back(placed);
    }
}

}  // namespace

Result<void> read_3mf_mesh(XmlReader& xml, double mm_per_unit, ThreeMfObject& object) {
    RawMesh read;
    for (int depth = 1; depth > 0;) {
        const auto event = xml.next();
        if (!event) return tl::unexpected(event.error());
        if (*event == XmlEvent::end) {
            --depth;
            continue;
        }
        const bool core = is_3mf_core(xml.space());
        const std::string_view name = core ? xml.name() : std::string_view();
        if (depth == 2 && name == "vertex") {
            read.vertices.push_back(vertex_of(xml) * mm_per_unit);
        } else if (depth == 2 && name == "triangle") {
            read.triangles.push_back(triangle_of(xml));
        } else if (depth == 1 && !core && xml.name() == "beamlattice") {
            const auto beams = has_beams(xml);
            if (!beams) return tl::unexpected(beams.error());
            if (*beams) object.unread = "threemf.beam_lattice";
            continue;
        } else if (depth != 1 || (name != "vertices" && name != "triangles")) {
            if (auto done = xml.skip(); !done) return tl::unexpected(done.error());
            continue;
        }
        ++depth;
    }
    append(read, object);
    return {};
}

}  // namespace snug

#include "snug/object/zone_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/base/text.h"
#include "snug/base/visit_kinds.h"
#include "snug/object/zone_balls.h"

namespace snug {
namespace {

std::array<Vec3d, 3> corners_of(const Mesh& mesh, const Triangle& triangle) {
    std::array<Vec3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = vec_cast<double>(mesh.vertices[triangle[i]]);
    return corners;
}

/// What of a mesh lies in balls or in a part (from 1; 0: none).
class Gathering {
  public:
    Gathering(const Object& object, const ZoneBalls& balls, int part)
        : from_(object.mesh), parts_(object.measure.part_of_triangle), balls_(balls), part_(part) {
        mesh_.origin = from_.origin;
        for (std::size_t i = 0; i < from_.triangles.size(); ++i) add(i);
    }

    Mesh take() { return std::move(mesh_); }
    /// Whether nothing was left out.
    [[nodiscard]] bool all() const { return whole_ == from_.triangles.size(); }

  private:
    void add(std::size_t triangle) {
        const auto corners = corners_of(from_, from_.triangles[triangle]);
        const bool in_part = part_ > 0 && triangle < parts_.size() &&
                             parts_[triangle] + 1 == static_cast<std::uint32_t>(part_);
        if (in_part) {
            add(corners);
            ++whole_;
            return;
        }
        pieces_.clear();
        balls_.add_pieces(corners, pieces_);
        if (pieces_.size() == 1 && pieces_.front() == corners) ++whole_;
        for (const auto& piece : pieces_) add(piece);
    }

    void add(const std::array<Vec3d, 3>& corners) {
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const Vec3d corner : corners) mesh_.vertices.push_back(vec_cast<float>(corner));
        mesh_.triangles.push_back({first, first + 1, first + 2});
    }

    const Mesh& from_;
    const std::vector<std::uint32_t>& parts_;
    const ZoneBalls& balls_;
    int part_;
    std::size_t whole_ = 0;
    std::vector<ZoneBalls::Corners> pieces_;
    Mesh mesh_;
};

tl::unexpected<Error> no_surface(const Object& object) {
    const Vec3d origin = origin_mm(object);
    const Box3d& box = object.measure.bounds;
    const auto place = [](Vec3d p) { return number(p.x, 1) + ", " + number(p.y, 1) + ", " + number(p.z, 1); };
    return fail(ErrorKind::usage,
                say("zone.no_surface", {{"from", place(box.min + origin)}, {"to", place(box.max + origin)}}));
}

/// An object of the same kind, without what is known of it.
Object begun(const Object& object) {
    Object part;
    part.name = object.name;
    return part;
}

Result<Object> of_mesh(const Object& object, const Zone& zone) {
    const std::size_t parts = object.measure.parts.size();
    if (static_cast<std::size_t>(zone.part) > parts)
        return fail(ErrorKind::usage,
                    say("zone.no_part", {{"part", std::to_string(zone.part)}, {"parts", parts}}));
    Gathering gathering(object, ZoneBalls(zone, origin_mm(object)), zone.part);
    Object part = begun(object);
    if (gathering.all() && zone.keep_off_mm > 0) return fail(ErrorKind::usage, say("zone.all"));
    part.mesh = gathering.take();
    if (part.mesh.triangles.empty()) return no_surface(object);
    part.measure.bounds = bounds(part.mesh);
    return part;
}

Result<Object> of_cloud(const Object& object, const PointBalls& points, const Zone& zone) {
    const ZoneBalls balls(zone, origin_mm(object));
    Object part = begun(object);
    PointBalls met;
    met.cloud.origin = points.cloud.origin;
    for (std::size_t i = 0; i < points.cloud.vertices.size(); ++i) {
        const Vec3d p = vec_cast<double>(points.cloud.vertices[i]);
        const double radius = points.radius[i];
        if (!balls.meet(p, radius)) continue;
        met.cloud.vertices.push_back(points.cloud.vertices[i]);
        met.radius.push_back(points.radius[i]);
        part.measure.bounds.include(p - Vec3d{radius, radius, radius});
        part.measure.bounds.include(p + Vec3d{radius, radius, radius});
    }
    if (met.cloud.vertices.empty()) return no_surface(object);
    if (met.cloud.vertices.size() == points.cloud.vertices.size() && zone.keep_off_mm > 0)
        return fail(ErrorKind::usage, say("zone.all"));
    part.surface = std::move(met);
    return part;
}

ZoneBalls::Corners in_object(const FileToObject& to_object, const TriangleStream::Corners& corners) {
    ZoneBalls::Corners own;
    for (std::size_t i = 0; i < 3; ++i) own[i] = vec_cast<double>(to_object(corners[i]));
    return own;
}

/// What a pass over a file finds of a zone, in the object's coordinates.
struct StreamedZone {
    Box3d box;
    std::uint64_t triangles = 0;  ///< of the whole object
    std::uint64_t whole = 0;      ///< of them in the zone, undivided
    void include(const StreamedZone& other) {
        box.include(other.box);
        triangles += other.triangles;
        whole += other.whole;
    }
};

Result<StreamedZone> look_for(const ZoneBalls& balls, const StreamedTriangles& streamed,
                              const Progress& progress) {
    std::vector<StreamedZone> workers(worker_count());
    std::vector<std::vector<ZoneBalls::Corners>> rooms(workers.size());
    const auto done = streamed.stream.pass(
        [&](std::span<const TriangleStream::Corners> piece, std::size_t worker) {
            StreamedZone own;
            own.triangles = piece.size();
            for (const TriangleStream::Corners& each : piece) {
                const auto corners = in_object(streamed.to_object, each);
                auto& pieces = rooms[worker];
                pieces.clear();
                balls.add_pieces(corners, pieces);
                own.whole += pieces.size() == 1 && pieces.front() == corners;
                for (const auto& found : pieces)
                    for (const Vec3d corner : found)
                        own.box.include(vec_cast<double>(vec_cast<float>(corner)));
            }
            workers[worker].include(own);
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    StreamedZone all;
    for (const StreamedZone& own : workers) all.include(own);
    return all;
}

Result<Object> of_stream(const Object& object, const StreamedTriangles& streamed, const Zone& zone,
                         const Progress& progress) {
    const auto balls = std::make_shared<const ZoneBalls>(zone, origin_mm(object));
    const auto found = look_for(*balls, streamed, progress);
    if (!found) return tl::unexpected(found.error());
    if (found->whole == found->triangles && zone.keep_off_mm > 0)
        return fail(ErrorKind::usage, say("zone.all"));
    if (found->box.empty()) return no_surface(object);
    Object part = begun(object);
    part.measure.bounds = found->box;
    const auto divide = [balls, to_object = streamed.to_object](const TriangleStream::Corners& corners,
                                                                std::vector<TriangleStream::Corners>& all) {
        std::vector<ZoneBalls::Corners> pieces;
        balls->add_pieces(in_object(to_object, corners), pieces);
        for (const ZoneBalls::Corners& piece : pieces)
            all.push_back({vec_cast<float>(piece[0]), vec_cast<float>(piece[1]), vec_cast<float>(piece[2])});
    };
    // Its pieces are the object's already.
    part.surface =
        StreamedTriangles{streamed.stream.divided(divide), FileToObject{}, {}, found->box, nullptr};
    return part;
}

/// A stand-in of cubes stands so far off at most (MetCubes::shell).
double stands_off_mm(const Object& object) {
    return object.whole() ? 0 : 3 * object.measure.bounds.longest_side() / kStandInCubes;
}

}  // namespace

Vec3d origin_mm(const Object& object) {
    return visit_kinds(
        object.surface, [&](const OwnMesh&) { return object.mesh.origin; },
        [](const PointBalls& points) { return points.cloud.origin; },
        [](const StreamedTriangles& streamed) {
            return (streamed.stream.origin() + streamed.to_object.origin) * streamed.to_object.factor;
        });
}

Result<Object> zone_surface(const Object& object, const Zone& zone, const Progress& progress) {
    if (zone.part != 0 && !object.whole()) return fail(ErrorKind::usage, say("zone.parts_unknown"));
    return visit_kinds(
        object.surface, [&](const OwnMesh&) { return of_mesh(object, zone); },
        [&](const PointBalls& points) { return of_cloud(object, points, zone); },
        [&](const StreamedTriangles& streamed) { return of_stream(object, streamed, zone, progress); });
}

Mesh zone_of_mesh(const Object& object, const Zone& zone) {
    return Gathering(object, ZoneBalls(zone, origin_mm(object), stands_off_mm(object)), zone.part).take();
}

}  // namespace snug

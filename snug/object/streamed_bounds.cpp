#include "snug/object/streamed_bounds.h"

#include <cstddef>
#include <vector>

#include "snug/base/parallel.h"

namespace snug {
namespace {

bool holds(const Box3d& outer, const Box3d& inner) {
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
           outer.max.x >= inner.max.x && outer.max.y >= inner.max.y && outer.max.z >= inner.max.z;
}

}  // namespace

Result<StreamedBounds> streamed_bounds(const TriangleStream& stream, const FileToObject& object,
                                       const Rotation& rotation, const Progress& progress) {
    std::vector<StreamedBounds> workers(worker_count());
    const auto done = stream.pass(
        [&](TriangleGroup piece, std::size_t worker) {
            StreamedBounds own = workers[worker];
            own.triangles += piece.size();
            for_groups(piece, [&](TriangleGroup group) {
                const Box3d box = box_of(group);
                own.file.include(box);
                if (holds(own.turned, reached(rotation, {}, in_object(object, box)))) return;
                for (const TriangleStream::Corners& corners : group)
                    for (const Vec3f& corner : corners)
                        own.turned.include(rotation(vec_cast<double>(object(corner))));
            });
            workers[worker] = own;
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    StreamedBounds all;
    for (const StreamedBounds& own : workers) {
        all.file.include(own.file);
        all.turned.include(own.turned);
        all.triangles += own.triangles;
    }
    return all;
}

Result<void> mark_cubes(const TriangleStream& stream, const FileToObject& object, MetCubes& cubes,
                        const Progress& progress) {
    return stream.pass(
        [&](TriangleGroup piece, std::size_t) {
            for_groups(piece, [&](TriangleGroup group) {
                mark_group(cubes, object, group, in_object(object, box_of(group)));
            });
        },
        progress);
}

}  // namespace snug

#include "snug/foam/streamed_surface.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/foam/depth_builder.h"

namespace snug {
namespace {

void mark(std::span<const TriangleStream::Corners> piece, const FileToObject& object, MetCubes& cubes) {
    for (const auto& corners : piece)
        cubes.mark({vec_cast<double>(object(corners[0])), vec_cast<double>(object(corners[1])),
                    vec_cast<double>(object(corners[2]))});
}

}  // namespace

Result<StreamedBounds> streamed_bounds(const TriangleStream& stream, const FileToObject& object,
                                       const Rotation& rotation, const Progress& progress) {
    std::vector<StreamedBounds> workers(worker_count());
    const auto done = stream.pass(
        [&](std::span<const TriangleStream::Corners> piece, std::size_t worker) {
            StreamedBounds own = workers[worker];
            for (const auto& corners : piece)
                for (const Vec3f& corner : corners) {
                    own.file.include(vec_cast<double>(corner));
                    own.turned.include(rotation(vec_cast<double>(object(corner))));
                }
            workers[worker] = own;
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    StreamedBounds all;
    for (const StreamedBounds& own : workers) {
        all.file.include(own.file);
        all.turned.include(own.turned);
    }
    return all;
}

Result<DepthMap> depth_map(const TriangleStream& stream, const FileToObject& object,
                           const Placement& placement, const DesignSpace& space, Reach reach, MetCubes* cubes,
                           const Progress& progress) {
    DepthMapBuilder whole(space, reach);
    std::vector<std::unique_ptr<DepthMapBuilder>> workers(worker_count());
    const auto done = stream.pass(
        [&](std::span<const TriangleStream::Corners> piece, std::size_t worker) {
            if (!workers[worker]) workers[worker] = std::make_unique<DepthMapBuilder>(space, reach);
            DepthMapBuilder& own = *workers[worker];
            for (const auto& corners : piece) {
                std::array<Vec3d, 3> placed;
                std::array<VertexCell, 3> cells;
                for (std::size_t i = 0; i < 3; ++i) {
                    placed[i] = placement(object(corners[i]));
                    cells[i] = own.add_vertex(placed[i]);
                }
                const bool one_cell = cells[0].one() && cells[0] == cells[1] && cells[0] == cells[2];
                if (!one_cell) own.add_triangle(placed);
            }
            if (cubes != nullptr) mark(piece, object, *cubes);
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    for (const auto& own : workers)
        if (own) whole.include(*own);
    return whole.take();
}

Result<void> mark_cubes(const TriangleStream& stream, const FileToObject& object, MetCubes& cubes,
                        const Progress& progress) {
    return stream.pass(
        [&](std::span<const TriangleStream::Corners> piece, std::size_t) { mark(piece, object, cubes); },
        progress);
}

}  // namespace snug

#include "snug/fabricate/kit/packing_picture.h"

#include <algorithm>
#include <string>
#include <utility>

#include "snug/drawing/svg.h"
#include "snug/picture/foam_tones.h"
#include "snug/picture/isometric.h"
#include "snug/picture/object_outlines.h"

namespace snug {
namespace {

constexpr Color kObject{240, 242, 245};
constexpr double kShade = 0.1;           // of black, each shade of the object on the last
constexpr double kFinestOutline = 0.15;  // mm on the page
constexpr double kSeam = 0.12;           // mm, closes the seams between neighbours

std::vector<Vec3d> corners(const Face& face) {
    return {face.origin, face.origin + face.across, face.origin + face.across + face.along,
            face.origin + face.along};
}

/// The largest scale at which all points fit into the rectangle, centred.
Page fitted(const std::vector<Vec2d>& points, Vec2d corner, Vec2d size) {
    Vec2d least = points.front(), most = least;
    for (const Vec2d p : points) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
    const Vec2d extent = most - least;
    Page page;
    page.scale = std::min(size.x / std::max(extent.x, 1e-9), size.y / std::max(extent.y, 1e-9));
    page.shift = corner + size * 0.5 - (least + most) * (0.5 * page.scale);
    return page;
}

void draw_piece(PageBuilder& builder, const Page& page, const PieceScene& scene) {
    const FoamTones tones(scene.relief, piece_color(scene.piece));
    for (const Face& face : scene.faces) {
        std::vector<Vec2d> loop;
        for (const Vec3d& point : corners(face)) loop.push_back(page.at(point));
        const Color color = tones.of(face);
        builder.loops({std::move(loop)}, color, Pen{color, kSeam, {}});
    }
}

void draw_outlines(PageBuilder& builder, const Page& page, std::vector<Loop> loops, std::optional<Color> fill,
                   std::optional<Pen> pen) {
    if (loops.empty()) return;
    for (Loop& loop : loops)
        for (Vec2d& point : loop) point = page.at(point);
    builder.loops(std::move(loops), fill, std::move(pen));
}

void draw_object(PageBuilder& builder, const Page& page, const ObjectOutlines& outlines) {
    draw_outlines(builder, page, outlines.visible, kObject, {});
    Color color = kObject;
    for (const std::vector<Loop>& shade : outlines.shades) {
        color = mixed(color, kBlack, kShade);
        draw_outlines(builder, page, shade, color, {});
    }
    draw_outlines(builder, page, outlines.whole, {}, Pen{kInk, 0.2, {0.9, 0.8}});
    draw_outlines(builder, page, outlines.visible, {}, Pen{kInk, 0.35, {}});
}

void draw_numbers(PageBuilder& builder, const Page& page, const OpenedPair& pair,
                  const std::vector<NumberedPlace>& places) {
    constexpr double kRadius = 1.9;  // mm
    for (const NumberedPlace& place : places) {
        const Vec2d at = page.at(pair.lower(place.at));
        builder.circle(at, kRadius, kPaper, Pen{kInk, 0.25, {}});
        builder.text(at + Vec2d{0, 0.95}, std::to_string(place.number),
                     {kSmallText, kInk, true, TextAnchor::middle});
    }
}

}  // namespace

void draw_packing_picture(PageBuilder& builder, Vec2d corner, Vec2d size, PictureParts parts,
                          const Foams& foams, const DesignSpace& space, const PackedLayer& layer) {
    const Mesh& mesh = layer.mesh;
    const OpenedPair pair = opened(space, foams.parting[static_cast<std::size_t>(layer.layer) - 1]);
    const PieceScene lower = piece_scene(foams, foams.at(layer.layer - 1), space, pair, Half::lower);
    parts.lid = parts.lid && foams.has(foams.at(layer.layer));
    const PieceScene lid =
        parts.lid ? piece_scene(foams, foams.at(layer.layer), space, pair, Half::lid) : PieceScene{};
    std::vector<Projected> vertices;
    if (parts.object)
        for (const Vec3f& vertex : mesh.vertices)
            vertices.push_back(project(pair.lower(layer.placement(vertex))));

    std::vector<Vec2d> points;
    for (const PieceScene* piece : {&lower, &lid})
        for (const Face& face : piece->faces)
            for (const Vec3d& point : corners(face)) points.push_back(project(point).at);
    for (const Projected& vertex : vertices) points.push_back(vertex.at);
    if (points.empty()) return;
    const Page page = fitted(points, corner, size);
    if (parts.lid) draw_piece(builder, page, lid);
    draw_piece(builder, page, lower);
    if (parts.object)
        draw_object(builder, page,
                    object_outlines(vertices, mesh.triangles, lower.faces, kFinestOutline / page.scale));
    draw_numbers(builder, page, pair, layer.numbered);
    const Vec3d back_left{lower.relief.right_faces.front(), lower.relief.front_faces.front(), 0};
    const Vec2d hinge = parts.lid ? Vec2d{-2, -3.5} : Vec2d{-1, -1.5};
    builder.text(page.at(back_left) + hinge, say("mark.back"), {kSmallText, kInk, true, TextAnchor::end});
}

}  // namespace snug

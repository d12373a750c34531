#include "snug/picture/preview.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/drawing/svg.h"
#include "snug/formats/mesh_files.h"
#include "snug/picture/foam_drawing.h"
#include "snug/picture/gap_maps.h"
#include "snug/picture/isometric.h"
#include "snug/picture/object_outlines.h"
#include "snug/picture/preview_marks.h"
#include "snug/picture/preview_style.h"
#include "snug/picture/relief.h"

namespace snug {
namespace {

constexpr double kSideMargin = 130;  // px, room for sizes and labels
constexpr double kTopMargin = 60;
constexpr double kBottomMargin = 84;
constexpr double kGreatestHeight = 880;  // px of the drawing itself
constexpr Vec2d kLegendAt{36, 34};
constexpr double kCaptionSize = 20;
constexpr double kCaptionLine = 27;
constexpr std::size_t kCaptionCharacters = 108;  // a line
constexpr std::size_t kCaptionLines = 4;
constexpr double kFinestOutline = 0.35;  // px
constexpr double kFoamStep = 0.1;        // px, to which corners of the foam are rounded
constexpr double kOutlineStep = 0.01;    // px

/// One half, ready to be drawn.
struct HalfScene {
    Relief relief;
    std::vector<Face> faces;
};

HalfScene half_scene(const Foams& foams, const DesignSpace& space, const OpenedPair& pair, Half half) {
    HalfScene scene{relief(foams, space, pair, half), {}};
    scene.faces = visible_faces(scene.relief);
    return scene;
}

/// The part of the drawing that is used, mm.
struct Extent {
    Vec2d min{1e300, 1e300}, max{-1e300, -1e300};
    void include(Vec2d p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    void include(const HalfScene& half) {
        const Relief& relief = half.relief;
        for (const double x : {relief.right_faces.front(), relief.right_faces.back()})
            for (const double y : {relief.front_faces.front(), relief.front_faces.back()})
                include(project({x, y, relief.bottom}).at);
        for (const Face& face : half.faces)
            for (const Vec3d way : {Vec3d{}, face.across, face.along, face.across + face.along})
                include(project(face.origin + way).at);
    }
};

/// The largest scale that fits the width and the greatest height, centred.
Page page_for(const Extent& extent, double& drawing_height) {
    const Vec2d size = extent.max - extent.min;
    Page page;
    page.scale = std::min((kPageWidth - 2 * kSideMargin) / size.x, kGreatestHeight / size.y);
    drawing_height = size.y * page.scale;
    const Vec2d middle = (extent.min + extent.max) * 0.5;
    page.shift = Vec2d{kPageWidth / 2, kTopMargin + drawing_height / 2} - middle * page.scale;
    return page;
}

/// How far the drawing must go down so that neither the legend nor the page's edge meets it.
double room_above(const Page& page, const HalfScene& lower, const HalfScene& lid,
                  std::span<const Projected> vertices, Vec2d back_label) {
    double highest = kLegendAt.y + kLegendSize.y;
    const auto meet = [&](Vec2d point) {
        if (point.x < kLegendAt.x + kLegendSize.x) highest = std::min(highest, point.y);
    };
    for (const HalfScene* half : {&lower, &lid})
        for (const Face& face : half->faces) meet(page.at(face.origin));
    for (const Projected& vertex : vertices) meet(page.at(vertex.at));
    meet(back_label - Vec2d{0, 30});
    return std::max(kLegendAt.y + kLegendSize.y - highest, std::max(0.0, 40 - back_label.y));
}

/// Where there is no foam at all, the table shows.
void draw_table(Canvas& canvas, const Page& page, const Relief& relief) {
    if (relief.fewest_layers() > 0) return;
    const double left = relief.right_faces.front(), right = relief.right_faces.back();
    const double back = relief.front_faces.front(), front = relief.front_faces.back(), z = relief.bottom;
    canvas.loops({{page.at(Vec3d{left, back, z}), page.at(Vec3d{right, back, z}),
                   page.at(Vec3d{right, front, z}), page.at(Vec3d{left, front, z})}},
                 kTableFill, kTableStroke);
}

void draw_half(Canvas& canvas, const Page& page, const HalfScene& scene, Half half) {
    const bool lower = half == Half::lower;
    canvas.layer("marks");
    draw_table(canvas, page, scene.relief);
    canvas.layer(lower ? "lower" : "lid", kFoamStep);
    draw_foam(canvas, page, scene.relief, scene.faces, lower ? kLowerBlue : kUpperOrange);
    canvas.layer("marks");
    draw_half_name(canvas, page, scene.relief, half);
}

std::vector<Projected> projected(const Mesh& mesh, const Placement& placement, const OpenedPair& pair) {
    std::vector<Projected> points;
    points.reserve(mesh.vertices.size());
    for (const Vec3f& vertex : mesh.vertices) points.push_back(project(pair.lower(placement(vertex))));
    return points;
}

void draw_object(Canvas& canvas, const Page& page, const ObjectOutlines& outlines) {
    const auto draw = [&](std::vector<Loop> loops, const std::optional<Fill>& fill,
                          const std::optional<Stroke>& stroke) {
        for (Loop& loop : loops)
            for (Vec2d& point : loop) point = page.at(point);
        canvas.loops(std::move(loops), fill, stroke);
    };
    canvas.layer("object", kOutlineStep);
    draw(outlines.visible, kObjectFill, {});
    for (const std::vector<Loop>& shade : outlines.shades) draw(shade, kObjectShade, {});
    draw(outlines.whole, {}, kObjectHiddenStroke);
    draw(outlines.visible, {}, kObjectStroke);
}

void draw_caption(Canvas& canvas, const std::vector<std::string>& lines, double first_baseline) {
    for (std::size_t i = 0; i < lines.size(); ++i)
        canvas.text({kPageWidth / 2, first_baseline + kCaptionLine * static_cast<double>(i)}, kCaptionSize,
                    anchored(kLegendText, TextAnchor::middle), lines[i]);
}

}  // namespace

Drawing preview_drawing(const Foams& foams, const DesignSpace& space, const Mesh& mesh,
                        const Placement& placement, const std::string& caption, const GapReport* gap,
                        Language language, std::span<const Vec3d> numbered) {
    const OpenedPair pair = opened(space, foams.parting.front());
    const HalfScene lower = half_scene(foams, space, pair, Half::lower);
    const HalfScene lid = half_scene(foams, space, pair, Half::lid);
    const std::vector<Projected> vertices = projected(mesh, placement, pair);

    Extent extent;
    extent.include(lower);
    extent.include(lid);
    for (const Projected& vertex : vertices) extent.include(vertex.at);
    double drawing_height = 0;
    Page page = page_for(extent, drawing_height);
    const double lowered = room_above(page, lower, lid, vertices, back_label_centre(page, space));
    page.shift.y += lowered;
    const ObjectOutlines outlines =
        object_outlines(vertices, mesh.triangles, lower.faces, kFinestOutline / page.scale);

    const std::vector<std::string> lines = wrapped(caption, kCaptionCharacters, kCaptionLines);
    const double drawing_end = kTopMargin + lowered + drawing_height + kBottomMargin;
    // A very long front leaves no room in the lower right corner.
    const bool long_front = space.size().z > 4 * space.size().y;
    const Vec2d axes{long_front ? 70 : kPageWidth - 90, drawing_end - 60};
    const double caption_end = drawing_end + kCaptionLine * static_cast<double>(lines.size()) + 24;

    Canvas canvas(caption, language);
    draw_half(canvas, page, lid, Half::lid);
    draw_hinge(canvas, page, space);
    draw_half(canvas, page, lower, Half::lower);
    draw_sizes(canvas, page, lid.relief, Half::lid, space);
    draw_sizes(canvas, page, lower.relief, Half::lower, space);
    draw_back_label(canvas, page, space);
    draw_object(canvas, page, outlines);
    draw_numbers(canvas, page, pair, numbered);
    canvas.layer("legend");
    draw_legend(canvas, kLegendAt, space, !outlines.whole.empty(), language);
    draw_axes(canvas, axes);
    draw_caption(canvas, lines, drawing_end + 18);
    const double height = caption_end + (gap ? draw_gap_maps(canvas, *gap, space, caption_end, language) : 0);
    return canvas.finish({kPageWidth, height});
}

std::string preview_svg(const Foams& foams, const DesignSpace& space, const Mesh& mesh,
                        const Placement& placement, const std::string& caption, const GapReport* gap,
                        Language language, std::span<const Vec3d> numbered) {
    return drawing_svg(preview_drawing(foams, space, mesh, placement, caption, gap, language, numbered));
}

}  // namespace snug

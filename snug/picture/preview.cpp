#include "snug/picture/preview.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/drawing/page_builder.h"
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

/// The part of the drawing that is used, mm.
struct Extent {
    Vec2d min{1e300, 1e300}, max{-1e300, -1e300};
    void include(Vec2d p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    void include(const PieceScene& half) {
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

/// A layer between the pieces around it.
struct Book {
    OpenedPair pair;
    PieceScene lower;
    std::optional<PieceScene> lid;  ///< none over a tray
    std::vector<Projected> vertices;
    Page page;
    double height = 0;  ///< px of the drawing
};

/// Where there is no foam at all, the table shows.
void draw_table(Canvas& canvas, const Page& page, const Relief& relief) {
    if (relief.fewest_layers() > 0) return;
    const double left = relief.right_faces.front(), right = relief.right_faces.back();
    const double back = relief.front_faces.front(), front = relief.front_faces.back(), z = relief.bottom;
    canvas.loops({{page.at(Vec3d{left, back, z}), page.at(Vec3d{right, back, z}),
                   page.at(Vec3d{right, front, z}), page.at(Vec3d{left, front, z})}},
                 kTableFill, kTableStroke);
}

void draw_half(Canvas& canvas, const Page& page, const PieceScene& scene, Half half) {
    const std::string name = scene.piece.middle()  ? "middle-" + std::to_string(scene.piece.index)
                             : half == Half::lower ? "lower"
                                                   : "lid";
    canvas.layer("marks");
    draw_table(canvas, page, scene.relief);
    canvas.layer(name, kFoamStep);
    draw_foam(canvas, page, scene.relief, scene.faces, piece_color(scene.piece));
    canvas.layer("marks");
    draw_half_name(canvas, page, scene.relief, half, scene.piece);
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

Book opened_book(const Foams& foams, const DesignSpace& space, int layer, const PreviewLayer& what) {
    const OpenedPair pair = opened(space, foams.parting[static_cast<std::size_t>(layer)]);
    Book book{pair, piece_scene(foams, foams.at(layer), space, pair, Half::lower),
              {},   projected(what.mesh, what.placement, pair),
              {},   0};
    const Piece above = foams.at(layer + 1);
    if (foams.has(above)) book.lid = piece_scene(foams, above, space, pair, Half::lid);
    Extent extent;
    extent.include(book.lower);
    if (book.lid) extent.include(*book.lid);
    for (const Projected& vertex : book.vertices) extent.include(vertex.at);
    book.page = page_for(extent, book.height);
    return book;
}

/// How far the first book must go down so that neither the legend nor the page's edge meets it.
double room_above(const Book& book, Vec2d back_label, int pieces) {
    const Vec2d legend = kLegendAt + legend_size(pieces);
    double highest = legend.y;
    const auto meet = [&](Vec2d point) {
        if (point.x < legend.x) highest = std::min(highest, point.y);
    };
    for (const Face& face : book.lower.faces) meet(book.page.at(face.origin));
    if (book.lid)
        for (const Face& face : book.lid->faces) meet(book.page.at(face.origin));
    for (const Projected& vertex : book.vertices) meet(book.page.at(vertex.at));
    meet(back_label - Vec2d{0, 30});
    return std::max(legend.y - highest, std::max(0.0, 40 - back_label.y));
}

void draw_book(Canvas& canvas, const Book& book, const DesignSpace& space,
               std::span<const NumberedPlace> numbered, const ObjectOutlines& outlines) {
    const Page& page = book.page;
    if (book.lid) {
        draw_half(canvas, page, *book.lid, Half::lid);
        draw_hinge(canvas, page, space);
    }
    draw_half(canvas, page, book.lower, Half::lower);
    if (book.lid) draw_sizes(canvas, page, book.lid->relief, Half::lid, space);
    draw_sizes(canvas, page, book.lower.relief, Half::lower, space);
    draw_back_label(canvas, page, space);
    draw_object(canvas, page, outlines);
    draw_numbers(canvas, page, book.pair, numbered);
}

/// About where its drawing begins.
void shrink(Book& book, double share) {
    const Vec2d middle{kPageWidth / 2, kTopMargin + book.height / 2};
    const Vec2d from_middle = middle - book.page.shift;
    book.height *= share;
    book.page.shift = Vec2d{kPageWidth / 2, kTopMargin + book.height / 2} - from_middle * share;
    book.page.scale *= share;
}

/// All books at one scale, one below the other. Gives where they end.
double lay_out(std::vector<Book>& books, const DesignSpace& space) {
    double scale = books.front().page.scale;
    for (const Book& book : books) scale = std::min(scale, book.page.scale);
    double top = 0;
    for (Book& book : books) {
        if (book.page.scale != scale) shrink(book, scale / book.page.scale);
        book.page.shift.y += top;
        double lowered = 0;
        if (&book == &books.front())
            lowered =
                room_above(book, back_label_centre(book.page, space), static_cast<int>(books.size()) + 1);
        book.page.shift.y += lowered;
        top += kTopMargin + lowered + book.height + kBottomMargin;
    }
    return top;
}

}  // namespace

Drawing preview_drawing(const Foams& foams, const DesignSpace& space, std::span<const PreviewLayer> layers,
                        const std::string& caption, Language language, const PreviewFalls* falls) {
    std::vector<Book> books;
    for (std::size_t i = 0; i < layers.size(); ++i)
        books.push_back(opened_book(foams, space, static_cast<int>(i), layers[i]));
    const double drawing_end = lay_out(books, space);
    const std::vector<std::string> lines = wrapped(caption, kCaptionCharacters, kCaptionLines);
    // A very long front leaves no room in the lower right corner.
    const bool long_front = space.size().z > 4 * space.size().y;
    const Vec2d axes{long_front ? 70 : kPageWidth - 90, drawing_end - 60};
    double end = drawing_end + kCaptionLine * static_cast<double>(lines.size()) + 24;

    Canvas canvas(caption, language);
    bool with_object = false;
    for (std::size_t i = 0; i < books.size(); ++i) {
        const Book& book = books[i];
        const ObjectOutlines outlines = object_outlines(book.vertices, layers[i].mesh.triangles,
                                                        book.lower.faces, kFinestOutline / book.page.scale);
        with_object = with_object || !outlines.whole.empty();
        draw_book(canvas, book, space, layers[i].numbered, outlines);
    }
    canvas.layer("legend");
    draw_legend(canvas, kLegendAt, space, foams, with_object, language);
    draw_axes(canvas, axes);
    draw_caption(canvas, lines, drawing_end + 18);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (!layers[i].gap) continue;
        const auto layer = static_cast<int>(i);
        end += draw_gap_maps(canvas, *layers[i].gap,
                             {foams.at(layer), foams.at(layer + 1), books[i].lid.has_value()}, space, end,
                             language);
    }
    if (falls) {
        std::vector<FallingMesh> meshes;
        for (const PreviewLayer& layer : layers) meshes.push_back({layer.mesh, layer.placement});
        end += draw_falls(canvas, fall_pictures(foams, space, meshes), *falls, end, language);
    }
    return canvas.finish({kPageWidth, end});
}

std::string preview_svg(const Foams& foams, const DesignSpace& space, std::span<const PreviewLayer> layers,
                        const std::string& caption, Language language, const PreviewFalls* falls) {
    return drawing_svg(preview_drawing(foams, space, layers, caption, language, falls));
}

std::string preview_svg(const Foams& foams, const DesignSpace& space, const Mesh& mesh,
                        const Placement& placement, const std::string& caption, const GapReport* gap,
                        Language language) {
    const PreviewLayer layer{mesh, placement, gap};
    return preview_svg(foams, space, std::span(&layer, 1), caption, language);
}

}  // namespace snug

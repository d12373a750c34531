#include "snug/picture/preview_marks.h"

#include <algorithm>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/picture/preview_style.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr double kDimensionOffset = 26;  // px from the edge to its dimension line
constexpr double kHingeOvershoot = 46;   // px
constexpr double kLeastWallText = 15;    // px
constexpr double kTableText = 22;        // px
constexpr double kLegendLine = 29;       // px

/// The scene direction in the drawing; its length is the foreshortening.
Vec2d seen(Vec3d direction) {
    return project(direction).at;
}
Vec2d unit(Vec2d v) {
    return v * (1 / length(v));
}

/// Text that lies in a plane of the scene: read along `reading`, its feet towards `down` (unit vectors).
/// Centred on `centre`.
void flat_text(Canvas& canvas, Vec2d centre, Vec3d reading, Vec3d down, double size, const Lettering& look,
               std::string_view words) {
    canvas.text_in_plane(centre, {seen(reading), seen(down)}, size, look, std::string(words));
}

/// A dimension line beside the edge from a to b, `outward` from it on the page (unit vector).
void dimension_line(Canvas& canvas, Vec2d a, Vec2d b, Vec2d outward) {
    const Vec2d near = outward * 6, far = outward * kDimensionOffset,
                beyond = outward * (kDimensionOffset + 5);
    canvas.line(a + near, a + beyond, kDimensionStroke);
    canvas.line(b + near, b + beyond, kDimensionStroke);
    canvas.line(a + far, b + far, kDimensionStroke);
    const Vec2d along = unit(b - a);
    for (const Vec2d end : {a + far, b + far}) {
        const Vec2d tick = (along + outward) * 4;
        canvas.line(end - tick, end + tick, kDimensionStroke);
    }
}

std::string millimetre_text(double mm) {
    return number(mm, 1) + " mm";
}

/// A dimension that lies on the table with its line.
void flat_dimension(Canvas& canvas, const Page& page, Vec3d from, Vec3d to, Vec3d reading, Vec3d outward,
                    double mm) {
    const Vec2d a = page.at(from), b = page.at(to), out = unit(seen(outward));
    dimension_line(canvas, a, b, out);
    flat_text(canvas, (a + b) * 0.5 + out * (kDimensionOffset + 17), reading, outward, 21, kDimensionText,
              millimetre_text(mm));
}

void upright_dimension(Canvas& canvas, const Page& page, Vec3d bottom, double height, double side) {
    const Vec2d a = page.at(bottom), b = page.at(bottom + Vec3d{0, 0, height});
    const Vec2d at = (a + b) * 0.5 + Vec2d{side * (kDimensionOffset + 11), 5.5};
    dimension_line(canvas, a, b, {side, 0});
    canvas.text(at, 16, anchored(kDimensionText, side < 0 ? TextAnchor::end : TextAnchor::start),
                millimetre_text(height));
}

/// The height that all of the named wall has: the lower half's front wall or the lid's right one.
int outer_wall_layers(const Relief& relief, Half half) {
    const Grid<int>& layers = relief.layers;
    int least = layers(layers.ny() - 1, layers.nz() - 1);
    for (int row = 0; row < layers.ny() && half == Half::lid; ++row)
        least = std::min(least, layers(row, layers.nz() - 1));
    for (int column = 0; column < layers.nz() && half == Half::lower; ++column)
        least = std::min(least, layers(layers.ny() - 1, column));
    return least;
}

Lettering table_text(Piece piece) {
    if (piece.middle()) return {piece_ink(piece), true, 1};
    return piece.highest() ? kLidTableText : kLowerTableText;
}

}  // namespace

void draw_half_name(Canvas& canvas, const Page& page, const Relief& relief, Half half, Piece piece) {
    const std::string name = piece_title(piece);
    const bool lower = half == Half::lower;
    const double left = relief.right_faces.front(), right = relief.right_faces.back();
    const double back = relief.front_faces.front(), front = relief.front_faces.back();
    const Vec3d reading = lower ? Vec3d{1, 0, 0} : Vec3d{0, -1, 0};
    const double wide = (lower ? right - left : front - back) * page.scale;
    const double wall_mm = outer_wall_layers(relief, half) * relief.layer_mm;
    const double high = wall_mm * page.scale;
    // MIDDLE has the widest letters, and most of them.
    const double letters = static_cast<double>(name.size()) * (name.size() > 5 ? 1.2 : 1);
    const double size = std::min({high * 0.42, wide * 0.8 / (0.75 * letters), 46.0});
    const Vec3d foot = lower ? Vec3d{(left + right) / 2, front, relief.bottom}
                             : Vec3d{right, (back + front) / 2, relief.bottom};
    if (size >= kLeastWallText)
        return flat_text(canvas, page.at(foot + Vec3d{0, 0, wall_mm / 2}), reading, {0, 0, -1}, size,
                         kWallText, name);
    const Vec3d outward = lower ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    const double away = kTableText + (lower ? kDimensionOffset + 26 : 0);
    flat_text(canvas, page.at(foot) + unit(seen(outward)) * away, reading, outward, kTableText,
              table_text(piece), name);
}

void draw_sizes(Canvas& canvas, const Page& page, const Relief& relief, Half half, const DesignSpace& space) {
    const double left = relief.right_faces.front(), right = relief.right_faces.back();
    const double back = relief.front_faces.front(), front = relief.front_faces.back();
    const double floor = relief.bottom;
    const Grid<int>& layers = relief.layers;
    if (half == Half::lid) {
        const double height = layers(0, layers.nz() - 1) * relief.layer_mm;
        if (height > 0) upright_dimension(canvas, page, {right, back, floor}, height, 1);
        return;
    }
    flat_dimension(canvas, page, {left, front, floor}, {right, front, floor}, {1, 0, 0}, {0, 1, 0},
                   space.size().z);
    flat_dimension(canvas, page, {right, front, floor}, {right, back, floor}, {0, -1, 0}, {1, 0, 0},
                   space.size().y);
    const double height = layers(layers.ny() - 1, 0) * relief.layer_mm;
    if (height > 0) upright_dimension(canvas, page, {left, front, floor}, height, -1);
}

void draw_hinge(Canvas& canvas, const Page& page, const DesignSpace& space) {
    const Vec2d along = unit(seen({1, 0, 0}));
    const double half = space.size().z / 2;
    canvas.line(page.at(Vec3d{-half, 0, 0}) - along * kHingeOvershoot, page.at(Vec3d{half, 0, 0}) + along * 8,
                kHingeStroke);
}

Vec2d back_label_centre(const Page& page, const DesignSpace& space) {
    return page.at(Vec3d{-space.size().z / 2, 0, 0}) - unit(seen({1, 0, 0})) * (kHingeOvershoot + 46);
}

void draw_back_label(Canvas& canvas, const Page& page, const DesignSpace& space) {
    flat_text(canvas, back_label_centre(page, space), {1, 0, 0}, {0, 1, 0}, 22, kBackText, "BACK");
}

void draw_numbers(Canvas& canvas, const Page& page, const OpenedPair& pair,
                  std::span<const NumberedPlace> places) {
    constexpr double kRadius = 11, kBaseline = 5;  // px
    if (!places.empty()) canvas.layer("numbers");
    for (const NumberedPlace& place : places) {
        const Vec2d at = page.at(pair.lower(place.at));
        canvas.circle(at, kRadius, {kWhite, .92}, {kObjectInk, 1.6});
        canvas.text(at + Vec2d{0, kBaseline}, 14, anchored(kBackText, TextAnchor::middle),
                    std::to_string(place.number));
    }
}

void draw_axes(Canvas& canvas, Vec2d at) {
    struct Axis {
        Vec3d direction;
        const char* name;
    };
    for (const Axis& axis : {Axis{{0, 0, 1}, "x"}, Axis{{0, 1, 0}, "y"}, Axis{{1, 0, 0}, "z"}}) {
        const Vec2d way = seen(axis.direction) * 46, tip = at + way, along = unit(way);
        const Vec2d across{-along.y, along.x};
        canvas.line(at, tip, kAxisStroke);
        canvas.line(tip, tip - along * 7 + across * 3.5, kAxisStroke);
        canvas.line(tip, tip - along * 7 - across * 3.5, kAxisStroke);
        canvas.text(tip + along * 11 + Vec2d{0, 5}, 15, kAxisText, axis.name);
    }
}

Vec2d legend_size(int pieces) {
    return {380, 130 + kLegendLine * (pieces - 2)};
}

void draw_legend(Canvas& canvas, Vec2d at, const DesignSpace& space, const Foams& foams, bool with_object,
                 Language language) {
    const auto entry = [&](Color swatch, const std::optional<Stroke>& edge, const Message& name,
                           const Message& explanation) {
        canvas.rectangle(at, {26, 17}, Fill{swatch}, edge, 3);
        canvas.text(at + Vec2d{38, 14}, 17, kLegendText, text(explanation, language), text(name, language));
        at.y += kLegendLine;
    };
    entry(kLowerBlue, {}, say("mark.lower"), say("preview.lower"));
    for (const Piece piece : foams.all())
        if (piece.middle()) entry(kMiddleGreen, {}, marked_piece(piece), say("preview.middle"));
    if (!foams.open()) entry(kUpperOrange, {}, say("mark.lid"), say("preview.lid"));
    if (with_object) entry(kWhite, kObjectSwatchStroke, say("preview.object"), say("preview.object_lies"));
    const Vec3d size = outer_size(foams, space);
    canvas.text(
        at + Vec2d{0, 15}, 15, kAxisText,
        text(say(foams.open() ? "preview.tray" : "preview.closed", {{"size", dimensions(size)}}), language));
}

}  // namespace snug

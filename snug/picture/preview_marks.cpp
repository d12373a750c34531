#include "snug/picture/preview_marks.h"

#include <algorithm>

#include "snug/base/text.h"
#include "snug/picture/preview_style.h"

namespace snug {
namespace {

constexpr double kDimensionOffset = 26;  // px from the edge to its dimension line
constexpr double kHingeOvershoot = 46;   // px
constexpr double kLeastWallText = 15;    // px
constexpr double kTableText = 22;        // px

std::string xy(const char* x_name, const char* y_name, Vec2d p) {
    return std::string(" ") + x_name + "=\"" + number(p.x) + "\" " + y_name + "=\"" + number(p.y) + "\"";
}

std::string line(Vec2d a, Vec2d b, std::string_view style) {
    return "<line" + xy("x1", "y1", a) + xy("x2", "y2", b) + " " + std::string(style) + "/>\n";
}

/// The scene direction in the drawing; its length is the foreshortening.
Vec2d seen(Vec3d direction) {
    return project(direction).at;
}
Vec2d unit(Vec2d v) {
    return v * (1 / length(v));
}

/// Text that lies in a plane of the scene: read along `reading`, its feet towards `down` (unit vectors).
/// Centred on `centre`.
std::string flat_text(Vec2d centre, Vec3d reading, Vec3d down, double size, std::string_view style,
                      std::string_view words) {
    const Vec2d a = seen(reading), b = seen(down);
    return "<text transform=\"matrix(" + number(a.x, 5) + " " + number(a.y, 5) + " " + number(b.x, 5) + " " +
           number(b.y, 5) + " " + number(centre.x) + " " + number(centre.y) + ")\" y=\"" +
           number(size * 0.36) + "\" font-size=\"" + number(size) + "\" text-anchor=\"middle\" " +
           std::string(style) + ">" + std::string(words) + "</text>\n";
}

std::string plain_text(Vec2d at, double size, std::string_view style, std::string_view words) {
    return "<text" + xy("x", "y", at) + " font-size=\"" + number(size) + "\" " + std::string(style) + ">" +
           std::string(words) + "</text>\n";
}

/// A dimension line beside the edge from a to b, `outward` from it on the page (unit vector).
std::string dimension_line(Vec2d a, Vec2d b, Vec2d outward) {
    const Vec2d near = outward * 6, far = outward * kDimensionOffset,
                beyond = outward * (kDimensionOffset + 5);
    std::string text = line(a + near, a + beyond, kDimensionStroke) +
                       line(b + near, b + beyond, kDimensionStroke) +
                       line(a + far, b + far, kDimensionStroke);
    const Vec2d along = unit(b - a);
    for (const Vec2d end : {a + far, b + far}) {
        const Vec2d tick = (along + outward) * 4;
        text += line(end - tick, end + tick, kDimensionStroke);
    }
    return text;
}

std::string millimetre_text(double mm) {
    return number(mm, 1) + " mm";
}

/// A dimension that lies on the table with its line.
std::string flat_dimension(const Page& page, Vec3d from, Vec3d to, Vec3d reading, Vec3d outward, double mm) {
    const Vec2d a = page.at(from), b = page.at(to), out = unit(seen(outward));
    return dimension_line(a, b, out) + flat_text((a + b) * 0.5 + out * (kDimensionOffset + 17), reading,
                                                 outward, 21, kDimensionText, millimetre_text(mm));
}

std::string upright_dimension(const Page& page, Vec3d bottom, double height, double side) {
    const Vec2d a = page.at(bottom), b = page.at(bottom + Vec3d{0, 0, height});
    const Vec2d at = (a + b) * 0.5 + Vec2d{side * (kDimensionOffset + 11), 5.5};
    return dimension_line(a, b, {side, 0}) +
           plain_text(at, 16, std::string(kDimensionText) + (side < 0 ? " text-anchor=\"end\"" : ""),
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

}  // namespace

std::string half_name(const Page& page, const Relief& relief, Half half) {
    const bool lower = half == Half::lower;
    const std::string_view name = lower ? "LOWER" : "LID";
    const double left = relief.right_faces.front(), right = relief.right_faces.back();
    const double back = relief.front_faces.front(), front = relief.front_faces.back();
    const Vec3d reading = lower ? Vec3d{1, 0, 0} : Vec3d{0, -1, 0};
    const double wide = (lower ? right - left : front - back) * page.scale;
    const double wall_mm = outer_wall_layers(relief, half) * relief.layer_mm;
    const double high = wall_mm * page.scale;
    const double letters = static_cast<double>(name.size());
    const double size = std::min({high * 0.42, wide * 0.8 / (0.75 * letters), 46.0});
    const Vec3d foot = lower ? Vec3d{(left + right) / 2, front, relief.bottom}
                             : Vec3d{right, (back + front) / 2, relief.bottom};
    if (size >= kLeastWallText)
        return flat_text(page.at(foot + Vec3d{0, 0, wall_mm / 2}), reading, {0, 0, -1}, size, kWallText,
                         name);
    const Vec3d outward = lower ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    const double away = kTableText + (lower ? kDimensionOffset + 26 : 0);
    return flat_text(page.at(foot) + unit(seen(outward)) * away, reading, outward, kTableText,
                     lower ? kLowerTableText : kLidTableText, name);
}

std::string size_marks(const Page& page, const Relief& relief, Half half, const DesignSpace& space) {
    const double left = relief.right_faces.front(), right = relief.right_faces.back();
    const double back = relief.front_faces.front(), front = relief.front_faces.back();
    const double floor = relief.bottom;
    const Grid<int>& layers = relief.layers;
    if (half == Half::lid) {
        const double height = layers(0, layers.nz() - 1) * relief.layer_mm;
        return height > 0 ? upright_dimension(page, {right, back, floor}, height, 1) : "";
    }
    std::string text = flat_dimension(page, {left, front, floor}, {right, front, floor}, {1, 0, 0}, {0, 1, 0},
                                      space.size().z) +
                       flat_dimension(page, {right, front, floor}, {right, back, floor}, {0, -1, 0},
                                      {1, 0, 0}, space.size().y);
    const double height = layers(layers.ny() - 1, 0) * relief.layer_mm;
    return height > 0 ? text + upright_dimension(page, {left, front, floor}, height, -1) : text;
}

std::string hinge_line(const Page& page, const DesignSpace& space) {
    const Vec2d along = unit(seen({1, 0, 0}));
    const double half = space.size().z / 2;
    return line(page.at(Vec3d{-half, 0, 0}) - along * kHingeOvershoot, page.at(Vec3d{half, 0, 0}) + along * 8,
                kHingeStroke);
}

Vec2d back_label_centre(const Page& page, const DesignSpace& space) {
    return page.at(Vec3d{-space.size().z / 2, 0, 0}) - unit(seen({1, 0, 0})) * (kHingeOvershoot + 46);
}

std::string back_label(const Page& page, const DesignSpace& space) {
    return flat_text(back_label_centre(page, space), {1, 0, 0}, {0, 1, 0}, 22, kBackText, "BACK");
}

std::string axis_hint(Vec2d at) {
    struct Axis {
        Vec3d direction;
        const char* name;
    };
    std::string text;
    for (const Axis& axis : {Axis{{0, 0, 1}, "x"}, Axis{{0, 1, 0}, "y"}, Axis{{1, 0, 0}, "z"}}) {
        const Vec2d way = seen(axis.direction) * 46, tip = at + way, along = unit(way);
        const Vec2d across{-along.y, along.x};
        text += line(at, tip, kAxisStroke) + line(tip, tip - along * 7 + across * 3.5, kAxisStroke) +
                line(tip, tip - along * 7 - across * 3.5, kAxisStroke) +
                plain_text(tip + along * 11 + Vec2d{0, 5}, 15, kAxisText, axis.name);
    }
    return text;
}

std::string legend(Vec2d at, const DesignSpace& space, bool with_object, Language language) {
    std::string drawn;
    const auto entry = [&](std::string_view swatch, const Message& name, const Message& explanation) {
        drawn += "<rect" + xy("x", "y", at) + " width=\"26\" height=\"17\" rx=\"3\" " + std::string(swatch) +
                 "/>\n" +
                 plain_text(at + Vec2d{38, 14}, 17, kLegendText,
                            "<tspan font-weight=\"600\">" + text(name, language) + "</tspan> " +
                                text(explanation, language));
        at.y += 29;
    };
    entry("fill=\"" + hex(kLowerBlue) + "\"", say("mark.lower"), say("preview.lower"));
    entry("fill=\"" + hex(kUpperOrange) + "\"", say("mark.lid"), say("preview.lid"));
    if (with_object) entry(kObjectSwatch, say("preview.object"), say("preview.object_lies"));
    const Vec3d size = space.size();
    return drawn + plain_text(at + Vec2d{0, 15}, 15, kAxisText,
                              text(say("preview.closed", {{"size", dimensions(size)}}), language));
}

}  // namespace snug

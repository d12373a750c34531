#include "snug/picture/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "snug/base/rotation.h"

namespace snug {
namespace {

constexpr double kMiddleOfCapitals = 0.36;  // of the letters' size, above the baseline
constexpr int kCornerSteps = 4;             // of a rounded corner

Vec2d mm(Vec2d px) {
    return px * kMmPerPx;
}

std::optional<Pen> pen(const std::optional<Stroke>& stroke) {
    if (!stroke) return {};
    Pen pen{stroke->color,       stroke->px * kMmPerPx, {},
            stroke->round_joins, stroke->round_ends,    stroke->opacity};
    for (const double dash : stroke->dashes_px) pen.dashes_mm.push_back(dash * kMmPerPx);
    return pen;
}

std::vector<Vec2d> rounded(Vec2d corner, Vec2d size, double radius) {
    if (radius == 0) return {corner, corner + Vec2d{size.x, 0}, corner + size, corner + Vec2d{0, size.y}};
    std::vector<Vec2d> outline;
    for (int i = 0; i < 4; ++i) {
        const Vec2d centre =
            corner + Vec2d{i == 1 || i == 2 ? size.x - radius : radius, i >= 2 ? size.y - radius : radius};
        for (int step = 0; step <= kCornerSteps; ++step) {
            const SineCosine turn = sine_cosine_degrees(180 + 90 * i + 90.0 * step / kCornerSteps);
            outline.push_back(centre + Vec2d{turn.cosine, turn.sine} * radius);
        }
    }
    return outline;
}

}  // namespace

Canvas::Canvas(std::string title, Language language) {
    drawing_.title = std::move(title);
    drawing_.language = language;
    layer("paper");
    rectangle({}, {}, Fill{{255, 255, 255}});  // its size is known when all is drawn
}

void Canvas::layer(const std::string& name, double step_px) {
    auto& layers = drawing_.layers;
    const auto found = std::find_if(layers.begin(), layers.end(),
                                    [&](const DrawingLayer& each) { return each.name == name; });
    layer_ = static_cast<int>(found - layers.begin());
    if (found == layers.end()) layers.push_back({name, {}, step_px * kMmPerPx});
}

void Canvas::add(PathItem path) {
    for (std::vector<Vec2d>& line : path.lines)
        for (Vec2d& point : line) point = mm(point);
    drawing_.items.push_back({layer_, std::move(path)});
}

void Canvas::line(Vec2d from, Vec2d to, const Stroke& stroke) {
    add({{{from, to}}, false, {}, pen(stroke)});
}

void Canvas::loops(std::vector<std::vector<Vec2d>> loops, const std::optional<Fill>& fill,
                   const std::optional<Stroke>& stroke) {
    if (loops.empty()) return;
    PathItem path{std::move(loops), true, {}, pen(stroke)};
    if (fill) {
        path.fill = fill->color;
        path.fill_opacity = fill->opacity;
    }
    add(std::move(path));
}

void Canvas::rectangle(Vec2d corner, Vec2d size, const std::optional<Fill>& fill,
                       const std::optional<Stroke>& stroke, double corner_radius) {
    loops({rounded(corner, size, corner_radius)}, fill, stroke);
}

void Canvas::circle(Vec2d centre, double radius, const Fill& fill, const Stroke& stroke) {
    drawing_.items.push_back(
        {layer_, CircleItem{mm(centre), radius * kMmPerPx, fill.color, pen(stroke), fill.opacity}});
}

void Canvas::text(Vec2d at, double size, const Lettering& look, std::string words, std::string lead) {
    TextItem item{mm(at), std::move(words), size * kMmPerPx, look.anchor, 0, look.bold, look.color};
    item.lead = std::move(lead);
    item.spacing_mm = look.spacing_px * kMmPerPx;
    item.opacity = look.opacity;
    item.halo = pen(look.halo);
    drawing_.items.push_back({layer_, std::move(item)});
}

void Canvas::text_in_plane(Vec2d centre, const TextPlane& plane, double size, Lettering look,
                           std::string words) {
    look.anchor = TextAnchor::middle;
    text(centre + plane.down * (size * kMiddleOfCapitals), size, look, std::move(words));
    std::get<TextItem>(drawing_.items.back().what).plane = plane;
}

PathItem* Canvas::going_on(bool closed, Color color) {
    if (drawing_.items.empty() || drawing_.items.back().layer != layer_) return nullptr;
    auto* path = std::get_if<PathItem>(&drawing_.items.back().what);
    return path && path->closed == closed && path->pen && path->pen->color == color ? path : nullptr;
}

void Canvas::facet(Color color, const std::vector<Vec2d>& corners, double edge_px) {
    PathItem* path = going_on(true, color);
    if (!path) {
        add({{}, true, color, pen(Stroke{color, edge_px, {}, 1, true}), FillRule::nonzero});
        path = &std::get<PathItem>(drawing_.items.back().what);
    }
    std::vector<Vec2d>& loop = path->lines.emplace_back(corners);
    for (Vec2d& point : loop) point = mm(point);
}

void Canvas::facet_line(Color color, Vec2d from, Vec2d to, double px) {
    PathItem* path = going_on(false, color);
    if (!path) {
        add({{}, false, {}, pen(Stroke{color, px, {}, 1, true})});
        path = &std::get<PathItem>(drawing_.items.back().what);
    }
    path->lines.push_back({mm(from), mm(to)});
}

Drawing Canvas::finish(Vec2d size_px) {
    drawing_.size_mm = mm(size_px);
    std::get<PathItem>(drawing_.items.front().what).lines = {rounded({}, drawing_.size_mm, 0)};
    return std::move(drawing_);
}

}  // namespace snug

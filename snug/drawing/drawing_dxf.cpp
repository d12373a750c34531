#include "snug/drawing/drawing_dxf.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "snug/drawing/dxf_document.h"

namespace snug {
namespace {

/// Of the seven named colours the nearest.
int color_number(Color color) {
    constexpr std::array<Color, 7> known{Color{255, 0, 0},   Color{255, 255, 0}, Color{0, 255, 0},
                                         Color{0, 255, 255}, Color{0, 0, 255},   Color{255, 0, 255},
                                         Color{0, 0, 0}};
    const auto apart = [&](Color other) {
        const int red = color.red - other.red, green = color.green - other.green,
                  blue = color.blue - other.blue;
        return red * red + green * green + blue * blue;
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < known.size(); ++i)
        if (apart(known[i]) < apart(known[nearest])) nearest = i;
    return static_cast<int>(nearest) + 1;
}

}  // namespace

std::string drawing_dxf(const Drawing& drawing) {
    std::vector<DxfLayer> layers;
    for (const DrawingLayer& layer : drawing.layers)
        layers.push_back({layer.name, color_number(layer.color)});
    DxfDocument document(drawing.size_mm, std::move(layers));
    const auto upward = [&](Vec2d at) { return Vec2d{at.x, drawing.size_mm.y - at.y}; };
    for (const DrawingItem& item : drawing.items) {
        const std::string& layer = drawing.layers[static_cast<std::size_t>(item.layer)].name;
        if (const auto* path = std::get_if<PathItem>(&item.what))
            for (std::vector<Vec2d> line : path->lines) {
                if (line.size() < 2) continue;
                for (Vec2d& at : line) at = upward(at);
                document.polyline(layer, line, path->closed);
            }
        if (const auto* circle = std::get_if<CircleItem>(&item.what))
            document.circle(layer, upward(circle->centre), circle->radius_mm);
    }
    return document.finish();
}

}  // namespace snug

#include "snug/fabricate/drawing_dxf.h"

#include <array>
#include <cstddef>

#include "snug/base/text.h"

namespace snug {
namespace {

std::string pair(int code, const std::string& value) {
    return std::to_string(code) + "\n" + value + "\n";
}

std::string real(int code, double value) {
    return pair(code, number(value, 5));
}

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

std::string tables(const Drawing& drawing) {
    std::string text = pair(0, "SECTION") + pair(2, "TABLES") + pair(0, "TABLE") + pair(2, "LAYER") +
                       pair(70, std::to_string(drawing.layers.size()));
    for (const DrawingLayer& layer : drawing.layers)
        text += pair(0, "LAYER") + pair(2, layer.name) + pair(70, "0") +
                pair(62, std::to_string(color_number(layer.color))) + pair(6, "CONTINUOUS");
    return text + pair(0, "ENDTAB") + pair(0, "ENDSEC");
}

std::string polylines(const PathItem& path, const std::string& layer, double height) {
    std::string text;
    for (const auto& line : path.lines) {
        if (line.size() < 2) continue;
        text += pair(0, "POLYLINE") + pair(8, layer) + pair(66, "1") + pair(70, path.closed ? "1" : "0");
        for (const Vec2d p : line)
            text += pair(0, "VERTEX") + pair(8, layer) + real(10, p.x) + real(20, height - p.y);
        text += pair(0, "SEQEND");
    }
    return text;
}

}  // namespace

std::string drawing_dxf(const Drawing& drawing) {
    std::string text = pair(0, "SECTION") + pair(2, "HEADER") + pair(9, "$ACADVER") + pair(1, "AC1009") +
                       pair(0, "ENDSEC") + tables(drawing) + pair(0, "SECTION") + pair(2, "ENTITIES");
    const double height = drawing.size_mm.y;
    for (const DrawingItem& item : drawing.items) {
        const std::string& layer = drawing.layers[static_cast<std::size_t>(item.layer)].name;
        if (const auto* path = std::get_if<PathItem>(&item.what)) text += polylines(*path, layer, height);
        if (const auto* circle = std::get_if<CircleItem>(&item.what))
            text += pair(0, "CIRCLE") + pair(8, layer) + real(10, circle->centre.x) +
                    real(20, height - circle->centre.y) + real(40, circle->radius_mm);
    }
    return text + pair(0, "ENDSEC") + pair(0, "EOF");
}

}  // namespace snug

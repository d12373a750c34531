#include "snug/drawing/drawing_svg.h"

#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/svg.h"

namespace snug {
namespace {

constexpr int kDecimals = 4;

std::string mm(double value) {
    return number(value, kDecimals);
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string looks(const std::optional<Color>& fill, const std::optional<Pen>& pen) {
    std::string text = attribute("fill", fill ? hex(*fill) : "none");
    if (fill) text += attribute("fill-rule", "evenodd");
    if (!pen) return text;
    text += attribute("stroke", hex(pen->color)) + attribute("stroke-width", mm(pen->width_mm));
    std::string dashes;
    for (const double dash : pen->dashes_mm) dashes += (dashes.empty() ? "" : " ") + mm(dash);
    return dashes.empty() ? text : text + attribute("stroke-dasharray", dashes);
}

std::string element(const PathItem& path) {
    std::string data;
    for (const std::vector<Vec2d>& line : path.lines) {
        const char* command = "M";
        for (const Vec2d point : line) {
            data += command + mm(point.x) + " " + mm(point.y);
            command = "L";
        }
        if (path.closed && !line.empty()) data += "Z";
    }
    const std::optional<Color> fill = path.closed ? path.fill : std::nullopt;
    return "<path" + attribute("d", data) + looks(fill, path.pen) + "/>\n";
}

std::string element(const CircleItem& circle) {
    return "<circle" + attribute("cx", mm(circle.centre.x)) + attribute("cy", mm(circle.centre.y)) +
           attribute("r", mm(circle.radius_mm)) + looks(circle.fill, circle.pen) + "/>\n";
}

std::string element(const TextItem& text) {
    std::string result = "<text" + attribute("x", mm(text.at.x)) + attribute("y", mm(text.at.y)) +
                         attribute("font-size", mm(text.height_mm)) + attribute("fill", hex(text.color));
    if (text.bold) result += attribute("font-weight", "bold");
    if (text.anchor != TextAnchor::start)
        result += attribute("text-anchor", text.anchor == TextAnchor::middle ? "middle" : "end");
    if (text.turn_deg != 0)
        result += attribute("transform",
                            "rotate(" + mm(text.turn_deg) + " " + mm(text.at.x) + " " + mm(text.at.y) + ")");
    return result + ">" + xml_text(text.text) + "</text>\n";
}

std::string opening_tag(Vec2d size, Language language) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
           "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"" +
           attribute("width", mm(size.x) + "mm") + attribute("height", mm(size.y) + "mm") +
           attribute("viewBox", "0 0 " + mm(size.x) + " " + mm(size.y)) +
           attribute("font-family", "Helvetica, Arial, 'Liberation Sans'" + more_fonts(language)) + ">\n";
}

}  // namespace

std::string drawing_svg(const Drawing& drawing) {
    std::string text =
        opening_tag(drawing.size_mm, drawing.language) + "<title>" + xml_text(drawing.title) + "</title>\n";
    std::vector<int> groups(drawing.layers.size(), 0);
    int open = -1;
    for (const DrawingItem& item : drawing.items) {
        if (item.layer != open) {
            const auto layer = static_cast<std::size_t>(item.layer);
            const std::string& name = drawing.layers[layer].name;
            const int times = ++groups[layer];
            text += (open >= 0 ? "</g>\n<g" : "<g") +
                    attribute("id", times == 1 ? name : name + "-" + std::to_string(times)) +
                    attribute("inkscape:groupmode", "layer") + attribute("inkscape:label", name) + ">\n";
            open = item.layer;
        }
        text += std::visit([](const auto& what) { return element(what); }, item.what);
    }
    return text + (open >= 0 ? "</g>\n" : "") + "</svg>\n";
}

}  // namespace snug

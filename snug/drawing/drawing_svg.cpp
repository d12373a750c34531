#include "snug/drawing/drawing_svg.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
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

std::string share(const char* name, double opacity) {
    return opacity == 1 ? "" : attribute(name, number(opacity));
}

/// All of a pen but its colour, lengths in units of `unit_mm`.
std::string stroke_attributes(const Pen& pen, double unit_mm) {
    std::string text = attribute("stroke-width", mm(pen.width_mm / unit_mm));
    std::string dashes;
    for (const double dash : pen.dashes_mm) dashes += (dashes.empty() ? "" : " ") + mm(dash / unit_mm);
    if (!dashes.empty()) text += attribute("stroke-dasharray", dashes);
    if (pen.round_joins) text += attribute("stroke-linejoin", "round");
    if (pen.round_ends) text += attribute("stroke-linecap", "round");
    return text + share("stroke-opacity", pen.opacity);
}

std::string looks(const std::optional<Color>& fill, const std::optional<Pen>& pen, FillRule rule,
                  double fill_opacity) {
    std::string text = attribute("fill", fill ? hex(*fill) : "none");
    if (fill && rule == FillRule::even_odd) text += attribute("fill-rule", "evenodd");
    if (fill) text += share("fill-opacity", fill_opacity);
    if (!pen) return text;
    return text + attribute("stroke", hex(pen->color)) + stroke_attributes(*pen, 1);
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
    return "<path" + attribute("d", data) + looks(fill, path.pen, path.rule, path.fill_opacity) + "/>\n";
}

std::string element(const CircleItem& circle) {
    return "<circle" + attribute("cx", mm(circle.centre.x)) + attribute("cy", mm(circle.centre.y)) +
           attribute("r", mm(circle.radius_mm)) +
           looks(circle.fill, circle.pen, FillRule::even_odd, circle.fill_opacity) + "/>\n";
}

/// Where a text stands: its own plane has its origin there.
std::string place(const TextItem& text) {
    if (!text.plane) return attribute("x", mm(text.at.x)) + attribute("y", mm(text.at.y));
    const Vec2d along = text.plane->along, down = text.plane->down;
    std::string matrix;
    for (const double part : {along.x, along.y, down.x, down.y}) matrix += number(part, 5) + " ";
    return attribute("transform", "matrix(" + matrix + mm(text.at.x) + " " + mm(text.at.y) + ")");
}

std::string element(const TextItem& text) {
    std::string result = "<text" + place(text) + attribute("font-size", mm(text.height_mm)) +
                         attribute("fill", hex(text.color)) + share("fill-opacity", text.opacity);
    if (text.bold) result += attribute("font-weight", "bold");
    if (text.spacing_mm != 0) result += attribute("letter-spacing", mm(text.spacing_mm));
    if (text.halo)
        result += attribute("stroke", hex(text.halo->color)) + stroke_attributes(*text.halo, 1) +
                  attribute("paint-order", "stroke");
    if (text.anchor != TextAnchor::start)
        result += attribute("text-anchor", text.anchor == TextAnchor::middle ? "middle" : "end");
    if (text.turn_deg != 0 && !text.plane)
        result += attribute("transform",
                            "rotate(" + mm(text.turn_deg) + " " + mm(text.at.x) + " " + mm(text.at.y) + ")");
    result += ">";
    if (!text.lead.empty())
        result += "<tspan" + attribute("font-weight", "bold") + ">" + xml_text(text.lead) + "</tspan> ";
    return result + xml_text(text.text) + "</text>\n";
}

struct Steps {
    long long x = 0, y = 0;
};

void append_pair(std::string& text, Steps at, bool first) {
    if (!first && at.x >= 0) text += ' ';
    text += std::to_string(at.x);
    if (at.y >= 0) text += ' ';
    text += std::to_string(at.y);
}

/// M and l with whole numbers: differences of rounded corners, so that errors do not add up.
void append_line(std::string& text, const std::vector<Vec2d>& corners, bool closed, double step_mm) {
    const auto steps = [step_mm](Vec2d at) {
        return Steps{static_cast<long long>(std::floor(at.x / step_mm + 0.5)),
                     static_cast<long long>(std::floor(at.y / step_mm + 0.5))};
    };
    if (corners.empty()) return;
    Steps last = steps(corners.front());
    text += 'M';
    append_pair(text, last, true);
    text += 'l';
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Steps next = steps(corners[i]);
        append_pair(text, {next.x - last.x, next.y - last.y}, i == 1);
        last = next;
    }
    if (closed) text += 'z';
}

/// What paths of a group have in common: all of their look but the colours.
std::string group_attributes(const PathItem& path, double step_mm) {
    std::string text;
    if (path.closed && path.fill) {
        if (path.rule == FillRule::even_odd) text += attribute("fill-rule", "evenodd");
        text += share("fill-opacity", path.fill_opacity);
    }
    return path.pen ? text + stroke_attributes(*path.pen, step_mm) : text;
}

/// Paths in whole steps, those of one look in one group.
std::string path_groups(std::span<const DrawingItem> items, double step_mm) {
    std::string text, group;
    bool open = false;
    for (const DrawingItem& item : items) {
        const auto& path = std::get<PathItem>(item.what);
        if (std::string own = group_attributes(path, step_mm); !open || own != group) {
            group = std::move(own);
            text += std::string(open ? "</g>\n" : "") + "<g" +
                    attribute("transform", "scale(" + number(step_mm, 8) + ")") + group + ">\n";
            open = true;
        }
        text += "<path" + attribute("fill", path.closed && path.fill ? hex(*path.fill) : "none");
        if (path.pen) text += attribute("stroke", hex(path.pen->color));
        text += " d=\"";
        for (const std::vector<Vec2d>& line : path.lines) append_line(text, line, path.closed, step_mm);
        text += "\"/>\n";
    }
    return open ? text + "</g>\n" : text;
}

std::string elements(std::span<const DrawingItem> items, double step_mm) {
    if (step_mm > 0 && std::all_of(items.begin(), items.end(), [](const DrawingItem& item) {
            return std::holds_alternative<PathItem>(item.what);
        }))
        return path_groups(items, step_mm);
    std::string text;
    for (const DrawingItem& item : items)
        text += std::visit([](const auto& what) { return element(what); }, item.what);
    return text;
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
    const std::span<const DrawingItem> items(drawing.items);
    for (std::size_t first = 0, end = 0; first < items.size(); first = end) {
        const int layer_number = items[first].layer;
        while (end < items.size() && items[end].layer == layer_number) ++end;
        const DrawingLayer& layer = drawing.layers[static_cast<std::size_t>(layer_number)];
        const int times = ++groups[static_cast<std::size_t>(layer_number)];
        text += "<g" + attribute("id", times == 1 ? layer.name : layer.name + "-" + std::to_string(times)) +
                attribute("inkscape:groupmode", "layer") + attribute("inkscape:label", layer.name) + ">\n" +
                elements(items.subspan(first, end - first), layer.step_mm) + "</g>\n";
    }
    return text + "</svg>\n";
}

}  // namespace snug

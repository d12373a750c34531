#include "snug/drawing/drawing_json.h"

#include <cmath>
#include <variant>

#include <nlohmann/json.hpp>

namespace snug {
namespace {

using OrderedJson = nlohmann::ordered_json;

double rounded(double mm) {
    return std::floor(mm * 1e4 + 0.5) / 1e4;
}

OrderedJson pair(Vec2d v) {
    return OrderedJson::array({rounded(v.x), rounded(v.y)});
}

std::string hexadecimal(Color color) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned part : {color.red, color.green, color.blue}) {
        text += kDigits[part >> 4];
        text += kDigits[part & 15];
    }
    return text;
}

OrderedJson fill_json(const std::optional<Color>& fill) {
    return fill ? OrderedJson(hexadecimal(*fill)) : OrderedJson(nullptr);
}

OrderedJson pen_json(const std::optional<Pen>& pen) {
    if (!pen) return nullptr;
    return {
        {"color", hexadecimal(pen->color)}, {"width", rounded(pen->width_mm)}, {"dashes", pen->dashes_mm}};
}

OrderedJson item_json(const PathItem& path) {
    OrderedJson lines = OrderedJson::array();
    for (const auto& line : path.lines) {
        OrderedJson points = OrderedJson::array();
        for (const Vec2d& p : line) {
            points.push_back(rounded(p.x));
            points.push_back(rounded(p.y));
        }
        lines.push_back(std::move(points));
    }
    return {{"path", std::move(lines)},
            {"closed", path.closed},
            {"fill", fill_json(path.fill)},
            {"pen", pen_json(path.pen)}};
}

OrderedJson item_json(const CircleItem& circle) {
    return {{"circle", OrderedJson::array(
                           {rounded(circle.centre.x), rounded(circle.centre.y), rounded(circle.radius_mm)})},
            {"fill", fill_json(circle.fill)},
            {"pen", pen_json(circle.pen)}};
}

OrderedJson item_json(const TextItem& text) {
    constexpr const char* kAnchors[] = {"start", "middle", "end"};
    return {{"text", text.text},
            {"at", pair(text.at)},
            {"height", rounded(text.height_mm)},
            {"anchor", kAnchors[static_cast<int>(text.anchor)]},
            {"turn", text.turn_deg},
            {"bold", text.bold},
            {"color", hexadecimal(text.color)}};
}

}  // namespace

std::string drawing_json(const DrawingDocument& document) {
    OrderedJson pages = OrderedJson::array();
    for (const Drawing& drawing : document.pages) {
        OrderedJson items = OrderedJson::array();
        for (const DrawingItem& item : drawing.items)
            items.push_back(std::visit([](const auto& what) { return item_json(what); }, item.what));
        pages.push_back(
            {{"title", drawing.title}, {"size", pair(drawing.size_mm)}, {"items", std::move(items)}});
    }
    return pages.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace snug

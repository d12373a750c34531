#include "snug/fabricate/printing/threemf.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/svg.h"

namespace snug {
namespace {

constexpr std::string_view kDeclaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

constexpr std::string_view kContentTypes =
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";

constexpr std::string_view kRelationships =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

bool same(Color a, Color b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

std::string color_name(Color color) {
    if (same(color, kLowerBlue)) return "blue";
    return same(color, kUpperOrange) ? "orange" : hex(color);
}

/// Objects are numbered from 2, in the order in which they first appear; 1 is the materials.
struct Objects {
    std::vector<Color> colors;
    std::vector<std::pair<const ThreeMfItem*, std::size_t>> objects;  ///< and its colour
    std::vector<std::size_t> of_item;
};

Objects objects_of(std::span<const ThreeMfItem> items) {
    Objects all;
    for (const ThreeMfItem& item : items) {
        const auto color =
            std::find_if(all.colors.begin(), all.colors.end(), [&](Color c) { return same(c, item.color); });
        const auto color_index = static_cast<std::size_t>(color - all.colors.begin());
        if (color == all.colors.end()) all.colors.push_back(item.color);
        const auto object = std::find_if(all.objects.begin(), all.objects.end(), [&](const auto& known) {
            return known.first->solid == item.solid && known.second == color_index;
        });
        all.of_item.push_back(static_cast<std::size_t>(object - all.objects.begin()));
        if (object == all.objects.end()) all.objects.push_back({&item, color_index});
    }
    return all;
}

void append_object(const ThreeMfItem& item, std::size_t id, std::size_t color, std::string& xml) {
    xml += "<object id=\"" + std::to_string(id) + "\" type=\"model\" name=\"" + xml_text(item.name) +
           "\" pid=\"1\" pindex=\"" + std::to_string(color) + "\">\n<mesh>\n<vertices>\n";
    for (const Vec3f v : item.solid->vertices)
        xml +=
            "<vertex x=\"" + shortest(v.x) + "\" y=\"" + shortest(v.y) + "\" z=\"" + shortest(v.z) + "\"/>\n";
    xml += "</vertices>\n<triangles>\n";
    for (const Triangle& t : item.solid->triangles)
        xml += "<triangle v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) + "\" v3=\"" +
               std::to_string(t[2]) + "\"/>\n";
    xml += "</triangles>\n</mesh>\n</object>\n";
}

std::string model(const std::string& title, std::span<const ThreeMfItem> items) {
    const Objects all = objects_of(items);
    std::string xml(kDeclaration);
    xml +=
        "<model unit=\"millimeter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
        "<metadata name=\"Title\">" +
        xml_text(title) +
        "</metadata>\n<metadata name=\"Application\">Snug " SNUG_VERSION
        "</metadata>\n<resources>\n<basematerials id=\"1\">\n";
    for (const Color color : all.colors)
        xml += "<base name=\"" + color_name(color) + "\" displaycolor=\"" + hex(color) + "\"/>\n";
    xml += "</basematerials>\n";
    for (std::size_t i = 0; i < all.objects.size(); ++i)
        append_object(*all.objects[i].first, i + 2, all.objects[i].second, xml);
    xml += "</resources>\n<build>\n";
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Vec3d at = items[i].at_mm;
        xml += "<item objectid=\"" + std::to_string(all.of_item[i] + 2) +
               "\" transform=\"1 0 0 0 1 0 0 0 1 " + number(at.x, 4) + " " + number(at.y, 4) + " " +
               number(at.z, 4) + "\" partnumber=\"" + xml_text(items[i].name) + "\"/>\n";
    }
    return xml + "</build>\n</model>\n";
}

}  // namespace

PackContainer three_mf(std::string file_name, const std::string& title, std::span<const ThreeMfItem> items) {
    const std::string declaration(kDeclaration);
    return {std::move(file_name),
            {text_file("[Content_Types].xml", declaration + std::string(kContentTypes)),
             text_file("_rels/.rels", declaration + std::string(kRelationships)),
             text_file("3D/3dmodel.model", model(title, items))}};
}

}  // namespace snug

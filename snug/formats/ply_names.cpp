#include "snug/formats/ply_names.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "snug/formats/text_scan.h"

namespace snug {
namespace {

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> lower) {
    return std::any_of(lower.begin(), lower.end(),
                       [&](std::string_view each) { return same_word(word, each); });
}

bool has_element(const PlyHeader& header, std::string_view name) {
    return std::any_of(header.elements.begin(), header.elements.end(),
                       [&](const PlyElement& element) { return element.name == name; });
}

/// The first element of these names takes the one that the format has, unless another has it.
void name_element(PlyHeader& header, std::string_view name, std::initializer_list<std::string_view> others) {
    if (has_element(header, name)) return;
    const auto found =
        std::find_if(header.elements.begin(), header.elements.end(),
                     [&](const PlyElement& element) { return is_one_of(element.name, others); });
    if (found != header.elements.end()) found->name = name;
}

void name_coordinates(PlyElement& vertices) {
    for (const std::string_view axis : {"x", "y", "z"}) {
        if (vertices.find(axis) < vertices.properties.size()) continue;
        for (PlyProperty& property : vertices.properties)
            if (same_word(property.name, axis)) property.name = axis;
    }
}

bool holds(std::string_view name, std::string_view lower) {
    for (std::size_t at = 0; at + lower.size() <= name.size(); ++at)
        if (same_word(name.substr(at, lower.size()), lower)) return true;
    return false;
}

/// A list of whole numbers of this name; or properties.size().
template <class Named>
std::size_t find_list(const PlyElement& faces, const Named& named) {
    const auto found =
        std::find_if(faces.properties.begin(), faces.properties.end(), [&](const PlyProperty& property) {
            return property.count_type && is_integer(property.type) && named(property.name);
        });
    return static_cast<std::size_t>(found - faces.properties.begin());
}

/// Whole numbers one after the other that are counted by the last letter of their names: v1 v2 v3, a b c.
PlyCorners find_counted_numbers(const PlyElement& faces) {
    const auto goes_on = [&](std::size_t i) {
        const PlyProperty &before = faces.properties[i - 1], &property = faces.properties[i];
        if (property.count_type || before.count_type || !is_integer(property.type) ||
            !is_integer(before.type) || before.name.size() != property.name.size() ||
            property.name.back() != before.name.back() + 1)
            return false;
        const std::size_t stem = property.name.size() - 1;
        return property.name.compare(0, stem, before.name, 0, stem) == 0;
    };
    for (std::size_t first = 0; first + 2 < faces.properties.size(); ++first) {
        std::size_t end = first + 1;
        while (end < faces.properties.size() && goes_on(end)) ++end;
        if (end - first >= 3) return {first, end - first};
    }
    return {};
}

PlyCorners find_corners(const PlyElement& faces) {
    const std::size_t none = faces.properties.size();
    for (const std::string_view name : {"vertex_indices", "vertex_index"})
        if (const std::size_t at = faces.find(name); at < none) return {at, 1};
    const auto of_something_else = [](std::string_view name) {
        return same_word(name.substr(0, 3), "tex") || holds(name, "texture") || holds(name, "uv") ||
               holds(name, "col") || holds(name, "norm") || holds(name, "adj") || holds(name, "neigh") ||
               holds(name, "edge");
    };
    for (const std::string_view part : {"vert", "ind", "corner", ""}) {
        const std::size_t at = find_list(
            faces, [&](std::string_view name) { return holds(name, part) && !of_something_else(name); });
        if (at < none) return {at, 1};
    }
    return find_counted_numbers(faces);
}

}  // namespace

void use_known_names(PlyHeader& header) {
    name_element(header, "vertex", {"vertex", "vertices", "verts", "vert", "point", "points"});
    name_element(
        header, "face",
        {"face", "faces", "facet", "facets", "triangle", "triangles", "tri", "tris", "polygon", "polygons"});
    for (PlyElement& element : header.elements) {
        if (element.name == "vertex") name_coordinates(element);
        if (element.name == "face" || element.name == "tristrips") element.corners = find_corners(element);
    }
}

}  // namespace snug

#pragma once

#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/box.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug::test {

/// An object on the bed as it stands in a 3MF file.
struct PrintedItem {
    std::string name;
    std::vector<Vec3f> vertices;  ///< where the build item puts them
    std::vector<Triangle> triangles;
};

[[nodiscard]] inline std::string text_of(const FileBytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The value of an attribute within one tag.
[[nodiscard]] inline std::string attribute(const std::string& tag, const std::string& name) {
    const std::size_t at = tag.find(" " + name + "=\"");
    if (at == std::string::npos) return {};
    const std::size_t begin = at + name.size() + 3;
    return tag.substr(begin, tag.find('"', begin) - begin);
}

/// Reads the model of a 3MF container by its tags, without any of the writer's code.
[[nodiscard]] inline std::vector<PrintedItem> read_printed(const PackContainer& container) {
    std::vector<PrintedItem> items;
    std::map<std::string, PrintedItem> objects;
    PrintedItem* object = nullptr;
    const std::string xml = text_of(container.members.at(2).bytes);
    const auto index = [](const std::string& tag, const char* name) {
        return static_cast<std::uint32_t>(std::atoi(attribute(tag, name).c_str()));
    };
    const auto length = [](const std::string& tag, const char* name) {
        return std::strtof(attribute(tag, name).c_str(), nullptr);
    };
    for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
        const std::string tag = xml.substr(at, xml.find('>', at) - at);
        if (tag.rfind("<object ", 0) == 0) {
            object = &objects[attribute(tag, "id")];
        } else if (tag.rfind("<vertex ", 0) == 0) {
            object->vertices.push_back({length(tag, "x"), length(tag, "y"), length(tag, "z")});
        } else if (tag.rfind("<triangle ", 0) == 0) {
            object->triangles.push_back({index(tag, "v1"), index(tag, "v2"), index(tag, "v3")});
        } else if (tag.rfind("<item ", 0) == 0) {
            PrintedItem item = objects.at(attribute(tag, "objectid"));
            item.name = attribute(tag, "partnumber");
            std::array<float, 12> m{};
            const std::string transform = attribute(tag, "transform");
            char* rest = const_cast<char*>(transform.c_str());
            for (float& value : m) value = std::strtof(rest, &rest);
            for (Vec3f& v : item.vertices)
                v = {v.x * m[0] + v.y * m[3] + v.z * m[6] + m[9],
                     v.x * m[1] + v.y * m[4] + v.z * m[7] + m[10],
                     v.x * m[2] + v.y * m[5] + v.z * m[8] + m[11]};
            items.push_back(std::move(item));
        }
    }
    return items;
}

[[nodiscard]] inline Box3d bounds_of(const PrintedItem& item) {
    Box3d box;
    for (const Vec3f v : item.vertices) box.include(vec_cast<double>(v));
    return box;
}

/// How often the surface winds around a point: crossings of a ray along +z, signed.
[[nodiscard]] inline int winding(const PrintedItem& item, Vec3d p) {
    int turns = 0;
    for (const Triangle& t : item.triangles) {
        const Vec3d a = vec_cast<double>(item.vertices[t[0]]) - p;
        const Vec3d b = vec_cast<double>(item.vertices[t[1]]) - p;
        const Vec3d c = vec_cast<double>(item.vertices[t[2]]) - p;
        const auto side = [](Vec3d u, Vec3d v) { return u.x * v.y - u.y * v.x; };
        const double ab = side(a, b), bc = side(b, c), ca = side(c, a), area = ab + bc + ca;
        if (area == 0 || !((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) continue;
        if ((a.z * bc + b.z * ca + c.z * ab) / area > 0) turns += area > 0 ? 1 : -1;
    }
    return turns;
}

}  // namespace snug::test

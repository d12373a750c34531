#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/zip_builder.h"

namespace snug::test {

inline constexpr std::string_view kCoreSpace =
    "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";
inline constexpr std::string_view kProductionSpace =
    "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";

/// Relationships to the models of these names, in this order.
inline std::string relationships(const std::vector<std::string>& targets) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><Relationships "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/Metadata/thumbnail.png\" Id=\"t\" "
        "Type=\"http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail\"/>";
    for (const std::string& target : targets)
        text += "<Relationship Target=\"" + target + "\" Id=\"r" + std::to_string(&target - targets.data()) +
                "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>";
    return text + "</Relationships>";
}

/// A tetrahedron's `mesh` with three edges of length `edge` along x, y and z; closed and outward.
inline std::string tetrahedron_mesh(const std::string& edge, const std::string& more = "") {
    return "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"" + edge +
           "\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"" + edge + "\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"" +
           edge +
           "\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" "
           "v3=\"3\"/>"
           "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles>" +
           more + "</mesh>";
}

inline std::string object_of(int id, const std::string& inside, const std::string& attributes = "") {
    return "<object id=\"" + std::to_string(id) + "\" " + attributes + ">" + inside + "</object>";
}

/// A model in mm with these resources and this build; both spaces are declared.
inline std::string model_of(const std::string& resources, const std::string& build,
                            const std::string& attributes = "unit=\"millimeter\"") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><model " + attributes + " " + std::string(kCoreSpace) +
           " " + std::string(kProductionSpace) + "><resources>" + resources + "</resources><build>" + build +
           "</build></model>";
}

/// A 3MF of a root and further parts by their names.
inline std::string threemf_of(const std::string& root,
                              std::vector<std::pair<std::string, std::string>> parts = {}) {
    std::vector<ZipPart> members{{"[Content_Types].xml", "<Types/>"},
                                 {"_rels/.rels", relationships({"/3D/3dmodel.model"}), true},
                                 {"3D/3dmodel.model", root, true}};
    for (auto& [name, text] : parts) members.push_back({name, text, true});
    return zip_of(members);
}

}  // namespace snug::test

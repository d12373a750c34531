#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/base/bytes.h"
#include "snug/base/vec.h"

namespace snug::test {

/// Builds small glTF files piece by piece; `json` may be changed at will before it is written.
class GltfBuilder {
  public:
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    FileBytes binary;

    /// The number of a view of these bytes.
    int view(const void* data, std::size_t size) {
        while (binary.size() % 4 != 0) binary.push_back(std::byte{0});
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", size}});
        const auto* bytes = static_cast<const std::byte*>(data);
        binary.insert(binary.end(), bytes, bytes + size);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    /// The number of an accessor: `type` has `components` values.
    template <class T>
    int accessor(const std::vector<T>& values, int component, std::string_view type, int components) {
        json["accessors"].push_back({{"bufferView", view(values.data(), values.size() * sizeof(T))},
                                     {"componentType", component},
                                     {"count", values.size() / static_cast<std::size_t>(components)},
                                     {"type", type}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    int places(const std::vector<float>& xyz) { return accessor(xyz, 5126, "VEC3", 3); }
    int corners(const std::vector<std::uint16_t>& indices) { return accessor(indices, 5123, "SCALAR", 1); }

    /// The number of a mesh of one primitive.
    int mesh(nlohmann::json primitive) {
        json["meshes"].push_back({{"primitives", {std::move(primitive)}}});
        return static_cast<int>(json["meshes"].size()) - 1;
    }
    /// The number of a node, which the scene shows unless it is below another.
    int node(nlohmann::json node, bool in_scene = true) {
        json["nodes"].push_back(std::move(node));
        const int number = static_cast<int>(json["nodes"].size()) - 1;
        if (in_scene) json["scenes"][0]["nodes"].push_back(number);
        return number;
    }

    /// As a .glb.
    [[nodiscard]] FileBytes glb(bool padded = true) const {
        nlohmann::json whole = json;
        whole["buffers"][0]["byteLength"] = binary.size();
        std::string text = whole.dump();
        while (padded && text.size() % 4 != 0) text += ' ';
        FileBytes file;
        const auto word = [&](std::uint32_t value) {
            for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::byte>(value >> (8 * i) & 0xFF));
        };
        const auto word_of = [](std::size_t value) { return static_cast<std::uint32_t>(value); };
        word(0x46546C67);
        word(2);
        word(word_of(28 + text.size() + binary.size()));
        word(word_of(text.size()));
        word(0x4E4F534A);
        const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
        file.insert(file.end(), bytes, bytes + text.size());
        word(word_of(binary.size()));
        word(0x004E4942);
        file.insert(file.end(), binary.begin(), binary.end());
        return file;
    }
    /// As a .gltf whose bytes lie in the file `uri`.
    [[nodiscard]] std::string gltf(std::string_view uri) const {
        nlohmann::json whole = json;
        whole["buffers"][0] = {{"byteLength", binary.size()}, {"uri", uri}};
        return whole.dump();
    }
};

/// A box of 0.12 x 0.1 x 0.03 m with a corner at the origin, closed and outward: 8 points, 12 triangles.
struct GltfBox {
    std::vector<float> places;
    std::vector<std::uint16_t> corners{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                       2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

    GltfBox() {
        for (int i = 0; i < 8; ++i)
            places.insert(places.end(), {(i & 1) != 0 ? 0.12f : 0.0f, (i & 2) != 0 ? 0.1f : 0.0f,
                                         (i & 4) != 0 ? 0.03f : 0.0f});
    }
};

}  // namespace snug::test

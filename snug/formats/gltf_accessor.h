#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/formats/gltf_buffers.h"

namespace snug::gltf {

/// As glTF numbers them.
enum class Component : std::uint16_t {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126
};

/// Values in the bytes of a scene: `count` elements of `components` numbers each. Within bounds by
/// construction; copies nothing but what a sparse accessor replaces.
class Accessor {
  public:
    Accessor() = default;
    /// `values`: `components` each, that outlive this.
    Accessor(std::span<const float> values, int components, double scale);

    [[nodiscard]] static Result<Accessor> open(const Json& scene, Buffers& buffers, std::uint64_t index,
                                               std::string_view type);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] int components() const { return components_; }
    /// Whether no bytes stand behind each element: their number is only claimed.
    [[nodiscard]] bool claimed() const { return base_.bytes.empty(); }
    /// Normalised where the accessor says so. i < count(), c < components().
    [[nodiscard]] double at(std::uint64_t i, int c) const;
    [[nodiscard]] Vec3d vec3(std::uint64_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
    /// What reading an element costs: replaced ones are searched for.
    [[nodiscard]] std::uint64_t effort() const { return replaced_.empty() ? 1 : 8; }
    /// The greatest value that an index of this type can have.
    [[nodiscard]] std::uint64_t greatest() const;

  private:
    struct Elements {
        Bytes bytes;
        std::uint64_t stride = 0;
        Component component = Component::float32;

        [[nodiscard]] double at(std::uint64_t i, int c) const;
    };
    struct Replaced {
        std::uint64_t index, place;
    };

    [[nodiscard]] static Result<Elements> elements(Buffers& buffers, const Json& of, Component component,
                                                   std::uint64_t components, std::uint64_t count);
    [[nodiscard]] Result<void> replace(Buffers& buffers, const Json& sparse);
    [[nodiscard]] double scaled(double value) const;

    std::uint64_t count_ = 0;
    int components_ = 0;
    bool normalised_ = false;
    double scale_ = 1;
    Elements base_;
    std::vector<Replaced> replaced_;  ///< by index
    Elements replacements_;
};

/// What a normalised component is divided by; 1 for floats. Of a value of a draco mesh, too.
[[nodiscard]] double divisor(Component component);
[[nodiscard]] Result<Component> component_of(const Json& accessor, const char* name = "componentType");

}  // namespace snug::gltf

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <emscripten/val.h>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/check/bearing.h"
#include "snug/check/gap.h"
#include "snug/check/packing.h"
#include "snug/design/presets.h"
#include "snug/design/project.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/object/object.h"
#include "snug/search/direction_map.h"
#include "snug/search/placement_search.h"
#include "snug/words/words.h"

// The library's values as the page has them (studio/src/engine/api.ts), field for field. Arrays are copies:
// they stay valid when the module's memory grows, and may be transferred.

namespace snug::wasm {

using emscripten::val;

[[nodiscard]] std::vector<std::byte> bytes_from(const val& uint8_array);
[[nodiscard]] std::vector<float> floats_from(const val& float32_array);
[[nodiscard]] val to_uint8_array(const std::vector<std::byte>& bytes);

template <class T>
[[nodiscard]] val typed_array(const T* data, std::size_t size) {
    return val(emscripten::typed_memory_view(size, data)).template call<val>("slice");
}

/// A JavaScript function of the fraction that is done, which returns whether to go on; null for none.
[[nodiscard]] Progress progress_from(const val& function);

/// Of a name such as "ja"; English where there is none of that name.
[[nodiscard]] Language language_of(std::string_view name);
/// [English, Japanese], so that the page may change its language.
[[nodiscard]] val to_val(const Message& message);
[[nodiscard]] val to_val(Vec3d v);
[[nodiscard]] val to_val(Vec3i v);
/// {error, kind}, the error in both languages.
[[nodiscard]] val to_val(const Error& error);
[[nodiscard]] val to_val(const Preset& preset);
[[nodiscard]] val to_val(const ObjectFile& file);
/// `refused`: why the object has no size in mm yet; `object` then holds what can be said without it.
[[nodiscard]] val to_val(const Object& object, Vec3d file_size, const std::optional<Error>& refused);
[[nodiscard]] val to_val(const Mesh& mesh);
[[nodiscard]] val to_val(const Packing& packing, double library_ms);
/// Of all layers, and of each.
[[nodiscard]] val to_val(const GapFigures& whole, const std::vector<GapReport>& layers);
[[nodiscard]] val to_val(const BearingReport& bearing, const Design& design);
/// `items`: of the packing that they are of, whose numbers they then tell.
[[nodiscard]] val to_val(const std::vector<Finding>& findings, const std::vector<Item>& items = {});
[[nodiscard]] val to_val(const FoundPlacement& placement);
[[nodiscard]] val to_val(const PlacementSearch& search, const DesignSpace& space);
/// Directions that fit alone.
[[nodiscard]] val to_val(const DirectionMap& map);
constexpr std::size_t kMapDirections = 500;
constexpr std::size_t kMapPasses = 12;  ///< turns about each direction in a map
[[nodiscard]] val to_val(const PackFile& file);

}  // namespace snug::wasm

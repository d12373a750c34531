#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "snug/base/bytes.h"
#include "snug/base/result.h"

// The fields of glTF's JSON. A field that is absent has a default; one that is there and wrong is refused.

namespace snug::gltf {

using Json = nlohmann::json;

/// The JSON of a scene. Fails where it is none, nests deeper than any scene or has more values than memory
/// should be spent on. Bytes that are no UTF-8 are replaced: names may come from elsewhere.
[[nodiscard]] Result<Json> parse_scene(Bytes text);

/// null where it is absent.
[[nodiscard]] const Json& field(const Json& of, const char* name);
/// null where there is none.
[[nodiscard]] const Json& item(const Json& list, std::uint64_t index);
/// Of a list; 0 for anything else.
[[nodiscard]] std::uint64_t count_of(const Json& list);
/// An extension of the object; null where it has none.
[[nodiscard]] const Json& extension(const Json& of, const char* name);
[[nodiscard]] bool names(const Json& list, std::string_view name);
[[nodiscard]] std::string text_of(const Json& of, const char* name, std::string_view otherwise = {});

/// A whole number from 0 to 2^53.
[[nodiscard]] Result<std::uint64_t> whole(const Json& of, const char* name, std::uint64_t otherwise);
/// A whole number as a value itself.
[[nodiscard]] Result<std::uint64_t> whole_value(const Json& value, std::string_view name);
/// As many numbers as `into` has; without the field `into` keeps what it has.
[[nodiscard]] Result<void> numbers(const Json& of, const char* name, std::span<double> into);

/// A sentence about the file.
[[nodiscard]] inline tl::unexpected<Error> refuse(Message message) {
    return fail(ErrorKind::input, std::move(message));
}

}  // namespace snug::gltf

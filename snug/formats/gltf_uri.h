#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/base/bytes.h"

namespace snug::gltf {

/// %20 and the like as the bytes that they stand for; what is no such sequence stays.
[[nodiscard]] std::string percent_decoded(std::string_view text);

[[nodiscard]] bool is_data_uri(std::string_view uri);
/// What a data: URI (RFC 2397) holds, in base64 of either alphabet, padded or not, or percent-encoded; none
/// where it is damaged.
[[nodiscard]] std::optional<FileBytes> data_of(std::string_view uri);

/// Whether the URI begins with a scheme ("https:") or a root: it names no file beside the scene.
[[nodiscard]] bool leads_elsewhere(std::string_view uri);

}  // namespace snug::gltf

#pragma once

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/gltf_json.h"

namespace snug::gltf {

/// The parts of a .glb or .gltf.
struct Container {
    Json json;
    Bytes binary;  ///< the binary chunk of a .glb, within the file; empty where there is none
};

[[nodiscard]] bool is_glb(Bytes file);

/// glTF 2.0, sections 3.6 and 4.4, and files that keep the letter of them less: a byte order mark, chunks
/// that are not padded, a total length that is wrong.
[[nodiscard]] Result<Container> open_container(Bytes file);

}  // namespace snug::gltf

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/result.h"

namespace snug {

/// A mesh as KHR_draco_mesh_compression packs it.
struct DracoMesh {
    std::vector<float> positions;        ///< x, y, z of each point
    std::vector<std::uint32_t> corners;  ///< three of each triangle
};

/// How EXT_meshopt_compression packs a buffer view.
struct MeshoptView {
    std::size_t count = 0;   ///< elements
    std::size_t stride = 0;  ///< bytes of an element
    std::string mode;        ///< ATTRIBUTES, TRIANGLES or INDICES
    std::string filter;      ///< NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL
};

/// What the readers of scenes (glTF, 3MF) ask of the program around the library: libraries that differ
/// between the command line and the browser, and files beside the scene. A tool that is absent is a sentence
/// that says what the file needs. Each fails with kind `input`; sizes are checked before memory is asked for.
struct SceneTools {
    /// A file that the scene names, relative to its folder and never above it; the name is decoded.
    std::function<Result<FileBytes>(const std::string& name)> beside;
    /// Raw DEFLATE (RFC 1951). Fails where it holds more than `most` bytes.
    std::function<Result<FileBytes>(Bytes packed, std::size_t most)> inflate;
    /// count * stride bytes.
    std::function<Result<FileBytes>(Bytes packed, const MeshoptView& view)> meshopt;
    /// `position` is the attribute's unique id.
    std::function<Result<DracoMesh>(Bytes packed, int position)> draco;
};

}  // namespace snug

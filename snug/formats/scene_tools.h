#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/result.h"

namespace snug {

/// What is asked of a mesh that KHR_draco_mesh_compression packs.
struct DracoAttribute {
    int id = 0;          ///< the attribute's unique id
    int components = 0;  ///< of each point; fails where it has another number
};

/// A mesh as KHR_draco_mesh_compression packs it.
struct DracoMesh {
    /// Of each attribute that was asked for, the components of every point, as stored: whole numbers are not
    /// scaled, whether the packed mesh calls them normalised or not.
    std::vector<std::vector<float>> attributes;
    std::vector<std::uint32_t> corners;  ///< three of each triangle
};

/// How EXT_meshopt_compression packs a buffer view. Its filters are undone by the reader.
struct MeshoptView {
    std::size_t count = 0;   ///< elements
    std::size_t stride = 0;  ///< bytes of an element
    std::string mode;        ///< ATTRIBUTES, TRIANGLES or INDICES
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
    std::function<Result<DracoMesh>(Bytes packed, std::span<const DracoAttribute> attributes)> draco;
};

}  // namespace snug

#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "snug/base/result.h"
#include "snug/mesh/mesh.h"
#include "snug/words/words.h"

namespace snug::fuzz {

inline void require(bool holds) {
    if (!holds) std::abort();
}

inline void check_vertices(const Mesh& mesh) {
    for (const Vec3f& v : mesh.vertices)
        require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
}

/// What every mesh that a reader gives out must be; an error must say something.
inline void check(const Result<Mesh>& result) {
    if (!result)
        return require(!text(result.error().message).empty() && result.error().kind == ErrorKind::input);
    const Mesh& mesh = *result;
    require(!mesh.triangles.empty());
    // Refused where more than half is left out.
    require(mesh.read.left_out_faces <= mesh.read.faces / 2);
    std::vector<bool> used(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) {
            require(v < mesh.vertices.size());
            used[v] = true;
        }
    }
    for (const bool each : used) require(each);
    check_vertices(mesh);
}

inline std::span<const std::byte> bytes(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const std::byte*>(data), size};
}

}  // namespace snug::fuzz

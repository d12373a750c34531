#pragma once

#include <atomic>
#include <cstdint>
#include <cstring>
#include <span>

#include "snug/base/byte_source.h"
#include "snug/formats/mesh_files.h"

// Files in memory that are read as if they were too large for it.

namespace snug::test {

/// Of bytes in memory; counts how many were read.
inline ByteSource source_of(const FileBytes& bytes, std::atomic<std::uint64_t>* read = nullptr) {
    return {bytes.size(), [&bytes, read](std::uint64_t at, std::span<std::byte> into) -> Result<void> {
                if (at + into.size() > bytes.size())
                    return fail(ErrorKind::input, as_it_is("beyond the end"));
                std::memcpy(into.data(), bytes.data() + at, into.size());
                if (read) *read += into.size();
                return {};
            }};
}

inline FileBytes stl_of(const Mesh& mesh) {
    return write_stl(mesh.vertices, mesh.triangles, "test");
}

}  // namespace snug::test

#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/mesh_files.h"
#include "snug/formats/read.h"
#include "snug/words/words.h"

namespace snug::test {

inline Bytes bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

/// An OBJ whose first four vertices are the corners of a square of side 1, in order; `rest` starts in line 5.
inline std::string square_obj(std::string_view rest) {
    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + std::string(rest);
}

/// An ASCII PLY with float x, y, z and faces as vertex_indices; its data starts in line 10.
inline std::string ascii_ply(int vertices, int faces, std::string_view data) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n" + std::string(data);
}

/// Three sides on the coordinate planes, edges of 60; closed and outward.
inline Mesh tetrahedron() {
    return {
        {{0, 0, 0}, {60, 0, 0}, {0, 60, 0}, {0, 0, 60}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {}};
}

/// Latin-1 text in UTF-16, with a byte order mark if wanted.
inline std::string utf16(const std::string& text, bool big, bool mark) {
    std::string wide;
    const auto put = [&](unsigned unit) {
        const char low = static_cast<char>(unit & 0xff), high = static_cast<char>(unit >> 8);
        wide += big ? high : low;
        wide += big ? low : high;
    };
    if (mark) put(0xfeff);
    for (const char c : text) put(static_cast<unsigned char>(c));
    return wide;
}

/// A binary STL.
inline std::string stl_of(const Mesh& mesh) {
    const FileBytes file = write_stl(mesh.vertices, mesh.triangles, "t");
    return {reinterpret_cast<const char*>(file.data()), file.size()};
}

inline Mesh good(const Result<Mesh>& mesh) {
    EXPECT_TRUE(mesh.has_value()) << snug::text(mesh.error().message);
    return mesh.value_or(Mesh{});
}

/// The sentence of a refused file, to be searched for words.
inline std::string refused(std::string_view text, std::string_view name = "") {
    const auto mesh = read_mesh(bytes_of(text), name);
    EXPECT_FALSE(mesh.has_value());
    if (mesh) return "";
    EXPECT_EQ(mesh.error().kind, ErrorKind::input);
    return snug::text(mesh.error().message);
}

inline void expect_holds(const std::string& sentence, std::string_view words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
}

/// The area that the triangles cover seen along z, with the way they are wound.
inline double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3f p = mesh.vertices[a], q = mesh.vertices[b], r = mesh.vertices[c];
        sum += 0.5 * static_cast<double>((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
    }
    return sum;
}

/// What every reader promises of the mesh that it gives out.
inline bool keeps_promises(const Mesh& mesh) {
    std::vector<bool> used(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) {
            if (v >= used.size()) return false;
            used[v] = true;
        }
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
        const Vec3f& p = mesh.vertices[v];
        if (!used[v] || !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
    }
    return !mesh.triangles.empty();
}

}  // namespace snug::test

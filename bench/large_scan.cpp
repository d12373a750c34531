// Writes a scan of any size: a rippled torus as binary STL or PLY, row by row, never whole in memory.
// Usage: snug_large_scan FILE.stl|FILE.ply TRIANGLES

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "snug/base/vec.h"

namespace {

using snug::Vec3f;

constexpr double kTurn = 6.283185307179586;

/// A grid of `rows` around the ring by `columns` around its section.
struct Torus {
    std::uint32_t rows, columns;

    [[nodiscard]] Vec3f at(std::uint32_t row, std::uint32_t column) const {
        const double u = kTurn * (row % rows) / rows, v = kTurn * (column % columns) / columns;
        const double thick = 45 + 2 * std::sin(40 * u) * std::sin(25 * v);
        const double far = 120 + thick * std::cos(v);
        return {static_cast<float>(thick * std::sin(v)), static_cast<float>(far * std::cos(u)),
                static_cast<float>(far * std::sin(u))};
    }
};

template <class T>
void put(std::vector<char>& bytes, const T& value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof value);
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

bool write(std::FILE* file, std::vector<char>& bytes) {
    const bool done = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    bytes.clear();
    return done;
}

bool write_stl(std::FILE* file, const Torus& torus) {
    std::vector<char> bytes(80, ' ');
    put(bytes, 2 * torus.rows * torus.columns);
    std::vector<Vec3f> row(torus.columns + 1), next(torus.columns + 1);
    for (std::uint32_t c = 0; c <= torus.columns; ++c) next[c] = torus.at(0, c);
    for (std::uint32_t r = 0; r < torus.rows; ++r) {
        row.swap(next);
        for (std::uint32_t c = 0; c <= torus.columns; ++c) next[c] = torus.at(r + 1, c);
        for (std::uint32_t c = 0; c < torus.columns; ++c)
            for (const auto& corners :
                 {std::array{row[c], row[c + 1], next[c + 1]}, std::array{row[c], next[c + 1], next[c]}}) {
                put(bytes, Vec3f{});
                for (const Vec3f& p : corners) put(bytes, p);
                put(bytes, std::uint16_t{0});
            }
        if (!write(file, bytes)) return false;
    }
    return true;
}

bool write_ply(std::FILE* file, const Torus& torus) {
    const std::uint32_t count = torus.rows * torus.columns;
    const std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(count) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(2 * count) +
        "\nproperty list uchar uint vertex_indices\nend_header\n";
    std::vector<char> bytes(header.begin(), header.end());
    for (std::uint32_t r = 0; r < torus.rows; ++r) {
        for (std::uint32_t c = 0; c < torus.columns; ++c) put(bytes, torus.at(r, c));
        if (!write(file, bytes)) return false;
    }
    const auto index = [&](std::uint32_t r, std::uint32_t c) {
        return r % torus.rows * torus.columns + c % torus.columns;
    };
    for (std::uint32_t r = 0; r < torus.rows; ++r) {
        for (std::uint32_t c = 0; c < torus.columns; ++c)
            for (const auto& corners : {std::array{index(r, c), index(r, c + 1), index(r + 1, c + 1)},
                                        std::array{index(r, c), index(r + 1, c + 1), index(r + 1, c)}}) {
                put(bytes, std::uint8_t{3});
                for (const std::uint32_t corner : corners) put(bytes, corner);
            }
        if (!write(file, bytes)) return false;
    }
    return true;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::fputs("usage: snug_large_scan FILE.stl|FILE.ply TRIANGLES\n", stderr);
        return 1;
    }
    const std::string name = arguments[1];
    const auto cells = std::max(std::strtoull(arguments[2], nullptr, 10) / 2, 9ull);
    const auto rows = static_cast<std::uint32_t>(std::sqrt(2.0 * static_cast<double>(cells)));
    const Torus torus{rows, static_cast<std::uint32_t>(cells / rows)};
    std::FILE* file = std::fopen(name.c_str(), "wb");
    if (file == nullptr) return std::perror(name.c_str()), 4;
    const bool ply = name.size() > 4 && name.compare(name.size() - 4, 4, ".ply") == 0;
    bool done = ply ? write_ply(file, torus) : write_stl(file, torus);
    done = std::fclose(file) == 0 && done;
    if (!done) std::fputs("the file could not be written\n", stderr);
    return done ? 0 : 4;
}

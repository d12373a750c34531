#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read.h"
#include "snug/words/words.h"

#include "tests/support/random.h"
#include "tests/support/read_checks.h"

namespace snug {
namespace {

using test::bytes_of;
using test::good;
using test::Random;

enum class Encoding { ascii, little, big };

struct Type {
    const char* name;
    const char* other_name;
    char kind;  // i: signed, u: unsigned, f: floating
    std::size_t size;
};
constexpr Type kTypes[] = {{"char", "int8", 'i', 1},     {"uchar", "uint8", 'u', 1},
                           {"short", "int16", 'i', 2},   {"ushort", "uint16", 'u', 2},
                           {"int", "int32", 'i', 4},     {"uint", "uint32", 'u', 4},
                           {"float", "float32", 'f', 4}, {"double", "float64", 'f', 8}};
constexpr int kIntegers = 6;

/// Writes a mesh as PLY with whatever the format allows around it. All numbers are whole and below 100, so
/// that every type holds them.
class PlyWriter {
  public:
    PlyWriter(Random& random, Encoding encoding) : random_(random), encoding_(encoding) {}

    std::string write(const std::vector<Vec3f>& vertices, const std::vector<Triangle>& triangles) {
        const char* ends[] = {"\n", "\r\n"};
        line_end_ = ends[random_.integer(0, 1)];
        line("ply");
        line(std::string("format ") +
             (encoding_ == Encoding::ascii    ? "ascii"
              : encoding_ == Encoding::little ? "binary_little_endian"
                                              : "binary_big_endian") +
             " 1.0");
        line("comment element vertex 7");
        const bool faces_first = random_.chance(0.3);
        if (random_.chance(0.5)) other_element();
        if (faces_first) faces(triangles);
        this->vertices(vertices);
        if (random_.chance(0.5)) other_element();
        if (!faces_first) faces(triangles);
        if (random_.chance(0.5)) other_element();
        line("end_header");
        return header_ + data_;
    }

  private:
    void line(const std::string& text) { header_ += text + line_end_; }

    std::string name(const Type& type) { return random_.chance(0.5) ? type.name : type.other_name; }
    const Type& any_type() { return kTypes[random_.integer(0, 7)]; }
    const Type& whole_type() { return kTypes[random_.integer(0, kIntegers - 1)]; }

    template <class T>
    void raw(T value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        if (encoding_ == Encoding::big) std::reverse(bytes, bytes + sizeof value);
        data_.append(bytes, sizeof value);
    }

    void put(const Type& type, int value) {
        if (encoding_ == Encoding::ascii) {
            data_ += std::to_string(value) + " ";
        } else if (type.kind == 'f') {
            type.size == 4 ? raw(static_cast<float>(value)) : raw(static_cast<double>(value));
        } else {
            type.size == 1   ? raw(static_cast<std::int8_t>(value))
            : type.size == 2 ? raw(static_cast<std::int16_t>(value))
                             : raw(static_cast<std::int32_t>(value));
        }
    }

    struct Extra {
        Type type;
        bool list;
        Type count;
    };

    std::vector<Extra> extras(const char* prefix) {
        std::vector<Extra> all;
        for (int i = random_.integer(0, 2); i > 0; --i) {
            all.push_back({any_type(), random_.chance(0.4), whole_type()});
            line("property " + (all.back().list ? "list " + name(all.back().count) + " " : std::string()) +
                 name(all.back().type) + " " + prefix + std::to_string(i));
        }
        return all;
    }

    void put(const std::vector<Extra>& all) {
        for (const Extra& extra : all) {
            const int count = extra.list ? random_.integer(0, 4) : 1;
            if (extra.list) put(extra.count, count);
            for (int i = 0; i < count; ++i) put(extra.type, random_.integer(0, 99));
        }
    }

    void end_element() {
        if (encoding_ == Encoding::ascii) data_ += line_end_;
    }

    void other_element() {
        const int count = random_.integer(0, 3);
        line("element edge" + std::to_string(count) + " " + std::to_string(count));
        const std::vector<Extra> all = extras("other");
        for (int i = 0; i < count && !all.empty(); ++i) put(all), end_element();
    }

    void vertices(const std::vector<Vec3f>& vertices) {
        line("element vertex " + std::to_string(vertices.size()));
        const std::vector<Extra> before = extras("before");
        Type types[3];
        for (int axis = 0; axis < 3; ++axis) {
            types[axis] = any_type();
            line("property " + name(types[axis]) + " " + std::string(1, static_cast<char>('x' + axis)));
        }
        const std::vector<Extra> after = extras("after");
        for (const Vec3f& v : vertices) {
            put(before);
            for (int axis = 0; axis < 3; ++axis) put(types[axis], static_cast<int>(v[axis]));
            put(after);
            end_element();
        }
    }

    void faces(const std::vector<Triangle>& triangles) {
        line("element face " + std::to_string(triangles.size()));
        const std::vector<Extra> before = extras("before");
        const Type count = whole_type(), index = whole_type();
        line("property list " + name(count) + " " + name(index) +
             (random_.chance(0.5) ? " vertex_indices" : " vertex_index"));
        const std::vector<Extra> after = extras("after");
        for (const Triangle& triangle : triangles) {
            put(before);
            put(count, 3);
            for (const std::uint32_t v : triangle) put(index, static_cast<int>(v));
            put(after);
            end_element();
        }
    }

    Random& random_;
    Encoding encoding_;
    std::string line_end_;
    std::string header_;
    std::string data_;
};

/// Whole coordinates from 0 to 99, vertices shared, every vertex used.
Mesh random_mesh(Random& random) {
    Mesh mesh;
    const int vertices = random.integer(3, 60);
    const auto any_vertex = [&] { return static_cast<std::uint32_t>(random.integer(0, vertices - 1)); };
    const auto coordinate = [&] { return static_cast<float>(random.integer(0, 99)); };
    for (int v = 0; v < vertices; ++v) {
        mesh.vertices.push_back({coordinate(), coordinate(), coordinate()});
        mesh.triangles.push_back({any_vertex(), static_cast<std::uint32_t>(v), any_vertex()});
    }
    return mesh;
}

TEST(ReadPly, RandomMeshesComeBackFromEveryTypeEncodingAndOrder) {
    for (int seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = random_mesh(random);
        const auto encoding = static_cast<Encoding>(seed % 3);
        const std::string file = PlyWriter(random, encoding).write(mesh.vertices, mesh.triangles);
        const Mesh read = good(read_mesh(bytes_of(file), ""));
        EXPECT_EQ(read.triangles, mesh.triangles);
        ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            EXPECT_EQ(vec_cast<double>(read.vertices[v]) + read.origin, vec_cast<double>(mesh.vertices[v]));
    }
}

TEST(ReadPly, EveryCutOfABinaryFileIsRefused) {
    for (int seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = random_mesh(random);
        const auto encoding = seed % 2 == 0 ? Encoding::little : Encoding::big;
        const std::string file = PlyWriter(random, encoding).write(mesh.vertices, mesh.triangles);
        for (std::size_t length = 0; length < file.size(); ++length) {
            const auto cut = read_mesh(bytes_of(file).first(length), "a.ply");
            ASSERT_FALSE(cut.has_value()) << length << " of " << file.size();
            ASSERT_FALSE(snug::text(cut.error().message).empty());
        }
    }
}

}  // namespace
}  // namespace snug

#include "snug/formats/mesh_files.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "snug/base/text.h"

#include "tests/support/random.h"

namespace snug {
namespace {

struct Surface {
    std::vector<Vec3f> vertices;
    std::vector<Triangle> triangles;
};

/// Reads numbers byte by byte, so that the test holds on any machine.
class FileReader {
  public:
    explicit FileReader(const FileBytes& file) : file_(file) {}

    [[nodiscard]] std::size_t left() const { return file_.size() - at_; }
    unsigned byte() { return at_ < file_.size() ? std::to_integer<unsigned>(file_[at_++]) : 0; }
    std::uint32_t integer() {
        std::uint32_t value = byte();
        value |= byte() << 8;
        value |= byte() << 16;
        return value | byte() << 24;
    }
    Vec3f vector() {
        Vec3f v;
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint32_t bits = integer();
            std::memcpy(&v[axis], &bits, sizeof(bits));
        }
        return v;
    }
    std::string text(std::size_t length) {
        std::string text;
        while (text.size() < length && left() > 0) text += static_cast<char>(byte());
        return text;
    }
    std::string line() {
        std::string text;
        while (left() > 0) {
            const char c = static_cast<char>(byte());
            if (c == '\n') break;
            text += c;
        }
        return text;
    }

  private:
    const FileBytes& file_;
    std::size_t at_ = 0;
};

bool same_bits(float a, float b) {
    return std::memcmp(&a, &b, sizeof(a)) == 0;
}

void expect_same_bits(Vec3f a, Vec3f b) {
    ASSERT_TRUE(same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z))
        << b.x << " " << b.y << " " << b.z;
}

Surface tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, -0.1f}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

/// Any finite float, with a bias to lengths of an ordinary object.
float random_float(test::Random& random) {
    if (random.chance(0.5)) return static_cast<float>(random.between(-1000, 1000));
    if (random.chance(0.3)) return static_cast<float>(random.integer(-200000, 200000)) / 20;
    const auto bits = static_cast<std::uint32_t>(random.bits());
    float value = 0;
    std::memcpy(&value, &bits, sizeof(bits));
    return std::isfinite(value) ? value : 0;
}

Surface random_surface(test::Random& random) {
    Surface surface;
    const int vertices = random.integer(3, 60);
    for (int i = 0; i < vertices; ++i)
        surface.vertices.push_back({random_float(random), random_float(random), random_float(random)});
    const auto vertex = [&] { return static_cast<std::uint32_t>(random.integer(0, vertices - 1)); };
    for (int i = random.integer(0, 80); i > 0; --i) {
        Triangle t;
        for (std::uint32_t& corner : t) corner = vertex();
        surface.triangles.push_back(t);
    }
    return surface;
}

TEST(MeshFiles, StlHoldsEveryTriangleWithItsNormal) {
    const Surface s = tetrahedron();
    const FileBytes file = write_stl(s.vertices, s.triangles, "Snug lower half");
    ASSERT_EQ(file.size(), 84 + 50 * 4u);
    FileReader bytes(file);
    EXPECT_EQ(bytes.text(80), "Snug lower half" + std::string(65, ' '));
    EXPECT_EQ(bytes.integer(), 4u);
    const Vec3f normals[] = {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}};
    for (std::size_t i = 0; i < s.triangles.size(); ++i) {
        const Vec3f normal = bytes.vector();
        EXPECT_NEAR(std::sqrt(dot(normal, normal)), 1, 1e-6);
        if (i < 3) expect_same_bits(normal, normals[i]);
        for (const std::uint32_t vertex : s.triangles[i])
            expect_same_bits(bytes.vector(), s.vertices[vertex]);
        EXPECT_EQ(bytes.byte() + bytes.byte(), 0u);
    }
}

TEST(MeshFiles, StlNormalsStandOnTheirTriangles) {
    test::Random random(3);
    for (int i = 0; i < 200; ++i) {
        const auto point = [&] {
            return vec_cast<float>(
                Vec3d{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)});
        };
        const std::vector<Vec3f> v{point(), point(), point()};
        const FileBytes file = write_stl(v, std::vector<Triangle>{{0, 1, 2}}, "");
        FileReader bytes(file);
        bytes.text(84);
        const Vec3d n = vec_cast<double>(bytes.vector());
        const Vec3d a = vec_cast<double>(v[1] - v[0]), b = vec_cast<double>(v[2] - v[0]);
        EXPECT_NEAR(dot(n, a), 0, 1e-5);
        EXPECT_NEAR(dot(n, b), 0, 1e-5);
        EXPECT_GT(dot(n, cross(a, b)), 0);
    }
}

TEST(MeshFiles, StlGivesATriangleWithoutAreaNoNormal) {
    const std::vector<Vec3f> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    const FileBytes file = write_stl(line, std::vector<Triangle>{{0, 1, 2}}, "");
    FileReader bytes(file);
    bytes.text(84);
    expect_same_bits(bytes.vector(), {0, 0, 0});
}

TEST(MeshFiles, StlIsNeverTakenForText) {
    for (const char* title : {"solid", "Solid foam", "  SOLID", "solidarity"}) {
        const FileBytes file = write_stl({}, {}, title);
        ASSERT_EQ(file.size(), 84u);
        FileReader bytes(file);
        EXPECT_EQ(bytes.text(80).substr(0, 7), "binary ");
    }
    const FileBytes file = write_stl({}, {}, std::string(200, 'x'));
    ASSERT_EQ(file.size(), 84u);
    FileReader bytes(file);
    EXPECT_EQ(bytes.text(80), std::string(80, 'x'));
    EXPECT_EQ(bytes.integer(), 0u);
}

void expect_ply(const Surface& s, std::optional<Color> color) {
    const FileBytes file = write_ply(s.vertices, s.triangles, color);
    FileReader bytes(file);
    std::vector<std::string> header;
    do {
        header.push_back(bytes.line());
        ASSERT_LT(header.size(), 20u);
    } while (header.back() != "end_header");
    std::erase_if(header, [](const std::string& line) { return line.rfind("comment ", 0) == 0; });
    std::vector<std::string> expected{"ply", "format binary_little_endian 1.0",
                                      "element vertex " + std::to_string(s.vertices.size())};
    for (const char* name : {"x", "y", "z"}) expected.push_back(std::string("property float ") + name);
    if (color)
        for (const char* name : {"red", "green", "blue"})
            expected.push_back(std::string("property uchar ") + name);
    expected.push_back("element face " + std::to_string(s.triangles.size()));
    expected.insert(expected.end(), {"property list uchar int vertex_indices", "end_header"});
    ASSERT_EQ(header, expected);
    for (const Vec3f vertex : s.vertices) {
        expect_same_bits(bytes.vector(), vertex);
        if (!color) continue;
        ASSERT_EQ(bytes.byte(), color->red);
        ASSERT_EQ(bytes.byte(), color->green);
        ASSERT_EQ(bytes.byte(), color->blue);
    }
    for (const Triangle& t : s.triangles) {
        ASSERT_EQ(bytes.byte(), 3u);
        for (const std::uint32_t vertex : t) ASSERT_EQ(bytes.integer(), vertex);
    }
    ASSERT_EQ(bytes.left(), 0u);
}

/// The vertices and triangles of a text file, whose lines begin with `vertex` and `face`.
void expect_text(const FileBytes& file, const Surface& s, const std::string& vertex, const std::string& face,
                 std::uint32_t first) {
    FileReader bytes(file);
    while (bytes.left() > 0 && file[file.size() - bytes.left()] == std::byte{'#'}) bytes.line();
    if (vertex.empty()) {
        ASSERT_EQ(bytes.line(), "OFF");
        ASSERT_EQ(bytes.line(),
                  std::to_string(s.vertices.size()) + " " + std::to_string(s.triangles.size()) + " 0");
    }
    for (const Vec3f expected : s.vertices) {
        std::istringstream line(bytes.line());
        std::string word;
        ASSERT_TRUE(vertex.empty() || (line >> word && word == vertex));
        Vec3f read;
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_TRUE(line >> word);
            char* end = nullptr;
            read[axis] = std::strtof(word.c_str(), &end);
            ASSERT_EQ(*end, '\0') << word;
        }
        ASSERT_FALSE(line >> word);
        expect_same_bits(read, expected);
    }
    for (const Triangle& t : s.triangles) {
        ASSERT_EQ(bytes.line(), face + " " + std::to_string(t[0] + first) + " " +
                                    std::to_string(t[1] + first) + " " + std::to_string(t[2] + first));
    }
    ASSERT_EQ(bytes.left(), 0u);
}

TEST(MeshFiles, EveryFormatReadsBackTheSame) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const Surface s = random_surface(random);
        expect_ply(s, std::nullopt);
        expect_ply(s, kLowerBlue);
        expect_ply(s, kUpperOrange);
        expect_text(write_obj(s.vertices, s.triangles), s, "v", "f", 1);
        expect_text(write_off(s.vertices, s.triangles), s, "", "3", 0);
        if (HasFatalFailure()) return;
    }
}

TEST(ShortestDigits, AreThoseThatAPersonWouldWrite) {
    const std::pair<float, const char*> cases[] = {
        {0.0f, "0"},
        {-0.0f, "-0"},
        {1.0f, "1"},
        {-12.7f, "-12.7"},
        {0.1f, "0.1"},
        {0.3f, "0.3"},
        {202.5f, "202.5"},
        {100.0f, "100"},
        {0.001f, "0.001"},
        {1e-7f, "1e-7"},
        {1.5e-10f, "1.5e-10"},
        {20480000.0f, "20480000"},
        {16777216.0f, "16777216"},
        {1e10f, "1e10"},
        {123456.79f, "123456.79"},
        {3.4028235e38f, "3.4028235e38"},
        {1.1754944e-38f, "1.1754944e-38"},
        {1e-45f, "1e-45"},
        {0.33333334f, "0.33333334"},
    };
    for (const auto& [value, text] : cases) EXPECT_EQ(shortest(value), text);
    EXPECT_EQ(shortest(std::numeric_limits<float>::infinity()), "inf");
    EXPECT_EQ(shortest(-std::numeric_limits<float>::infinity()), "-inf");
    EXPECT_EQ(shortest(std::numeric_limits<float>::quiet_NaN()), "nan");
}

TEST(ShortestDigits, ReadBackAsTheSameFloatAndNoFewerWould) {
    test::Random random(11);
    for (int i = 0; i < 100000; ++i) {
        const float value = i < 256 ? std::ldexp(1.0f, i - 149) : random_float(random);
        const std::string text = shortest(value);
        ASSERT_TRUE(same_bits(std::strtof(text.c_str(), nullptr), value)) << text;
        std::string digits = text.substr(0, text.find('e'));
        std::erase_if(digits, [](char c) { return c == '-' || c == '.'; });
        digits.erase(0, digits.find_first_not_of('0'));
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.size() < 2) continue;
        char fewer[32];
        std::snprintf(fewer, sizeof(fewer), "%.*e", static_cast<int>(digits.size()) - 2,
                      static_cast<double>(value));
        ASSERT_NE(std::strtof(fewer, nullptr), value) << text << " " << fewer;
    }
}

}  // namespace
}  // namespace snug

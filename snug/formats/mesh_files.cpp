#include "snug/formats/mesh_files.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "snug/base/text.h"

namespace snug {
namespace {

void append(FileBytes& file, std::string_view text) {
    const std::size_t end = file.size();
    file.resize(end + text.size());
    std::transform(text.begin(), text.end(), file.begin() + static_cast<std::ptrdiff_t>(end),
                   [](char c) { return static_cast<std::byte>(c); });
}

/// Appends `size` bytes to a file and fills them: little-endian, whatever the machine is.
class Record {
  public:
    Record(FileBytes& file, std::size_t size) : file_(file), at_(file.size()) { file.resize(at_ + size); }

    void put(std::uint8_t value) { file_[at_++] = std::byte{value}; }
    void put(std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) file_[at_ + i] = static_cast<std::byte>(value >> (8 * i) & 0xff);
        at_ += 4;
    }
    void put(Vec3f v) {
        for (int axis = 0; axis < 3; ++axis) {
            std::uint32_t bits = 0;
            static_assert(sizeof(float) == sizeof(bits));
            std::memcpy(&bits, &v[axis], sizeof(bits));
            put(bits);
        }
    }

  private:
    FileBytes& file_;
    std::size_t at_;
};

/// Of length 1, or 0 for a triangle without area; never -0, which some readers print.
Vec3f facet_normal(Vec3f a, Vec3f b, Vec3f c) {
    const Vec3d from = vec_cast<double>(a);
    const Vec3d normal = cross(vec_cast<double>(b) - from, vec_cast<double>(c) - from);
    const double length = std::sqrt(dot(normal, normal));
    if (!(length > 0)) return {};
    return vec_cast<float>(Vec3d{normal.x / length + 0.0, normal.y / length + 0.0, normal.z / length + 0.0});
}

/// Readers take a file for a text STL if it begins with this word, in whichever case.
bool begins_like_text_stl(std::string_view title) {
    title.remove_prefix(std::min(title.find_first_not_of(" \t\r\n"), title.size()));
    constexpr std::string_view kWord = "solid";
    return title.size() >= kWord.size() &&
           std::equal(kWord.begin(), kWord.end(), title.begin(), [](char word, char c) {
               return c == word || c == static_cast<char>(word - 'a' + 'A');
           });
}

std::string stl_header(std::string_view title) {
    std::string header = begins_like_text_stl(title) ? "binary " : "";
    header += title;
    header.resize(80, ' ');
    return header;
}

std::string ply_header(std::size_t vertices, std::size_t triangles, bool colored) {
    return "ply\nformat binary_little_endian 1.0\ncomment lengths in millimetres\nelement vertex " +
           std::to_string(vertices) + "\nproperty float x\nproperty float y\nproperty float z\n" +
           (colored ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "") +
           "element face " + std::to_string(triangles) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

void append_line(FileBytes& file, std::string_view start, Vec3f v) {
    append(file, start);
    append(file, shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + "\n");
}

/// `first`: the number of the first vertex in this format.
void append_line(FileBytes& file, std::string_view start, const Triangle& t, std::uint64_t first) {
    append(file, start);
    append(file, std::to_string(t[0] + first) + " " + std::to_string(t[1] + first) + " " +
                     std::to_string(t[2] + first) + "\n");
}

}  // namespace

FileBytes write_stl(std::span<const Vec3f> vertices, std::span<const Triangle> triangles,
                    std::string_view title) {
    FileBytes file;
    file.reserve(84 + 50 * triangles.size());
    append(file, stl_header(title));
    Record(file, 4).put(static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& t : triangles) {
        const Vec3f a = vertices[t[0]], b = vertices[t[1]], c = vertices[t[2]];
        Record facet(file, 50);  // the last two bytes, for attributes, stay 0
        for (const Vec3f v : {facet_normal(a, b, c), a, b, c}) facet.put(v);
    }
    return file;
}

FileBytes write_ply(std::span<const Vec3f> vertices, std::span<const Triangle> triangles,
                    std::optional<Color> color) {
    const std::string header = ply_header(vertices.size(), triangles.size(), color.has_value());
    FileBytes file;
    file.reserve(header.size() + 15 * vertices.size() + 13 * triangles.size());
    append(file, header);
    for (const Vec3f position : vertices) {
        Record vertex(file, color ? 15 : 12);
        vertex.put(position);
        if (!color) continue;
        for (const std::uint8_t channel : {color->red, color->green, color->blue}) vertex.put(channel);
    }
    for (const Triangle& t : triangles) {
        Record face(file, 13);
        face.put(std::uint8_t{3});
        for (const std::uint32_t vertex : t) face.put(vertex);
    }
    return file;
}

FileBytes write_obj(std::span<const Vec3f> vertices, std::span<const Triangle> triangles) {
    FileBytes file;
    append(file, "# lengths in millimetres\n");
    for (const Vec3f vertex : vertices) append_line(file, "v ", vertex);
    for (const Triangle& t : triangles) append_line(file, "f ", t, 1);
    return file;
}

FileBytes write_off(std::span<const Vec3f> vertices, std::span<const Triangle> triangles) {
    FileBytes file;
    append(file, "OFF\n" + std::to_string(vertices.size()) + " " + std::to_string(triangles.size()) + " 0\n");
    for (const Vec3f vertex : vertices) append_line(file, "", vertex);
    for (const Triangle& t : triangles) append_line(file, "3 ", t, 0);
    return file;
}

}  // namespace snug

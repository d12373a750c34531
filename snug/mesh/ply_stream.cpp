#include "snug/mesh/ply_stream.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/text.h"
#include "snug/mesh/ply_header.h"
#include "snug/mesh/ply_values.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/stl_layout.h"

namespace snug {
namespace {

constexpr std::uint64_t kMostVertices = std::numeric_limits<std::uint32_t>::max() - 1;

/// A number at its place within a record.
struct Field {
    std::size_t at = 0;
    PlyType type = PlyType::float32;
    friend bool operator==(Field, Field) = default;
};

/// Where the two kinds of records lie and what of them is wanted.
struct Layout {
    bool swapped = false;
    Records vertices, faces;
    std::array<Field, 3> coordinate;
    Field corner_count;  ///< of a face
    Field corners;       ///< the first of three

    /// x, y and z one after the other, as nearly all programs write vertices.
    [[nodiscard]] bool plain_floats() const {
        const std::size_t at = coordinate[0].at;
        return !swapped && coordinate == std::array{Field{at}, Field{at + 4}, Field{at + 8}};
    }
    /// As nearly all programs write faces: a byte and three little-endian 32-bit numbers.
    [[nodiscard]] bool usual() const {
        return !swapped && size_of(corner_count.type) == 1 && size_of(corners.type) == 4;
    }
};

tl::unexpected<Error> refuse(const std::string& why) {
    return fail(ErrorKind::input, why);
}

std::string shown_as(const PlyElement& element) {
    return "the element " + quoted(element.name) + " of this PLY";
}

/// Bytes of a record; faces are taken to be triangles. None where a list of another kind makes records
/// uneven.
std::optional<std::size_t> record_size(const PlyElement& element, std::size_t corners) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (property.count_type && i != corners) return {};
        size += property.count_type ? size_of(*property.count_type) + 3 * size_of(property.type)
                                    : size_of(property.type);
    }
    return size;
}

Field field_at(const PlyElement& element, std::size_t property) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < property; ++i) at += size_of(element.properties[i].type);
    return {at, element.properties[property].type};
}

Result<void> take_vertices(const PlyElement& element, const Records& records, Layout& layout) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = element.find(std::string(1, static_cast<char>('x' + axis)));
        if (at == element.properties.size()) return refuse("the vertices of this PLY have no x, y and z");
        layout.coordinate[axis] = field_at(element, at);
    }
    layout.vertices = records;
    return {};
}

Result<void> take_faces(const PlyElement& element, std::size_t corners, const Records& records,
                        Layout& layout) {
    const PlyProperty& list = element.properties[corners];
    if (!list.count_type || !is_integer(list.type))
        return refuse("the " + list.name + " of this PLY are no list of whole numbers");
    // Only what stands before the list counts here, and none of that is a list.
    layout.corner_count = {field_at(element, corners).at, *list.count_type};
    layout.corners = {layout.corner_count.at + size_of(*list.count_type), list.type};
    layout.faces = records;
    return {};
}

Result<Layout> layout_of(const PlyHeader& header, std::uint64_t file_size) {
    if (header.encoding == PlyEncoding::ascii)
        return refuse(
            "a PLY of text is not read in pieces: export it in binary form, or read it whole with "
            "--no-stream where there is memory for it");
    Layout layout;
    layout.swapped = header.encoding == PlyEncoding::big_endian;
    std::uint64_t at = header.bytes;
    for (const PlyElement& element : header.elements) {
        std::size_t corners = element.find("vertex_indices");
        if (corners == element.properties.size()) corners = element.find("vertex_index");
        if (element.name == "tristrips" && corners < element.properties.size())
            return refuse("triangle strips are not read in pieces: export the PLY with plain faces");
        const bool faces = element.name == "face" && corners < element.properties.size();
        const auto size = record_size(element, faces ? corners : element.properties.size());
        if (!size)
            return refuse(shown_as(element) + " has lists, so it is not read in pieces: leave them out");
        const Records records{at, *size == 0 ? 0 : element.count, std::max<std::size_t>(*size, 1)};
        if (records.count > (file_size - at) / records.bytes)
            return refuse("the file is too short for " + grouped(records.count) + " of " +
                          quoted(element.name) +
                          ": it is cut off, or has faces with other than three corners");
        at = records.end();
        Result<void> taken;
        if (element.name == "vertex") taken = take_vertices(element, records, layout);
        if (faces) taken = take_faces(element, corners, records, layout);
        if (!taken) return tl::unexpected(taken.error());
    }
    if (layout.vertices.bytes == 0) return refuse("the PLY has no element \"vertex\" with x, y and z");
    if (layout.vertices.count > kMostVertices) return refuse("there are more than 2^32 - 2 vertices");
    if (layout.faces.count == 0)
        return refuse(
            "there are no triangles in this file; a point cloud is not read in pieces: read it whole with "
            "--no-stream, thinned before where memory does not hold it");
    return layout;
}

class PlyTriangles {
  public:
    PlyTriangles(const Layout& layout, std::vector<Vec3f> vertices)
        : layout_(layout), vertices_(std::move(vertices)) {}

    /// The corners of one face.
    [[nodiscard]] static Result<std::array<std::uint32_t, 3>> indices(const Layout& layout, Bytes record,
                                                                      std::uint64_t number) {
        BinaryPlyValues values(record.subspan(layout.corner_count.at), layout.swapped);
        std::int64_t count = 0;
        (void)values.next_whole(layout.corner_count.type, count);
        if (count != 3)
            return refuse("face " + grouped(number + 1) + " has " + std::to_string(count) +
                          " corners: only triangles are read in pieces; export the mesh with triangles, or "
                          "read it whole with "
                          "--no-stream");
        std::array<std::uint32_t, 3> corners;
        for (std::uint32_t& corner : corners) {
            std::int64_t value = 0;
            (void)values.next_whole(layout.corners.type, value);
            if (value < 0 || static_cast<std::uint64_t>(value) >= layout.vertices.count)
                return tl::unexpected(ply_wrong_index("face", number, value, layout.vertices.count));
            corner = static_cast<std::uint32_t>(value);
        }
        return corners;
    }

    Result<void> operator()(const RecordPiece& piece, std::span<TriangleStream::Corners> corners) const {
        for (std::size_t f = usual_faces(piece, corners); f < piece.count; ++f) {
            const Bytes record = piece.bytes.subspan(f * layout_.faces.bytes, layout_.faces.bytes);
            const auto index = indices(layout_, record, piece.first + f);
            if (!index) return tl::unexpected(index.error());
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3f p = vertices_[(*index)[i]];
                if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                    return refuse("vertex " + grouped(std::uint64_t{(*index)[i]} + 1) +
                                  " has a coordinate that is not a number, or beyond 1e30: repair or "
                                  "export it again");
                corners[f][i] = p;
            }
        }
        return {};
    }

  private:
    /// The quick way for what nearly all files hold. Ends at the first face that needs a closer look.
    std::size_t usual_faces(const RecordPiece& piece, std::span<TriangleStream::Corners> corners) const {
        if (!layout_.usual()) return 0;
        const std::byte* at = piece.bytes.data() + layout_.corner_count.at;
        for (std::size_t f = 0; f < piece.count; ++f, at += layout_.faces.bytes) {
            const std::uint32_t a = read_u32(at + 1), b = read_u32(at + 5), c = read_u32(at + 9);
            if (at[0] != std::byte{3} || std::max({a, b, c}) >= vertices_.size()) return f;
            corners[f] = {vertices_[a], vertices_[b], vertices_[c]};
            if (!all_finite(corners.subspan(f, 1))) return f;
        }
        return piece.count;
    }

    Layout layout_;
    std::vector<Vec3f> vertices_;
};

Vec3d position(const Layout& layout, Bytes record) {
    if (layout.plain_floats()) {
        const std::byte* const at = record.data() + layout.coordinate[0].at;
        return vec_cast<double>(Vec3f{read_f32(at), read_f32(at + 4), read_f32(at + 8)});
    }
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis) {
        const Field& field = layout.coordinate[static_cast<std::size_t>(axis)];
        (void)BinaryPlyValues(record.subspan(field.at), layout.swapped).next(field.type, p[axis]);
    }
    return p;
}

/// Shows each vertex with its number, on several threads.
template <class Visit>
Result<void> pass_vertices(const ByteSource& source, const Layout& layout, const Progress& progress,
                           const Visit& visit) {
    return pass_records(
        source, layout.vertices,
        [&](const RecordPiece& piece) -> Result<void> {
            for (std::size_t v = 0; v < piece.count; ++v)
                visit(piece.first + v, position(layout, piece.bytes.subspan(v * layout.vertices.bytes,
                                                                            layout.vertices.bytes)));
            return {};
        },
        progress);
}

/// The origin that a mesh in memory would have: of the vertices that triangles use.
Result<Vec3d> used_origin(const ByteSource& source, const Layout& layout, const Progress& progress) {
    constexpr std::uint32_t kBits = 32;
    std::vector<std::atomic<std::uint32_t>> used(static_cast<std::size_t>(layout.vertices.count / kBits + 1));
    const auto marked = pass_records(
        source, layout.faces,
        [&](const RecordPiece& piece) -> Result<void> {
            for (std::size_t f = 0; f < piece.count; ++f) {
                const Bytes record = piece.bytes.subspan(f * layout.faces.bytes, layout.faces.bytes);
                const auto corners = PlyTriangles::indices(layout, record, piece.first + f);
                if (!corners) return tl::unexpected(corners.error());
                for (const std::uint32_t v : *corners)
                    used[v / kBits].fetch_or(std::uint32_t{1} << v % kBits, std::memory_order_relaxed);
            }
            return {};
        },
        part_of(progress, 0, 0.6));
    if (!marked) return tl::unexpected(marked.error());
    Box3d box;
    std::mutex joining;
    const auto measured = pass_records(
        source, layout.vertices,
        [&](const RecordPiece& piece) -> Result<void> {
            Box3d own;
            for (std::size_t i = 0; i < piece.count; ++i) {
                const auto v = static_cast<std::size_t>(piece.first + i);
                if ((used[v / kBits].load(std::memory_order_relaxed) >> v % kBits & 1) == 0) continue;
                own.include(
                    position(layout, piece.bytes.subspan(i * layout.vertices.bytes, layout.vertices.bytes)));
            }
            const std::lock_guard lock(joining);
            box.include(own);
            return {};
        },
        part_of(progress, 0.6, 1));
    if (!measured) return tl::unexpected(measured.error());
    return origin_for(box);
}

}  // namespace

Result<TriangleStream> open_ply_stream(ByteSource source, const Progress& progress) {
    std::vector<std::byte> beginning(
        static_cast<std::size_t>(std::min<std::uint64_t>(source.size, kLongestPlyHeader)));
    if (auto done = source.read(0, beginning); !done) return tl::unexpected(done.error());
    const auto header = read_ply_header(beginning, source.size);
    if (!header) return tl::unexpected(header.error());
    const auto layout = layout_of(*header, source.size);
    if (!layout) return tl::unexpected(layout.error());

    Vec3d origin;
    if (!has_float_vertices(*header)) {
        const auto found = used_origin(source, *layout, part_of(progress, 0, 0.6));
        if (!found) return tl::unexpected(found.error());
        origin = *found;
    }
    std::vector<Vec3f> vertices(static_cast<std::size_t>(layout->vertices.count));
    const auto kept =
        pass_vertices(source, *layout, part_of(progress, 0.6, 1), [&](std::uint64_t v, Vec3d p) {
            vertices[static_cast<std::size_t>(v)] = vec_cast<float>(p - origin);
        });
    if (!kept) return tl::unexpected(kept.error());
    // Shared, so that copies of the stream do not copy the vertices.
    const auto triangles = std::make_shared<const PlyTriangles>(*layout, std::move(vertices));
    TriangleStream stream(std::move(source), layout->faces,
                          [triangles](const RecordPiece& piece, std::span<TriangleStream::Corners> corners) {
                              return (*triangles)(piece, corners);
                          });
    return stream.with_vertices(layout->vertices.count, origin);
}

}  // namespace snug

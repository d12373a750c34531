#include "snug/formats/ply_stream.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/text.h"
#include "snug/formats/ply_header.h"
#include "snug/formats/ply_values.h"
#include "snug/formats/stl_layout.h"
#include "snug/mesh/left_out.h"
#include "snug/mesh/raw_mesh.h"

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
    std::optional<Field> corner_count;  ///< of a face, where it has a list
    std::array<Field, 3> corners;

    /// x, y and z one after the other, as nearly all programs write vertices.
    [[nodiscard]] bool plain_floats() const {
        const std::size_t at = coordinate[0].at;
        return !swapped && coordinate == std::array{Field{at}, Field{at + 4}, Field{at + 8}};
    }
    /// As nearly all programs write faces: a byte and three little-endian 32-bit numbers.
    [[nodiscard]] bool usual() const {
        return !swapped && corner_count && size_of(corner_count->type) == 1 && size_of(corners[0].type) == 4;
    }
};

tl::unexpected<Error> refuse(Message why) {
    return fail(ErrorKind::input, std::move(why));
}

/// Bytes of a record; faces are taken to be triangles. None where a list of another kind makes records
/// uneven.
std::optional<std::size_t> record_size(const PlyElement& element) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        const bool corners = element.corners.count == 1 && element.corners.first == i;
        if (property.count_type && !corners) return {};
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
        if (at == element.properties.size()) return refuse(say("ply.no_xyz"));
        layout.coordinate[axis] = field_at(element, at);
    }
    layout.vertices = records;
    return {};
}

Result<void> take_faces(const PlyElement& element, const Records& records, Layout& layout) {
    const auto [first, count] = element.corners;
    const PlyProperty& list = element.properties[first];
    layout.faces = records;
    if (count == 1) {
        if (!list.count_type || !is_integer(list.type))
            return refuse(say("ply.no_whole_numbers", {{"name", list.name}}));
        // Only what stands before the list counts here, and none of that is a list.
        layout.corner_count = Field{field_at(element, first).at, *list.count_type};
        const std::size_t at = layout.corner_count->at + size_of(*list.count_type);
        for (std::size_t i = 0; i < 3; ++i) layout.corners[i] = {at + i * size_of(list.type), list.type};
        return {};
    }
    if (count != 3) return refuse(say("ply.pieces_corners"));
    for (std::size_t i = 0; i < 3; ++i) layout.corners[i] = field_at(element, first + i);
    return {};
}

Result<Layout> layout_of(const PlyHeader& header, std::uint64_t file_size) {
    if (header.encoding == PlyEncoding::ascii) return refuse(say("ply.pieces_text"));
    Layout layout;
    layout.swapped = header.encoding == PlyEncoding::big_endian;
    std::uint64_t at = header.bytes;
    for (const PlyElement& element : header.elements) {
        if (element.name == "tristrips" && element.corners.count > 0) return refuse(say("ply.pieces_strips"));
        const bool faces = element.corners.count > 0;
        const auto size = record_size(element);
        if (!size) return refuse(say("ply.pieces_lists", {{"name", quoted(element.name)}}));
        const Records records{at, *size == 0 ? 0 : element.count, std::max<std::size_t>(*size, 1)};
        if (records.count > (file_size - at) / records.bytes)
            return refuse(
                say("ply.pieces_too_short", {{"count", records.count}, {"name", quoted(element.name)}}));
        at = records.end();
        Result<void> taken;
        if ((element.name == "vertex" && layout.vertices.bytes != 0) || (faces && layout.faces.bytes != 0))
            return refuse(say("ply.pieces_twice", {{"name", quoted(element.name)}}));
        if (element.name == "vertex") taken = take_vertices(element, records, layout);
        if (faces) taken = take_faces(element, records, layout);
        if (!taken) return tl::unexpected(taken.error());
    }
    if (layout.vertices.bytes == 0) return refuse(say("ply.no_vertices"));
    if (layout.vertices.count > kMostVertices) return refuse(say("mesh.too_many_vertices"));
    if (layout.faces.count == 0) return refuse(say("ply.pieces_cloud"));
    return layout;
}

class PlyTriangles {
  public:
    PlyTriangles(const Layout& layout, std::vector<Vec3f> vertices)
        : layout_(layout), vertices_(std::move(vertices)) {}

    /// The corners of one face.
    [[nodiscard]] static Result<std::array<std::uint32_t, 3>> indices(const Layout& layout, Bytes record,
                                                                      std::uint64_t number) {
        std::int64_t count = 3;
        if (layout.corner_count) count = whole_at(layout, record, *layout.corner_count);
        if (count != 3)
            return refuse(
                say("ply.pieces_face", {{"number", number + 1}, {"corners", std::to_string(count)}}));
        std::array<std::uint32_t, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t value = whole_at(layout, record, layout.corners[i]);
            if (value < 0 || static_cast<std::uint64_t>(value) >= layout.vertices.count)
                return tl::unexpected(ply_wrong_index(say("ply.face"), number, value, layout.vertices.count));
            corners[i] = static_cast<std::uint32_t>(value);
        }
        return corners;
    }

    Result<std::size_t> operator()(const RecordPiece& piece,
                                   std::span<TriangleStream::Corners> corners) const {
        for (std::size_t f = usual_faces(piece, corners); f < piece.count; ++f) {
            const Bytes record = piece.bytes.subspan(f * layout_.faces.bytes, layout_.faces.bytes);
            const auto index = indices(layout_, record, piece.first + f);
            if (!index) return tl::unexpected(index.error());
            for (std::size_t i = 0; i < 3; ++i) corners[f][i] = vertices_[(*index)[i]];
        }
        return usable_first(corners);
    }

  private:
    static std::int64_t whole_at(const Layout& layout, Bytes record, Field field) {
        std::int64_t value = 0;
        (void)BinaryPlyValues(record.subspan(field.at), layout.swapped).next_whole(field.type, value);
        return value;
    }

    /// The quick way for what nearly all files hold. Ends at the first face that needs a closer look.
    std::size_t usual_faces(const RecordPiece& piece, std::span<TriangleStream::Corners> corners) const {
        if (!layout_.usual()) return 0;
        const std::byte* at = piece.bytes.data() + layout_.corner_count->at;
        for (std::size_t f = 0; f < piece.count; ++f, at += layout_.faces.bytes) {
            const std::uint32_t a = read_u32(at + 1), b = read_u32(at + 5), c = read_u32(at + 9);
            if (at[0] != std::byte{3} || std::max({a, b, c}) >= vertices_.size()) return f;
            corners[f] = {vertices_[a], vertices_[b], vertices_[c]};
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

/// One bit for each vertex, set from several threads.
class VertexSet {
  public:
    explicit VertexSet(std::uint64_t count) : words_(static_cast<std::size_t>(count / kBits + 1)) {}
    void insert(std::size_t v) {
        words_[v / kBits].fetch_or(std::uint32_t{1} << v % kBits, std::memory_order_relaxed);
    }
    [[nodiscard]] bool holds(std::size_t v) const {
        return (words_[v / kBits].load(std::memory_order_relaxed) >> v % kBits & 1) != 0;
    }

  private:
    static constexpr std::uint32_t kBits = 32;
    std::vector<std::atomic<std::uint32_t>> words_;
};

/// The vertices of all faces that have none in `unusable`.
Result<VertexSet> used_vertices(const ByteSource& source, const Layout& layout, const VertexSet& unusable,
                                const Progress& progress) {
    VertexSet used(layout.vertices.count);
    const auto marked = pass_records(
        source, layout.faces,
        [&](const RecordPiece& piece) -> Result<void> {
            for (std::size_t f = 0; f < piece.count; ++f) {
                const Bytes record = piece.bytes.subspan(f * layout.faces.bytes, layout.faces.bytes);
                const auto corners = PlyTriangles::indices(layout, record, piece.first + f);
                if (!corners) return tl::unexpected(corners.error());
                const auto& [a, b, c] = *corners;
                if (unusable.holds(a) || unusable.holds(b) || unusable.holds(c)) continue;
                for (const std::uint32_t v : *corners) used.insert(v);
            }
            return {};
        },
        progress);
    if (!marked) return tl::unexpected(marked.error());
    return used;
}

/// The box of the vertices in `used`; puts those that are not usable() into `unusable` and says whether there
/// are any.
struct UsedBox {
    Box3d box;
    bool whole = true;
};
Result<UsedBox> box_of_used(const ByteSource& source, const Layout& layout, const VertexSet& used,
                            VertexSet& unusable, const Progress& progress) {
    UsedBox result;
    std::mutex joining;
    const auto measured = pass_records(
        source, layout.vertices,
        [&](const RecordPiece& piece) -> Result<void> {
            UsedBox own;
            for (std::size_t i = 0; i < piece.count; ++i) {
                const auto v = static_cast<std::size_t>(piece.first + i);
                if (!used.holds(v)) continue;
                const Vec3d p =
                    position(layout, piece.bytes.subspan(i * layout.vertices.bytes, layout.vertices.bytes));
                if (usable(p)) {
                    own.box.include(p);
                } else {
                    own.whole = false;
                    unusable.insert(v);
                }
            }
            const std::lock_guard lock(joining);
            result.box.include(own.box);
            result.whole = result.whole && own.whole;
            return {};
        },
        progress);
    if (!measured) return tl::unexpected(measured.error());
    return result;
}

/// The origin that a mesh in memory would have: of the vertices that triangles use. Where some of these are
/// no places, another round leaves out their triangles.
Result<Vec3d> used_origin(const ByteSource& source, const Layout& layout, const Progress& progress) {
    VertexSet unusable(layout.vertices.count);
    for (const auto& [from, to] : {std::pair{0.0, 0.5}, {0.5, 1.0}}) {
        const double middle = 0.5 * (from + to);
        const auto used = used_vertices(source, layout, unusable, part_of(progress, from, middle));
        if (!used) return tl::unexpected(used.error());
        const auto measured = box_of_used(source, layout, *used, unusable, part_of(progress, middle, to));
        if (!measured) return tl::unexpected(measured.error());
        if (measured->whole) return origin_for(measured->box);
    }
    return Vec3d{};
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
            constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
            vertices[static_cast<std::size_t>(v)] =
                usable(p) ? vec_cast<float>(p - origin) : Vec3f{kNone, kNone, kNone};
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

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/formats/ply_header.h"
#include "snug/formats/ply_values.h"
#include "snug/formats/read.h"
#include "snug/formats/read_cloud.h"
#include "snug/mesh/raw_mesh.h"

namespace snug {
namespace {

constexpr std::size_t kLeastTriangle = 4;  // bytes: a length and three corners

template <class Values, class Coordinate>
class PlyReader {
  public:
    PlyReader(const PlyHeader& header, Values values) : header_(header), values_(std::move(values)) {}

    Result<Mesh> read(bool as_cloud) {
        for (const PlyElement& element : header_.elements) {
            element_ = &element;
            if (element.properties.empty()) continue;
            if (!read_element(element)) return tl::unexpected(error_);
        }
        if (!has_vertices_) return fail(ErrorKind::input, say("ply.no_vertices"));
        for (const Faces& faces : early_faces_) {
            element_ = faces.element;
            values_ = faces.values;
            if (!read_faces()) return tl::unexpected(error_);
        }
        if (has_wrong_index_) return tl::unexpected(wrong_index_);
        if (as_cloud && mesh_.read.faces == 0) return finish_cloud(std::move(mesh_));
        return finish(std::move(mesh_));
    }

    [[nodiscard]] Values& values() { return values_; }

  private:
    /// Faces that come before vertices, and those after them, since triangles keep the order of the file:
    /// read once to get past them, and again when all vertices are known.
    struct Faces {
        const PlyElement* element;
        Values values;  ///< at the first of them
    };

    bool refuse(Message message) {
        error_ = {ErrorKind::input, std::move(message)};
        return false;
    }

    bool cut_off(std::size_t number) {
        const Message where =
            say("ply.element_of",
                {{"name", quoted(element_->name)}, {"number", number + 1}, {"count", element_->count}});
        if (const std::string_view word = values_.wrong_word(); !word.empty())
            return refuse(
                say("ply.no_number", {{"place", values_.place()}, {"word", quoted(word)}, {"where", where}}));
        return refuse(say("ply.cut_off", {{"place", values_.place()}, {"where", where}}));
    }

    bool read_element(const PlyElement& element) {
        if (element.name == "vertex") return read_vertices(element);
        if (element.corners.count > 0) return read_or_pass_faces(element);
        for (std::size_t i = 0; i < element.count; ++i) {
            values_.begin_record();
            for (const PlyProperty& property : element.properties)
                if (!skip(property)) return cut_off(i);
            end_record(i);
        }
        return true;
    }

    void end_record(std::size_t number) {
        values_.end_record([&] {
            std::uint64_t left = element_->count - number - 1;
            const PlyElement* const end = header_.elements.data() + header_.elements.size();
            for (const PlyElement* later = element_ + 1; later < end; ++later)
                if (!later->properties.empty()) left += later->count;
            return left;
        });
    }

    bool skip(const PlyProperty& property) {
        std::size_t count = 1;
        return (!property.count_type || read_list_length(property, count)) &&
               values_.skip(property.type, count);
    }

    bool read_list_length(const PlyProperty& property, std::size_t& length) {
        std::int64_t value = 0;
        if (!values_.next_whole(*property.count_type, value) || value < 0 ||
            static_cast<std::uint64_t>(value) > values_.left())  // size_t may have 32 bits only
            return false;
        length = static_cast<std::size_t>(value);
        return true;
    }

    bool read_vertices(const PlyElement& element) {
        std::vector<int> axis_of(element.properties.size(), -1);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = element.find(std::string(1, static_cast<char>('x' + axis)));
            if (at == element.properties.size() || element.properties[at].count_type)
                return refuse(say("ply.no_xyz"));
            axis_of[at] = axis;
        }
        has_vertices_ = true;
        mesh_.vertices.reserve(mesh_.vertices.size() + static_cast<std::size_t>(element.count));
        for (std::size_t v = 0; v < element.count; ++v) {
            Vec3<Coordinate> p;
            values_.begin_record();
            for (std::size_t i = 0; i < axis_of.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (axis_of[i] < 0 ? !skip(property) : !values_.next(property.type, p[axis_of[i]]))
                    return cut_off(v);
            }
            end_record(v);
            mesh_.vertices.push_back(p);
        }
        return true;
    }

    bool read_or_pass_faces(const PlyElement& element) {
        const PlyProperty& first = element.properties[element.corners.first];
        if (element.corners.count == 1 && (!first.count_type || !is_integer(first.type)))
            return refuse(say("ply.no_whole_numbers", {{"name", first.name}}));
        const bool last_vertices_are_known =
            std::none_of(&element, header_.elements.data() + header_.elements.size(),
                         [](const PlyElement& later) { return later.name == "vertex"; });
        if (last_vertices_are_known && early_faces_.empty()) return read_faces();
        early_faces_.push_back({&element, values_});
        passing_ = true;
        const bool good = read_faces();
        passing_ = false;
        return good;
    }

    bool read_faces() {
        const auto [first, count] = element_->corners;
        const std::size_t properties = element_->properties.size();
        const bool strips = element_->name == "tristrips";
        if (!passing_)
            mesh_.triangles.reserve(
                mesh_.triangles.size() +
                std::min(static_cast<std::size_t>(element_->count), values_.left() / kLeastTriangle));
        for (std::size_t f = 0; f < element_->count; ++f) {
            corners_.clear();
            values_.begin_record();
            for (std::size_t i = 0; i < properties; ++i) {
                const PlyProperty& property = element_->properties[i];
                if (i - first < count ? !read_corners(property) : !skip(property)) return cut_off(f);
            }
            end_record(f);
            if (!passing_ && !has_wrong_index_) append_face(f, strips);
        }
        return true;
    }

    /// Of a list, or one corner of those that stand by themselves.
    bool read_corners(const PlyProperty& property) {
        std::size_t length = 1;
        if (property.count_type && !read_list_length(property, length)) return false;
        for (std::size_t c = 0; c < length; ++c) {
            std::int64_t corner = 0;
            if (!values_.next_whole(property.type, corner)) return false;
            corners_.push_back(corner);
        }
        return true;
    }

    /// A file that is cut off says so, also where an index before the cut is wrong.
    void append_face(std::size_t number, bool strip) {
        polygon_.clear();
        for (const std::int64_t corner : corners_) {
            if (strip && corner == -1) {
                append_strip();
                polygon_.clear();
                continue;
            }
            if (corner < 0 || static_cast<std::uint64_t>(corner) >= mesh_.vertices.size()) {
                has_wrong_index_ = true;
                wrong_index_ = ply_wrong_index(say(strip ? "ply.strip" : "ply.face"), number, corner,
                                               mesh_.vertices.size());
                return;
            }
            polygon_.push_back(static_cast<std::uint32_t>(corner));
        }
        if (strip) return append_strip();
        ++mesh_.read.faces;
        append_polygon(mesh_, polygon_);
    }

    /// Every second triangle of a strip runs the other way; those that repeat a vertex only steer the strip.
    void append_strip() {
        for (std::size_t i = 0; i + 2 < polygon_.size(); ++i) {
            const std::uint32_t a = polygon_[i], b = polygon_[i + 1], c = polygon_[i + 2];
            if (a == b || b == c || c == a) continue;
            ++mesh_.read.faces;
            mesh_.triangles.push_back(i % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
        }
    }

    const PlyHeader& header_;
    Values values_;
    const PlyElement* element_ = nullptr;
    RawMeshOf<Coordinate> mesh_;
    std::vector<Faces> early_faces_;
    std::vector<std::int64_t> corners_;  // of the face at hand, as in the file
    std::vector<std::uint32_t> polygon_;
    bool passing_ = false;
    bool has_vertices_ = false;
    bool has_wrong_index_ = false;
    Error wrong_index_;
    Error error_;
};

/// Where lines seem to hold more than the header says, they may as well be broken anywhere: that is tried,
/// too, unless all is as it should be.
Result<Mesh> read_text(const PlyHeader& header, Bytes data, bool as_cloud) {
    using Values = AsciiPlyValues;
    PlyReader<Values, double> by_lines(header, Values(data, header.lines));
    Result<Mesh> mesh = by_lines.read(as_cloud);
    if (!by_lines.values().by_lines() || (mesh && by_lines.values().used_up())) return mesh;
    PlyReader<Values, double> by_words(header, Values(data, header.lines, Values::Lines::do_not_count));
    Result<Mesh> other = by_words.read(as_cloud);
    return other ? other : mesh;
}

Result<Mesh> read(Bytes file, bool as_cloud) {
    const auto header = read_ply_header(file);
    if (!header) return tl::unexpected(header.error());
    const Bytes data = file.subspan(std::min(header->bytes, file.size()));
    if (header->encoding == PlyEncoding::ascii) return read_text(*header, data, as_cloud);
    const BinaryPlyValues values(data, header->encoding == PlyEncoding::big_endian);
    return has_float_vertices(*header) ? PlyReader<BinaryPlyValues, float>(*header, values).read(as_cloud)
                                       : PlyReader<BinaryPlyValues, double>(*header, values).read(as_cloud);
}

}  // namespace

Result<Mesh> read_ply(Bytes file) {
    return read(file, false);
}

Result<Mesh> read_ply_or_cloud(Bytes file) {
    return read(file, true);
}

}  // namespace snug

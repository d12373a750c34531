#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "snug/base/text.h"
#include "snug/mesh/ply_header.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/read.h"
#include "snug/mesh/text_scan.h"

namespace snug {
namespace {

/// Values of a binary PLY, one after the other.
class BinaryValues {
  public:
    BinaryValues(Bytes data, bool big_endian) : data_(data), swapped_(big_endian) {}

    bool next(PlyType type, double& value) {
        switch (type) {
            case PlyType::int8:
                return take<std::int8_t>(value);
            case PlyType::uint8:
                return take<std::uint8_t>(value);
            case PlyType::int16:
                return take<std::int16_t>(value);
            case PlyType::uint16:
                return take<std::uint16_t>(value);
            case PlyType::int32:
                return take<std::int32_t>(value);
            case PlyType::uint32:
                return take<std::uint32_t>(value);
            case PlyType::float32:
                return take<float>(value);
            case PlyType::float64:
                return take<double>(value);
        }
        return false;
    }
    bool skip(PlyType type, std::size_t count) {
        if (count > (data_.size() - at_) / size_of(type)) return false;
        at_ += count * size_of(type);
        return true;
    }
    [[nodiscard]] std::size_t left() const { return data_.size() - at_; }
    [[nodiscard]] std::string place() const { return ""; }
    /// What stands where a value should; only text shows that.
    [[nodiscard]] std::string_view wrong_word() const { return {}; }

  private:
    template <class T>
    bool take(double& value) {
        if (data_.size() - at_ < sizeof(T)) return false;
        std::byte bytes[sizeof(T)];
        std::memcpy(bytes, data_.data() + at_, sizeof(T));
        if (swapped_) std::reverse(std::begin(bytes), std::end(bytes));
        T raw;
        std::memcpy(&raw, bytes, sizeof(T));
        value = static_cast<double>(raw);
        at_ += sizeof(T);
        return true;
    }

    Bytes data_;
    std::size_t at_ = 0;
    bool swapped_;
};

/// Values of an ASCII PLY. Writers do not agree on line ends, so words count, not lines.
class AsciiValues {
  public:
    AsciiValues(Bytes data, std::size_t header_lines)
        : text_(data), size_(data.size()), header_lines_(header_lines) {}

    bool next(PlyType, double& value) {
        word_ = text_.word_anywhere('\0');
        return to_number(word_, value);
    }
    bool skip(PlyType, std::size_t count) {
        for (; count > 0; --count) {
            word_ = text_.word_anywhere('\0');
            if (word_.empty()) return false;
        }
        return true;
    }
    [[nodiscard]] std::size_t left() const { return text_.at_end() ? 0 : size_; }
    [[nodiscard]] std::string place() const {
        return "line " + std::to_string(text_.line() + header_lines_) + ": ";
    }
    [[nodiscard]] std::string_view wrong_word() const { return word_; }

  private:
    TextScan text_;
    std::string_view word_;
    std::size_t size_;
    std::size_t header_lines_;
};

template <class Values>
class PlyReader {
  public:
    PlyReader(const PlyHeader& header, Values values) : header_(header), values_(std::move(values)) {}

    Result<Mesh> read() {
        for (const PlyElement& element : header_.elements) {
            element_ = &element;
            if (element.properties.empty()) continue;
            if (!read_element(element)) return tl::unexpected(error_);
        }
        if (!has_vertices_)
            return fail(ErrorKind::input, "the PLY has no element \"vertex\" with x, y and z");
        for (const Face& face : faces_)
            if (!append(face)) return tl::unexpected(error_);
        return finish(std::move(mesh_));
    }

  private:
    struct Face {
        std::size_t first, count;  ///< of its corners
        std::size_t number;        ///< within its element, from 0
        bool strip;
    };

    bool refuse(const std::string& message) {
        error_ = {ErrorKind::input, message};
        return false;
    }

    bool cut_off(std::size_t number) {
        const std::string where =
            quoted(element_->name) + " " + grouped(number + 1) + " of " + grouped(element_->count);
        if (const std::string_view word = values_.wrong_word(); !word.empty())
            return refuse(values_.place() + quoted(word) + " is no number that can stand in " + where);
        return refuse(values_.place() + "the file is cut off or damaged at " + where +
                      "; copy or export it again");
    }

    bool read_element(const PlyElement& element) {
        if (element.name == "vertex") return read_vertices(element);
        if (element.name == "face" || element.name == "tristrips") {
            std::size_t list = element.find("vertex_indices");
            if (list == element.properties.size()) list = element.find("vertex_index");
            if (list < element.properties.size()) return read_faces(element, list);
        }
        for (std::size_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties)
                if (!skip(property)) return cut_off(i);
        return true;
    }

    bool skip(const PlyProperty& property) {
        std::size_t count = 1;
        return (!property.count_type || read_list_length(property, count)) &&
               values_.skip(property.type, count);
    }

    bool read_list_length(const PlyProperty& property, std::size_t& length) {
        double value = 0;
        if (!values_.next(*property.count_type, value) || !(value >= 0) ||
            value > static_cast<double>(values_.left()) || value != std::floor(value))
            return false;
        length = static_cast<std::size_t>(value);
        return true;
    }

    bool read_vertices(const PlyElement& element) {
        const std::size_t axes[3] = {element.find("x"), element.find("y"), element.find("z")};
        for (const std::size_t axis : axes)
            if (axis == element.properties.size() || element.properties[axis].count_type)
                return refuse("the vertices of this PLY have no x, y and z");
        has_vertices_ = true;
        mesh_.vertices.reserve(element.count);
        for (std::size_t v = 0; v < element.count; ++v) {
            Vec3d p;
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const auto axis = std::find(std::begin(axes), std::end(axes), i) - std::begin(axes);
                const bool good = axis < 3
                                      ? values_.next(element.properties[i].type, p[static_cast<int>(axis)])
                                      : skip(element.properties[i]);
                if (!good) return cut_off(v);
            }
            mesh_.vertices.push_back(p);
        }
        return true;
    }

    bool read_faces(const PlyElement& element, std::size_t list) {
        if (!element.properties[list].count_type || !is_integer(element.properties[list].type))
            return refuse("the " + element.properties[list].name +
                          " of this PLY are no list of whole numbers");
        for (std::size_t f = 0; f < element.count; ++f) {
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const bool good =
                    i == list ? read_corners(element.properties[i], f) : skip(element.properties[i]);
                if (!good) return cut_off(f);
            }
        }
        return true;
    }

    bool read_corners(const PlyProperty& property, std::size_t number) {
        std::size_t length = 0;
        if (!read_list_length(property, length)) return false;
        faces_.push_back({corners_.size(), length, number, element_->name == "tristrips"});
        for (std::size_t c = 0; c < length; ++c) {
            double value = 0;
            if (!values_.next(property.type, value) || value != std::floor(value)) return false;
            corners_.push_back(static_cast<std::int64_t>(std::clamp(value, -2.0, 1e15)));
        }
        return true;
    }

    bool append(const Face& face) {
        polygon_.clear();
        for (const std::int64_t corner : std::span(corners_).subspan(face.first, face.count)) {
            if (face.strip && corner == -1) {
                append_strip();
                polygon_.clear();
                continue;
            }
            if (corner < 0 || corner >= static_cast<std::int64_t>(mesh_.vertices.size()))
                return refuse((face.strip ? "triangle strip " : "face ") + grouped(face.number + 1) +
                              " wants vertex " + std::to_string(corner) + ", but there are " +
                              counted(mesh_.vertices.size(), "vertex", "vertices") + ", counted from 0");
            polygon_.push_back(static_cast<std::uint32_t>(corner));
        }
        if (face.strip)
            append_strip();
        else if (polygon_.size() >= 3)
            append_polygon(mesh_, polygon_);
        return true;
    }

    /// Every second triangle of a strip runs the other way; those that repeat a vertex only steer the strip.
    void append_strip() {
        for (std::size_t i = 0; i + 2 < polygon_.size(); ++i) {
            const std::uint32_t a = polygon_[i], b = polygon_[i + 1], c = polygon_[i + 2];
            if (a == b || b == c || c == a) continue;
            mesh_.triangles.push_back(i % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
        }
    }

    const PlyHeader& header_;
    Values values_;
    const PlyElement* element_ = nullptr;
    RawMesh mesh_;
    std::vector<std::int64_t> corners_;
    std::vector<Face> faces_;
    std::vector<std::uint32_t> polygon_;
    bool has_vertices_ = false;
    Error error_;
};

}  // namespace

Result<Mesh> read_ply(Bytes file) {
    const auto header = read_ply_header(file);
    if (!header) return tl::unexpected(header.error());
    const Bytes data = file.subspan(std::min(header->bytes, file.size()));
    if (header->encoding == PlyEncoding::ascii)
        return PlyReader(*header, AsciiValues(data, header->lines)).read();
    return PlyReader(*header, BinaryValues(data, header->encoding == PlyEncoding::big_endian)).read();
}

}  // namespace snug

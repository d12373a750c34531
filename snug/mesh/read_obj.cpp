#include "snug/base/text.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/read.h"
#include "snug/mesh/text_scan.h"

namespace snug {
namespace {

/// The words of a statement, over lines that end with a backslash.
class Statement {
  public:
    explicit Statement(TextScan& text) : text_(text) {}

    std::string_view word() {
        for (;;) {
            std::string_view found = text_.word();
            const bool continued = !found.empty() && found.back() == '\\';
            if (!continued) return found;
            found.remove_suffix(1);
            text_.next_line();
            if (!found.empty()) return found;
        }
    }

  private:
    TextScan& text_;
};

class ObjReader {
  public:
    explicit ObjReader(Bytes file) : text_(file) {}

    Result<Mesh> read() {
        for (; !text_.at_end(); text_.next_line()) {
            Statement statement(text_);
            const std::string_view keyword = statement.word();
            if (keyword == "v" && !read_vertex(statement)) return tl::unexpected(error_);
            if ((keyword == "f" || keyword == "fo") && !read_face(statement)) return tl::unexpected(error_);
        }
        if (!highest_is_known()) return tl::unexpected(error_);
        for (const Polygon& polygon : polygons_)
            append_polygon(mesh_, std::span(corners_).subspan(polygon.first, polygon.count));
        return finish(std::move(mesh_));
    }

  private:
    struct Polygon {
        std::size_t first, count;
    };

    bool refuse(std::string message) {
        error_ = {ErrorKind::input, std::move(message)};
        return false;
    }

    bool read_vertex(Statement& statement) {
        Vec3d p;
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = statement.word();
            if (!to_number(word, p[axis]))
                return refuse(text_.place() + "a vertex needs three numbers, not " + quoted(word));
        }
        mesh_.vertices.push_back(p);
        return true;
    }

    /// Faces may come before their vertices, so positive indices are checked at the end.
    bool read_face(Statement& statement) {
        const std::size_t first = corners_.size();
        for (std::string_view word = statement.word(); !word.empty(); word = statement.word()) {
            std::int64_t index = 0;
            if (!to_number(word.substr(0, word.find('/')), index) || index == 0 || index > kMostVertices)
                return refuse(text_.place() + quoted(word) + " is no vertex number; they count from 1");
            const auto known = static_cast<std::int64_t>(mesh_.vertices.size());
            if (index < 0 && index < -known)
                return refuse(text_.place() + "the face wants vertex " + std::to_string(index) + " of only " +
                              counted(mesh_.vertices.size(), "vertex", "vertices") + " before it");
            const auto vertex = static_cast<std::uint32_t>(index < 0 ? known + index : index - 1);
            if (highest_line_ == 0 || vertex > highest_) {
                highest_ = vertex;
                highest_line_ = text_.line();
            }
            corners_.push_back(vertex);
        }
        const std::size_t count = corners_.size() - first;
        if (count < 3)
            return refuse(text_.place() + "a face has only " + counted(count, "corner", "corners"));
        polygons_.push_back({first, count});
        return true;
    }

    bool highest_is_known() {
        if (highest_line_ == 0 || highest_ < mesh_.vertices.size()) return true;
        return refuse("line " + std::to_string(highest_line_) + ": the face wants vertex " +
                      std::to_string(highest_ + 1ull) + ", but the file has " +
                      counted(mesh_.vertices.size(), "vertex", "vertices"));
    }

    static constexpr std::int64_t kMostVertices = 0xfffffffe;

    TextScan text_;
    RawMesh mesh_;
    std::vector<std::uint32_t> corners_;
    std::vector<Polygon> polygons_;
    std::uint32_t highest_ = 0;
    std::size_t highest_line_ = 0;
    Error error_;
};

}  // namespace

Result<Mesh> read_obj(Bytes file) {
    return ObjReader(file).read();
}

}  // namespace snug

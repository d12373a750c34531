#include <algorithm>

#include "snug/base/text.h"
#include "snug/formats/read.h"
#include "snug/formats/read_cloud.h"
#include "snug/formats/text_scan.h"
#include "snug/mesh/raw_mesh.h"

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

constexpr std::size_t kShortestLine = 8;  // bytes: "f 1 2 3" and its end

struct LineCounts {
    std::size_t vertices, faces;
};

/// About how many lines begin with "v " and "f " (rather a few more). Asked beforehand so that no list must
/// grow, which for a time takes its memory thrice. Counted in bytes by blocks, which compilers turn into
/// vector instructions.
LineCounts count_lines(Bytes file) {
    constexpr std::size_t kBlock = 128;
    // The first line, and those behind the last block.
    constexpr std::size_t kOutside = 2 + kBlock / kShortestLine;
    const auto* text = reinterpret_cast<const std::uint8_t*>(file.data());
    LineCounts counts{kOutside, kOutside};
    for (std::size_t at = 0; at + kBlock + 2 <= file.size(); at += kBlock) {
        std::uint8_t vertices = 0, faces = 0;
        for (std::size_t i = at; i < at + kBlock; ++i) {
            const int word = (text[i] == '\n') & (text[i + 2] == ' ');
            vertices = static_cast<std::uint8_t>(vertices + (word & (text[i + 1] == 'v')));
            faces = static_cast<std::uint8_t>(faces + (word & (text[i + 1] == 'f')));
        }
        counts.vertices += vertices;
        counts.faces += faces;
    }
    return counts;
}

class ObjReader {
  public:
    explicit ObjReader(Bytes file) : text_(file) {
        const LineCounts counts = count_lines(file);
        const std::size_t most = file.size() / kShortestLine;
        mesh_.vertices.reserve(std::min(counts.vertices, most));
        mesh_.triangles.reserve(std::min(counts.faces, most));
    }

    Result<Mesh> read(bool as_cloud) {
        for (; !text_.at_end(); text_.next_line()) {
            Statement statement(text_);
            const std::string_view keyword = statement.word();
            if (keyword == "v") {
                if (!read_vertex(statement)) return tl::unexpected(error_);
            } else if (keyword == "f" || keyword == "fo") {
                if (!read_face(statement)) return tl::unexpected(error_);
            } else if (keyword == "l" || keyword == "curv" || keyword == "surf") {
                has_curves_ = true;
            }
        }
        if (!highest_is_known()) return tl::unexpected(error_);
        for (const Polygon& polygon : waiting_)
            append_polygon(mesh_, std::span(waiting_corners_).subspan(polygon.first, polygon.count));
        const bool points_alone = mesh_.read.faces == 0 && !mesh_.vertices.empty();
        if (points_alone && has_curves_) return fail(ErrorKind::input, say("obj.no_faces"));
        return points_alone && as_cloud ? finish_cloud(std::move(mesh_)) : finish(std::move(mesh_));
    }

  private:
    struct Polygon {
        std::size_t first, count;  ///< of its waiting_corners_
    };

    bool refuse(Message message) {
        error_ = {ErrorKind::input, std::move(message)};
        return false;
    }

    bool read_vertex(Statement& statement) {
        Vec3d p;
        for (int axis = 0; axis < 3; ++axis) {
            if (text_.plain_number(p[axis])) continue;
            const std::string_view word = statement.word();
            if (!to_coordinate(word, p[axis]))
                return refuse(say("mesh.no_number_at", {{"place", text_.place()}, {"word", quoted(word)}}));
        }
        mesh_.vertices.push_back(p);
        return true;
    }

    /// Faces may come before their vertices, so positive indices are checked at the end.
    bool read_face(Statement& statement) {
        corners_.clear();
        const std::uint32_t highest_before = highest_;
        const std::size_t highest_line_before = highest_line_;
        for (;;) {
            std::uint32_t number = 0;
            if (text_.plain_whole(number, '/')) {
                add_corner(number - 1);
                continue;
            }
            const std::string_view word = statement.word();
            if (word.empty()) break;
            std::int64_t index = 0;
            if (!to_number(word.substr(0, word.find('/')), index) || index == 0 || index > kMostVertices)
                return refuse(say("obj.no_vertex", {{"place", text_.place()}, {"word", quoted(word)}}));
            const auto known = static_cast<std::int64_t>(mesh_.vertices.size());
            if (index < 0 && index < -known)
                return refuse(say("obj.few_before", {{"place", text_.place()},
                                                     {"index", std::to_string(index)},
                                                     {"vertices", mesh_.vertices.size()}}));
            add_corner(static_cast<std::uint32_t>(index < 0 ? known + index : index - 1));
        }
        ++mesh_.read.faces;
        if (corners_.size() >= 3) {
            append_or_wait();
        } else {
            ++mesh_.read.left_out_faces;
            highest_ = highest_before;
            highest_line_ = highest_line_before;
        }
        return true;
    }

    void add_corner(std::uint32_t vertex) {
        if (highest_line_ == 0 || vertex > highest_) {
            highest_ = vertex;
            highest_line_ = text_.line();
        }
        corners_.push_back(vertex);
    }

    /// Polygons are cut where their vertices lie: one that comes before its vertices must wait, and all after
    /// it, since triangles keep the order of the file.
    void append_or_wait() {
        if (waiting_.empty() && corners_.size() == 3) {
            mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
        } else if (waiting_.empty() && highest_ < mesh_.vertices.size()) {
            append_polygon(mesh_, corners_);
        } else {
            waiting_.push_back({waiting_corners_.size(), corners_.size()});
            waiting_corners_.insert(waiting_corners_.end(), corners_.begin(), corners_.end());
        }
    }

    bool highest_is_known() {
        if (highest_line_ == 0 || highest_ < mesh_.vertices.size()) return true;
        return refuse(say("obj.wrong_index", {{"place", at_line(highest_line_)},
                                              {"vertex", std::to_string(highest_ + 1ull)},
                                              {"vertices", mesh_.vertices.size()}}));
    }

    static constexpr std::int64_t kMostVertices = 0xfffffffe;

    TextScan text_;
    RawMesh mesh_;
    std::vector<std::uint32_t> corners_;  // of the face at hand
    std::vector<Polygon> waiting_;
    std::vector<std::uint32_t> waiting_corners_;
    std::uint32_t highest_ = 0;
    std::size_t highest_line_ = 0;
    bool has_curves_ = false;
    Error error_;
};

}  // namespace

Result<Mesh> read_obj(Bytes file) {
    return ObjReader(file).read(false);
}

Result<Mesh> read_obj_or_cloud(Bytes file) {
    return ObjReader(file).read(true);
}

}  // namespace snug

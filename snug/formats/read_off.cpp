#include <cstdint>
#include <optional>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/off_keyword.h"
#include "snug/formats/read.h"
#include "snug/formats/read_cloud.h"
#include "snug/formats/text_scan.h"
#include "snug/mesh/raw_mesh.h"

namespace snug {
namespace {

class OffReader {
  public:
    explicit OffReader(Bytes file) : text_(file), size_(file.size()) {}

    /// Most files have a line for each vertex and face, with more in it than is wanted. Others are numbers in
    /// a row, wherever lines end. The first way that uses up the file is right.
    Result<Mesh> read(bool as_cloud) {
        if (!read_header()) return tl::unexpected(error_);
        const TextScan data = text_;
        std::optional<Error> by_lines;
        std::optional<RawMesh> with_more;
        for (const auto& [vertices, faces] : {std::pair{true, true}, {false, false}, {false, true}}) {
            text_ = data;
            mesh_ = {};
            const bool good = read_vertices(vertices) && read_faces(faces);
            if (good && first_word(faces).empty()) return finished(std::move(mesh_), as_cloud);
            if (good && vertices) with_more = std::move(mesh_);
            if (!by_lines) by_lines = error_;
        }
        if (with_more) return finished(std::move(*with_more), as_cloud);
        return tl::unexpected(*by_lines);
    }

  private:
    [[nodiscard]] Result<Mesh> finished(RawMesh mesh, bool as_cloud) const {
        return as_cloud && faces_ == 0 ? finish_cloud(std::move(mesh)) : finish(std::move(mesh));
    }

    bool refuse(Message message) {
        error_ = {ErrorKind::input, std::move(message)};
        return false;
    }

    bool read_count(std::string_view word, const Message& what, std::size_t& count) {
        std::int64_t value = 0;
        const bool is_number = to_number(word, value);
        if (is_number && value > 0xfffffffe)
            return refuse(say("off.too_many", {{"place", text_.place()}, {"count", value}, {"what", what}}));
        if (!is_number || value < 0)
            return refuse(
                say("off.no_count", {{"place", text_.place()}, {"what", what}, {"word", quoted(word)}}));
        // Each vertex and face needs at least a digit and a blank.
        if (static_cast<std::uint64_t>(value) > size_)
            return refuse(say("off.too_short", {{"count", value}, {"what", what}}));
        count = static_cast<std::size_t>(value);
        return true;
    }

    bool read_header() {
        std::string_view word = text_.word_anywhere();
        std::int64_t count = 0;
        if (!to_number(word, count)) {
            const auto keyword = off_keyword(word);
            if (!keyword || keyword->other_space)
                return refuse(say("off.kind", {{"place", text_.place()}, {"word", quoted(word)}}));
            stride_ = keyword->stride();
            word = keyword->glued.empty() ? text_.word_anywhere() : keyword->glued;
        }
        if (same_word(word, "binary")) return refuse(say("off.binary"));
        if (!read_count(word, say("off.vertices"), vertices_) ||
            !read_count(text_.word_anywhere(), say("off.faces"), faces_))
            return false;
        pass_edge_count();
        return true;
    }

    /// Nobody needs the number of edges and some files lack it. It stands behind the faces or alone in a
    /// line.
    void pass_edge_count() {
        TextScan ahead = text_;
        if (ahead.word().empty()) {
            ahead.word_anywhere();
            if (!ahead.word().empty()) return;
        }
        text_ = ahead;
    }

    /// Goes to the next line that has a word and gives that word.
    std::string_view next_line_word() {
        if (!text_.at_end()) text_.next_line();
        return text_.word_anywhere();
    }

    /// The first word of a vertex or face.
    std::string_view first_word(bool by_lines) { return by_lines ? next_line_word() : text_.word_anywhere(); }
    std::string_view further_word(bool by_lines) { return by_lines ? text_.word() : text_.word_anywhere(); }

    bool read_vertices(bool by_lines) {
        mesh_.vertices.reserve(vertices_);
        for (std::size_t v = 0; v < vertices_; ++v) {
            Vec3d p;
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view word = axis == 0 ? first_word(by_lines) : further_word(by_lines);
                if (word.empty() && text_.at_end())
                    return refuse(say("off.few_vertices", {{"vertices", vertices_}, {"found", v}}));
                if (!to_coordinate(word, p[axis]))
                    return refuse(
                        say("mesh.no_number_at", {{"place", text_.place()}, {"word", quoted(word)}}));
            }
            for (std::size_t more = 3; !by_lines && more < stride_; ++more) text_.word_anywhere();
            mesh_.vertices.push_back(p);
        }
        return true;
    }

    bool read_faces(bool by_lines) {
        mesh_.read.faces = faces_;
        std::vector<std::uint32_t> corners;
        for (std::size_t f = 0; f < faces_; ++f) {
            std::int64_t count = 0;
            const std::string_view word = first_word(by_lines);
            if (word.empty() && text_.at_end())
                return refuse(say("off.few_faces", {{"faces", faces_}, {"found", f}}));
            if (!to_number(word, count) || count < 0 || static_cast<std::uint64_t>(count) > size_)
                return refuse(say("off.no_corners", {{"place", text_.place()}, {"word", quoted(word)}}));
            corners.clear();
            for (std::int64_t c = 0; c < count; ++c) {
                std::int64_t index = 0;
                const std::string_view shown = further_word(by_lines);
                if (!to_number(shown, index) || index < 0 || static_cast<std::uint64_t>(index) >= vertices_)
                    return refuse(
                        say("off.no_vertex", {{"place", text_.place()},
                                              {"word", quoted(shown)},
                                              {"last", std::to_string(vertices_ == 0 ? 0 : vertices_ - 1)}}));
                corners.push_back(static_cast<std::uint32_t>(index));
            }
            append_polygon(mesh_, corners);
        }
        return true;
    }

    TextScan text_;
    std::size_t size_;
    std::size_t vertices_ = 0;
    std::size_t faces_ = 0;
    std::size_t stride_ = 3;  ///< numbers of a vertex, where lines do not tell
    RawMesh mesh_;
    Error error_;
};

}  // namespace

Result<Mesh> read_off(Bytes file) {
    return OffReader(file).read(false);
}

Result<Mesh> read_off_or_cloud(Bytes file) {
    return OffReader(file).read(true);
}

}  // namespace snug

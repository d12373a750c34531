#include <algorithm>
#include <array>

#include "snug/base/text.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/read.h"
#include "snug/mesh/stl_kind.h"
#include "snug/mesh/stl_layout.h"
#include "snug/mesh/text_scan.h"
#include "snug/mesh/welder.h"

namespace snug {
namespace {

constexpr std::size_t kStart = 4096;  // bytes that are looked at to tell text from numbers

Result<Mesh> read_binary(Bytes file) {
    if (file.size() < kStlHeader)
        return fail(ErrorKind::input, "the file is cut off: a binary STL has at least 84 bytes, this one " +
                                          grouped(file.size()) + "; copy or export it again");
    const std::size_t count = read_u32(file.data() + 80);
    const std::size_t held = (file.size() - kStlHeader) / kStlFacet;
    if (held < count) return tl::unexpected(stl_cut_off(count, held));
    RawMeshOf<float> mesh;
    mesh.triangles.reserve(count);
    mesh.vertices.reserve(count / 2 + 3);
    Welder<float> welder(mesh, count);
    std::array<Welder<float>::Corners, Welder<float>::kBatch> batch;
    for (std::size_t t = 0; t < count; ++t) {
        Welder<float>::Corners& corners = batch[t % batch.size()];
        if (!read_stl_corners(file.data() + kStlHeader + t * kStlFacet, corners))
            return tl::unexpected(stl_not_finite(t, count));
        if (const std::size_t held_back = t % batch.size() + 1; held_back == batch.size() || t + 1 == count)
            welder.append(std::span(batch).first(held_back));
    }
    return finish(std::move(mesh));
}

class AsciiReader {
  public:
    explicit AsciiReader(Bytes file) : welder_(mesh_, file.size() / 120), text_(file) {}

    Result<Mesh> read() {
        for (; !text_.at_end(); text_.next_line())
            if (!read_line()) return fail(ErrorKind::input, text_.place() + problem_);
        if (in_facet_)
            return fail(ErrorKind::input,
                        text_.place() + "the file is cut off within its last facet; copy or export it again");
        if (in_solid_ && !mesh_.triangles.empty())
            return fail(ErrorKind::input, text_.place() +
                                              "the file is cut off: no \"endsolid\" stands behind its last "
                                              "facet; copy or export it again");
        return finish(std::move(mesh_));
    }

  private:
    bool refuse(std::string problem) {
        problem_ = std::move(problem);
        return false;
    }

    bool read_line() {
        const std::string_view word = text_.word('\0');
        if (word.empty()) return true;
        if (same_word(word, "vertex")) return read_vertex();
        if (same_word(word, "endloop")) return end_loop();
        if (corner_ != 0)
            return refuse("the facet before ends after " + counted(corner_, "vertex", "vertices"));
        if (same_word(word, "facet") || same_word(word, "outer")) return in_facet_ = true;
        if (same_word(word, "solid")) return in_solid_ = true;
        if (same_word(word, "endsolid")) {
            in_solid_ = false;
            return true;
        }
        return same_word(word, "endfacet") || refuse(quoted(word) + " does not belong into an STL file");
    }

    bool read_vertex() {
        Vec3d p;
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = text_.word('\0');
            if (!to_number(word, p[axis])) return refuse("a vertex needs three numbers, not " + quoted(word));
        }
        if (corner_ == 3) return refuse("a facet has more than three vertices");
        corners_[corner_++] = p;
        in_facet_ = true;
        return true;
    }

    bool end_loop() {
        if (corner_ != 3) return refuse("a facet has only " + counted(corner_, "vertex", "vertices"));
        welder_.append(std::span(&corners_, 1));
        corner_ = 0;
        in_facet_ = false;
        in_solid_ = true;
        return true;
    }

    RawMesh mesh_;
    Welder<double> welder_;
    TextScan text_;
    Welder<double>::Corners corners_;
    std::size_t corner_ = 0;
    bool in_facet_ = false;
    bool in_solid_ = false;
    std::string problem_;
};

/// How many triangles a binary STL says that it has.
std::size_t stated_count(Bytes file) {
    return read_u32(file.data() + 80);
}

bool holds_zero_bytes(Bytes start) {
    return std::find(start.begin(), start.end(), std::byte{0}) != start.end();
}

}  // namespace

bool is_whole_binary_stl(Bytes file) {
    return file.size() >= kStlHeader && (file.size() - kStlHeader) % kStlFacet == 0 &&
           (file.size() - kStlHeader) / kStlFacet == stated_count(file);
}

bool is_ascii_stl(Bytes file) {
    TextScan text(file.first(std::min(file.size(), kStart)));
    if (!same_word(text.word_anywhere('\0'), "solid")) return false;
    text.next_line();
    const std::string_view next = text.word_anywhere('\0');
    return same_word(next, "facet") || same_word(next, "endsolid");
}

/// Programs write "solid" at the start of binary files, too, and some put further bytes behind the triangles.
/// Text in the place of the count would be a count of more than 100 million.
Result<Mesh> read_stl(Bytes file) {
    if (is_whole_binary_stl(file)) return read_binary(file);
    if (is_ascii_stl(file)) return AsciiReader(file).read();
    const bool has_room =
        file.size() >= kStlHeader && (file.size() - kStlHeader) / kStlFacet >= stated_count(file);
    const Bytes start = file.first(std::min(file.size(), kStart));
    const bool says_solid = same_word(TextScan(start).word_anywhere('\0'), "solid");
    return !has_room && says_solid && !holds_zero_bytes(start) ? AsciiReader(file).read() : read_binary(file);
}

}  // namespace snug

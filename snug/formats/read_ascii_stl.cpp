#include <algorithm>
#include <array>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/stl_kind.h"
#include "snug/formats/text_scan.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/welder.h"

namespace snug {
namespace {

bool begins_comment(std::string_view word) {
    return word[0] == '#' || word[0] == ';' || word.substr(0, 2) == "//";
}

bool takes_coordinates(TextScan& text) {
    double value = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (!to_coordinate(text.word('\0'), value)) return false;
    return true;
}

/// Whether a facet begins with this word, of which the rest follows in the same line. A name may hold these
/// words as well, so more than one is asked for.
bool begins_facet(std::string_view word, TextScan behind) {
    if (same_word(word, "facet"))
        return same_word(behind.word('\0'), "normal") && takes_coordinates(behind) &&
               same_word(behind.word('\0'), "outer");
    return same_word(word, "outer") && same_word(behind.word('\0'), "loop") &&
           same_word(behind.word('\0'), "vertex") && takes_coordinates(behind);
}

class AsciiStlReader {
  public:
    explicit AsciiStlReader(Bytes file) : welder_(mesh_, file.size() / 120), text_(file) {}

    Result<Mesh> read() {
        while (!text_.at_end()) {
            const std::string_view word = text_.word('\0');
            if (word.empty())
                text_.next_line();
            else if (!take(word))
                return fail(ErrorKind::input,
                            say("at_place", {{"place", text_.place()}, {"problem", problem_}}));
        }
        if (in_facet_)
            return fail(ErrorKind::input, say("at_place", {{"place", text_.place()},
                                                           {"problem", say("stl.cut_off_in_facet")}}));
        mesh_.read.faces = mesh_.triangles.size() + mesh_.read.left_out_faces;
        mesh_.read.no_end = in_solid_;
        return finish(std::move(mesh_));
    }

  private:
    bool refuse(Message problem) {
        problem_ = std::move(problem);
        return false;
    }

    bool take(std::string_view word) {
        if (same_word(word, "vertex")) return read_vertex();
        if (same_word(word, "endloop") || same_word(word, "endfacet")) return end_facet();
        if (same_word(word, "facet")) return begin_facet();
        if (same_word(word, "outer")) return begin_loop();
        if (same_word(word, "loop")) return true;
        if (same_word(word, "solid")) return pass_name(true);
        if (same_word(word, "endsolid")) return pass_name(false);
        if (same_word(word, "end")) return take_end();
        if (begins_comment(word)) {
            text_.next_line();
            return true;
        }
        return pass_over(word);
    }

    /// "end loop", in two words.
    bool take_end() {
        const std::string_view word = text_.word('\0');
        if (same_word(word, "loop") || same_word(word, "facet")) return end_facet();
        if (same_word(word, "solid")) return pass_name(false);
        return word.empty() || refuse(say("stl.end", {{"word", quoted(word)}}));
    }

    /// Colours, attributes and whatever programs add between the facets. Within a loop other words may be
    /// damaged vertices.
    bool pass_over(std::string_view word) {
        double value = 0;
        return !in_loop_ || to_coordinate(word, value) || same_word(word, "color") ||
               same_word(word, "colour") || refuse(say("stl.foreign_word", {{"word", quoted(word)}}));
    }

    bool begin_facet() {
        end_facet();
        in_facet_ = true;
        TextScan ahead = text_;
        if (!same_word(ahead.word_anywhere('\0'), "normal")) return true;
        text_ = ahead;
        // The normal itself is not needed, and many are no numbers.
        double value = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (text_.plain_number(value)) continue;
            ahead = text_;
            if (!to_coordinate(ahead.word_anywhere('\0'), value)) break;
            text_ = ahead;
        }
        return true;
    }

    bool begin_loop() {
        if (corner_ > 0) end_facet();
        in_facet_ = in_loop_ = true;
        return true;
    }

    bool read_vertex() {
        if (corner_ == 3) return refuse(say("stl.four_corners"));
        Vec3d& p = corners_[corner_];
        for (int axis = 0; axis < 3; ++axis) {
            if (text_.plain_number(p[axis])) continue;
            const std::string_view word = text_.word_anywhere('\0');
            if (word.empty()) return refuse(say("stl.cut_off_in_facet"));
            if (!to_coordinate(word, p[axis])) return refuse(say("mesh.no_number", {{"word", quoted(word)}}));
        }
        ++corner_;
        in_facet_ = in_loop_ = true;
        return true;
    }

    bool end_facet() {
        if (!in_facet_) return true;
        if (corner_ == 3 && std::all_of(corners_.begin(), corners_.end(), [](Vec3d p) { return usable(p); }))
            welder_.append(std::span(&corners_, 1));
        else
            ++mesh_.read.left_out_faces;
        corner_ = 0;
        in_facet_ = in_loop_ = false;
        in_solid_ = true;
        return true;
    }

    /// Of a solid that begins or ends: the rest of the line, unless a facet begins in it.
    bool pass_name(bool begins) {
        end_facet();
        in_solid_ = begins;
        for (;;) {
            TextScan ahead = text_;
            const std::string_view word = ahead.word('\0');
            if (word.empty() || begins_facet(word, ahead)) return true;
            text_ = ahead;
        }
    }

    RawMesh mesh_;
    Welder<double> welder_;
    TextScan text_;
    Welder<double>::Corners corners_;
    std::size_t corner_ = 0;
    bool in_facet_ = false;
    bool in_loop_ = false;
    bool in_solid_ = false;
    Message problem_;
};

}  // namespace

bool is_ascii_stl(Bytes file) {
    TextScan text(file.first(std::min(file.size(), kStlKindBytes)));
    bool first = true;
    while (!text.at_end()) {
        const std::string_view word = text.word('\0');
        if (word.empty() || begins_comment(word)) {
            text.next_line();
            continue;
        }
        const bool facet = same_word(word, "facet"), loop = same_word(word, "outer");
        if (std::exchange(first, false) && !facet && !loop && !same_word(word, "solid")) return false;
        if (same_word(word, "endsolid")) return true;
        TextScan behind = text;
        if (facet && same_word(behind.word_anywhere('\0'), "normal")) return true;
        if (loop && same_word(behind.word_anywhere('\0'), "loop")) return true;
    }
    return false;
}

Result<Mesh> read_ascii_stl(Bytes file) {
    return AsciiStlReader(file).read();
}

}  // namespace snug

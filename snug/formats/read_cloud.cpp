#include "snug/formats/read_cloud.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/text_scan.h"
#include "snug/mesh/raw_mesh.h"

namespace snug {
namespace {

constexpr std::size_t kLeastPoint = 6;  // bytes: three digits, each with what ends it
constexpr std::size_t kLongestShown = 40;

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0' || c == '\x1a';
}

/// The first words of a line and how its columns stand apart.
struct Columns {
    std::array<std::string_view, 3> word;
    std::size_t count = 0;  ///< of all columns
    bool commas = false;
    bool semicolons = false;
    bool blanks_alone = false;  ///< somewhere nothing but blanks stands between two columns
};

/// 1.#QNAN is how old C libraries write what is no number, and no comment.
std::string_view without_comment(std::string_view line) {
    std::size_t mark = line.find('#');
    while (mark != std::string_view::npos && mark > 0 && line[mark - 1] == '.')
        mark = line.find('#', mark + 1);
    return line.substr(0, std::min(mark, line.find("//")));
}

Columns columns_of(std::string_view line) {
    Columns columns;
    bool mark = true;  // between the last column and here
    for (std::size_t at = 0; at < line.size();) {
        const char c = line[at];
        if (is_blank(c) || c == ',' || c == ';') {
            columns.commas |= c == ',';
            columns.semicolons |= c == ';';
            mark |= !is_blank(c);
            ++at;
            continue;
        }
        const std::size_t begin = at;
        while (at < line.size() && !is_blank(line[at]) && line[at] != ',' && line[at] != ';') ++at;
        columns.blanks_alone |= !mark;
        mark = false;
        if (columns.count < 3) columns.word[columns.count] = line.substr(begin, at - begin);
        ++columns.count;
    }
    return columns;
}

/// Goes through the lines of a text, whichever way they end.
class Lines {
  public:
    explicit Lines(std::string_view text) : text_(text) {
        if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
    }

    bool next(std::string_view& line) {
        if (at_ >= text_.size()) return false;
        const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
        line = text_.substr(at_, end - at_);
        at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
        ++number_;
        return true;
    }
    [[nodiscard]] Message place() const { return at_line(number_); }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
};

bool names_columns(const Columns& columns) {
    return columns.count >= 3 && same_word(columns.word[0], "x") && same_word(columns.word[1], "y") &&
           same_word(columns.word[2], "z");
}

/// Whether the commas between a line's numbers may as well be decimal commas.
bool is_ambiguous(const Columns& columns) {
    return columns.commas && (columns.semicolons || columns.blanks_alone);
}

}  // namespace

Result<Mesh> read_xyz(Bytes file) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    RawMesh raw;
    std::uint64_t promised = 0;
    bool first = true;
    Lines lines(text);
    for (std::string_view line; lines.next(line);) {
        const Columns columns = columns_of(without_comment(line));
        if (columns.count == 0) continue;
        if (std::exchange(first, false) && names_columns(columns)) continue;
        std::int64_t count = 0;
        if (columns.count == 1 && to_number(columns.word[0], count) && count >= 0) {
            promised += static_cast<std::uint64_t>(count);
            if (static_cast<std::uint64_t>(count) > file.size() / kLeastPoint + 1 || promised > file.size())
                return fail(ErrorKind::input,
                            say("cloud.too_short", {{"place", lines.place()}, {"count", count}}));
            continue;
        }
        if (is_ambiguous(columns))
            return fail(ErrorKind::input, say("cloud.decimal_commas", {{"place", lines.place()}}));
        Vec3d p;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (axis < columns.count && to_coordinate(columns.word[axis], p[static_cast<int>(axis)]))
                continue;
            if (axis >= columns.count)
                return fail(ErrorKind::input, say("cloud.too_few_numbers",
                                                  {{"place", lines.place()}, {"columns", columns.count}}));
            const std::string word = quoted(columns.word[axis].substr(0, kLongestShown));
            return fail(ErrorKind::input, say("cloud.no_number", {{"place", lines.place()}, {"word", word}}));
        }
        raw.vertices.push_back(p);
    }
    if (raw.vertices.size() < promised)
        return fail(ErrorKind::input,
                    say("cloud.cut_off", {{"promised", promised}, {"points", raw.vertices.size()}}));
    return finish_cloud(std::move(raw));
}

}  // namespace snug

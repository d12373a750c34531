#include "snug/fabricate/mill/gcode.h"

#include <array>
#include <cmath>
#include <string_view>

#include "snug/base/text.h"
#include "snug/drawing/svg.h"
#include "snug/fabricate/kit/plain_name.h"

namespace snug {
namespace {

constexpr std::size_t kLongestComment = 70;  // of GRBL's line of 80 characters
constexpr std::size_t kMostLines = 8;
constexpr std::string_view kCutOff = "...";

std::string comments(const std::string& words) {
    std::string lines;
    for (const std::string& line : wrapped(plain_name(words), kLongestComment, kMostLines))
        lines += "(" + line + ")\n";
    return lines;
}

/// The name has what the other words leave of one line.
std::string title_comment(const ProgramTitle& title) {
    const std::string what = plain_name(title.what), between = ". Object: ";
    const std::size_t taken = what.size() + between.size();
    std::string name = taken < kLongestComment ? plain_name(title.object_name) : "";
    const bool any_letter = name.find_first_not_of(" _.,:-+/=&'") != std::string::npos;
    if (!any_letter) return comments(what);
    if (taken + name.size() > kLongestComment) {
        name.resize(kLongestComment - taken - kCutOff.size());
        name += kCutOff;
    }
    return "(" + what + between + name + ")\n";
}

class Writer {
  public:
    Writer(Vec2d origin, const MillOptions& options) : origin_(origin), options_(options) {
        text_.reserve(1 << 16);
    }

    void begin() {
        text_ += "G21 G17 G90 G94 G54\n";
        text_ += "M3 S" + number(options_.spindle_rpm, 0) + "\n";
        text_ += "G4 P3\n";
        text_ += "G0 Z" + number(options_.safe_mm, 3) + "\n";
        last_[2] = number(options_.safe_mm, 3);
    }

    void add(const MillMove& move) {
        switch (move.kind) {
            case MillMove::Kind::rapid:
                line("G0", move.to, {});
                break;
            case MillMove::Kind::feed:
                line("G1", move.to, number(options_.feed_mm_min, 0));
                break;
            case MillMove::Kind::plunge:
                line("G1", move.to, number(options_.plunge_mm_min, 0));
                break;
            case MillMove::Kind::circle:
                circle(move);
                break;
        }
    }

    void end() { text_ += "M5\nM30\n"; }
    [[nodiscard]] std::string finish() { return std::move(text_); }

  private:
    /// Only what changes; nothing at all where nothing does.
    void line(const char* command, Vec3d to, const std::string& feed) {
        const std::array<std::string, 3> next{number(to.x - origin_.x, 3), number(to.y - origin_.y, 3),
                                              number(to.z, 3)};
        std::string words;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (next[axis] == last_[axis]) continue;
            words += std::string(" ") + "XYZ"[axis] + next[axis];
            last_[axis] = next[axis];
        }
        if (words.empty()) return;
        if (!feed.empty() && feed != feed_) {
            words += " F" + feed;
            feed_ = feed;
        }
        text_ += command + words + "\n";
    }

    /// A full turn needs its middle alone.
    void circle(const MillMove& move) {
        text_ += "G2 X" + last_[0] + " Y" + last_[1] + " I" + number(move.centre.x - move.to.x, 3) + " J" +
                 number(move.centre.y - move.to.y, 3);
        const std::string feed = number(options_.feed_mm_min, 0);
        if (feed != feed_) text_ += " F" + feed;
        feed_ = feed;
        text_ += "\n";
    }

    Vec2d origin_;
    const MillOptions& options_;
    std::array<std::string, 3> last_;
    std::string feed_, text_;
};

}  // namespace

std::string grbl_program(const MillPath& path, Vec2d stock_mm, const MillOptions& options,
                         const ProgramTitle& title, const std::vector<std::string>& remarks) {
    std::string text = title_comment(title);
    for (const std::string& remark : remarks) text += comments(remark);
    Writer writer(options.origin == MillOrigin::centre ? stock_mm * 0.5 : Vec2d{}, options);
    writer.begin();
    for (const MillMove& move : path.moves) writer.add(move);
    writer.end();
    return text + writer.finish();
}

}  // namespace snug

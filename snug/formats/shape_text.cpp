#include "snug/formats/shape_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/text_scan.h"

namespace snug {
namespace {

constexpr double kLeast = 0.1, kGreatest = 10000;
constexpr std::size_t kMostSolids = 100;

/// How a solid is written, in the order of their kinds: how many lengths follow its name, and an example.
struct Written {
    std::size_t lengths;
    const char* form;
};
constexpr Written kWritten[] = {
    {3, "box 143x87x40"}, {2, "cylinder 63x60"}, {3, "cone 80x40x120"}, {1, "ball 70"}};
static_assert(std::size(kWritten) == names_of<SolidKind>().size());

/// A cursor over words, numbers and signs; capitals do not matter.
class ShapeScan {
  public:
    explicit ShapeScan(std::string_view text) : text_(text) {
        if (text_.substr(0, 3) == "\xef\xbb\xbf") at_ = 3;
        pass_blanks();
    }

    [[nodiscard]] bool at_end() const { return at_ == text_.size(); }

    bool sign(char wanted) {
        if (at_end() || lower(text_[at_]) != wanted) return false;
        ++at_;
        pass_blanks();
        return true;
    }

    std::string_view letters() {
        const std::size_t begin = at_;
        while (!at_end() && lower(text_[at_]) >= 'a' && lower(text_[at_]) <= 'z') ++at_;
        const std::string_view word = text_.substr(begin, at_ - begin);
        pass_blanks();
        return word;
    }

    std::optional<double> number() {
        std::size_t end = at_;
        while (end < text_.size() && (is_digit(text_[end]) || text_[end] == '.' || text_[end] == '-')) ++end;
        double value = 0;
        if (!to_number(text_.substr(at_, end - at_), value)) return {};
        at_ = end;
        pass_blanks();
        return value;
    }

    /// So many numbers with a sign between them; none where they are not there.
    std::optional<std::array<double, 3>> numbers(std::size_t count, char between) {
        std::array<double, 3> found{};
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0 && !sign(between)) return {};
            const auto value = number();
            if (!value) return {};
            found[i] = *value;
        }
        return found;
    }

    /// What stands here, to be shown.
    [[nodiscard]] std::string rest() const {
        const std::string_view rest = text_.substr(at_);
        return quoted(rest.substr(0, std::min(rest.find_first_of(" \t\r\n+"), rest.size())), 30);
    }

  private:
    static char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

    void pass_blanks() {
        while (!at_end() && (text_[at_] == '#' || text_.find_first_of(" \t\r\n", at_) == at_))
            at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

class ShapeReader {
  public:
    explicit ShapeReader(std::string_view text) : scan_(text) {}

    Result<std::vector<SimpleSolid>> read() {
        if (scan_.at_end()) return fail(ErrorKind::input, say("shape.empty"));
        std::vector<SimpleSolid> solids;
        do {
            if (solids.size() == kMostSolids) return fail(ErrorKind::input, say("shape.many"));
            solid_ = {};
            if (!read_solid()) return tl::unexpected(Error{ErrorKind::input, *problem_});
            solids.push_back(solid_);
            ++number_;
        } while (scan_.sign('+'));
        if (!scan_.at_end()) return tl::unexpected(Error{ErrorKind::input, unknown("shape.rest")});
        return solids;
    }

  private:
    [[nodiscard]] Message unknown(const char* code) const {
        return say(code, {{"number", std::to_string(number_)}, {"word", scan_.rest()}});
    }

    bool refuse(Message message) {
        problem_ = std::move(message);
        return false;
    }

    bool read_solid() {
        const ShapeScan before = scan_;
        const std::string_view word = scan_.letters();
        const auto names = names_of<SolidKind>();
        const auto found = std::find_if(names.begin(), names.end(),
                                        [&](std::string_view name) { return same_word(word, name); });
        if (found == names.end()) {
            scan_ = before;
            if (scan_.at_end()) return refuse(say("shape.missing", {{"number", std::to_string(number_)}}));
            return refuse(unknown("shape.kind"));
        }
        solid_.kind = static_cast<SolidKind>(found - names.begin());
        return read_size(kWritten[found - names.begin()]) && read_choices();
    }

    bool read_size(const Written& written) {
        const auto given = scan_.numbers(written.lengths, 'x');
        if (!given)
            return refuse(say("shape.size", {{"number", std::to_string(number_)}, {"form", written.form}}));
        const auto [a, b, c] = *given;
        const bool tip = solid_.kind == SolidKind::cone && b == 0;
        for (std::size_t i = 0; i < written.lengths; ++i)
            if (!(tip && i == 1) && ((*given)[i] < kLeast || (*given)[i] > kGreatest))
                return refuse(say("shape.range", {{"number", std::to_string(number_)},
                                                  {"value", snug::number((*given)[i], 3)}}));
        if (solid_.kind == SolidKind::box) solid_.size_mm = {a, b, c};
        if (solid_.kind == SolidKind::cylinder) solid_.size_mm = {a, a, b};
        if (solid_.kind == SolidKind::cone) solid_.size_mm = {a, a, c}, solid_.top_mm = b;
        if (solid_.kind == SolidKind::ball) solid_.size_mm = {a, a, a};
        return true;
    }

    bool read_choices() {
        for (ShapeScan before = scan_; !scan_.at_end(); before = scan_) {
            const std::string_view word = scan_.letters();
            const bool good = same_word(word, "at")      ? read_three(kGreatest, solid_.centre_mm)
                              : same_word(word, "turn")  ? read_three(360, solid_.turn_deg)
                              : same_word(word, "along") ? read_axis()
                              : same_word(word, "r")     ? read_radius()
                                                         : false;
            if (problem_) return false;
            if (good) continue;
            scan_ = before;
            return word.empty() || refuse(unknown("shape.rest"));
        }
        return true;
    }

    bool read_three(double most, Vec3d& into) {
        const auto given = scan_.numbers(3, ',');
        if (!given) return false;
        for (std::size_t i = 0; i < 3; ++i)
            if (std::fabs((*given)[i]) > most)
                return refuse(say("shape.far", {{"number", std::to_string(number_)},
                                                {"value", snug::number((*given)[i], 3)},
                                                {"most", snug::number(most, 0)}}));
        into = {(*given)[0], (*given)[1], (*given)[2]};
        return true;
    }

    bool read_axis() {
        if (solid_.kind != SolidKind::cylinder && solid_.kind != SolidKind::cone) return false;
        for (const char axis : {'x', 'y', 'z'})
            if (scan_.sign(axis)) {
                solid_.along = axis;
                return true;
            }
        return false;
    }

    bool read_radius() {
        const auto given = scan_.number();
        if (!given || solid_.kind != SolidKind::box) return false;
        const double shortest = std::min({solid_.size_mm.x, solid_.size_mm.y, solid_.size_mm.z});
        if (*given < 0 || *given > shortest / 2)
            return refuse(say("shape.radius", {{"number", std::to_string(number_)},
                                               {"radius", snug::number(*given, 3)},
                                               {"most", snug::number(shortest / 2, 3)}}));
        solid_.radius_mm = *given;
        return true;
    }

    ShapeScan scan_;
    SimpleSolid solid_;
    std::size_t number_ = 1;
    std::optional<Message> problem_;
};

std::string three(Vec3d v, const char* between) {
    return number(v.x, 3) + between + number(v.y, 3) + between + number(v.z, 3);
}

std::string text_of(const SimpleSolid& solid) {
    const Vec3d size = solid.size_mm;
    std::string text(name_of(solid.kind));
    text += ' ' + (solid.kind == SolidKind::box        ? three(size, "x")
                   : solid.kind == SolidKind::cylinder ? number(size.x, 3) + 'x' + number(size.z, 3)
                   : solid.kind == SolidKind::cone     ? three({size.x, solid.top_mm, size.z}, "x")
                                                       : number(size.x, 3));
    if (solid.radius_mm > 0) text += " r" + number(solid.radius_mm, 3);
    if (solid.along != 'z') text += std::string(" along ") + solid.along;
    if (solid.turn_deg != Vec3d()) text += " turn " + three(solid.turn_deg, ",");
    if (solid.centre_mm != Vec3d()) text += " at " + three(solid.centre_mm, ",");
    return text;
}

}  // namespace

Result<std::vector<SimpleSolid>> parse_shape(std::string_view text) {
    return ShapeReader(text).read();
}

std::string shape_text(const std::vector<SimpleSolid>& solids) {
    std::string text;
    for (const SimpleSolid& solid : solids) text += (text.empty() ? "" : " + ") + text_of(solid);
    return text;
}

}  // namespace snug

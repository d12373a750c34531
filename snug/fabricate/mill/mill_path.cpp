#include "snug/fabricate/mill/mill_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "snug/fabricate/mill/nearest_first.h"

namespace snug {
namespace {

constexpr double kLongestLink = 3;  // diameters that the cutter goes through the pocket instead of over it
constexpr double kAbove = 0.5;      // mm above what stands where the slow plunge begins
constexpr double kSame = 1e-6;      // mm

double distance(Vec3d a, Vec3d b) {
    const Vec3d d = b - a;
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

/// Begins above the origin, at the safe height.
class PathBuilder {
  public:
    PathBuilder(const MillField& field, const MillOptions& options)
        : field_(field),
          options_(options),
          links_mm_(kLongestLink * options.cutter_mm),
          at_{0, 0, options.safe_mm} {}

    void drill(const MillPin& pin) {
        const double around = (options_.pin_mm - options_.cutter_mm) / 2;
        go_over({pin.at.x + around, pin.at.y});
        const int turns = std::max(1, static_cast<int>(std::ceil(pin.depth_mm / field_.step_mm)));
        for (int turn = 1; turn <= turns; ++turn) {
            down_to(-pin.depth_mm * turn / turns);
            if (around > kSame) circle(pin.at, around);
        }
    }

    void cut(const CentreLines& lines, const std::vector<CutLine>& cuts) {
        for (const CutLine& line : nearest_first(cuts, Vec2d{at_.x, at_.y}, links_mm_)) {
            reach(lines, line.from);
            feed({line.to.x, line.to.y, at_.z});
        }
    }

    /// There and back; or down from above, step by step.
    void relieve(const CentreLines& lines, const MillRelief& relief) {
        if (relief.from) {
            reach(lines, *relief.from);
            feed({relief.at.x, relief.at.y, at_.z});
            feed({relief.from->x, relief.from->y, at_.z});
            return;
        }
        go_over(relief.at);
        for (int level = field_.top - 1; level >= relief.level; --level) down_to(depth_of(level));
    }

    void engrave(std::span<const Vec2d> line, double depth_mm) {
        go_over(line.front());
        const int row = static_cast<int>(line.front().y / field_.cell_mm.y),
                  column = static_cast<int>(line.front().x / field_.cell_mm.x);
        down_to(depth_of(field_.height(row, column)) - depth_mm);
        for (const Vec2d to : line) feed({to.x, to.y, at_.z});
    }

    void finish() { up(); }
    [[nodiscard]] bool full() const { return path_.moves.size() >= kMostMoves; }
    [[nodiscard]] MillPath& path() { return path_; }

  private:
    [[nodiscard]] double depth_of(int level) const { return (level - field_.top) * field_.step_mm; }

    /// At the start of a line, at the level's depth.
    void reach(const CentreLines& lines, Vec2d to) {
        const Vec2d from{at_.x, at_.y};
        const double depth = depth_of(lines.level());
        if (!above_ && std::abs(at_.z - depth) < kSame) {
            if (length(to - from) < kSame) return;
            for (const Vec2d corner : {to, Vec2d{to.x, from.y}, Vec2d{from.x, to.y}}) {
                if (length(corner - from) + length(to - corner) > links_mm_) continue;
                if (!lines.free(from, corner) || !lines.free(corner, to)) continue;
                feed({corner.x, corner.y, depth});
                feed({to.x, to.y, depth});
                return;
            }
        }
        go_over(to);
        // The pass before has cut down to one step above.
        const double before = depth + field_.step_mm + kAbove;
        if (before < 0) feed({to.x, to.y, before});
        down_to(depth);
    }

    void go_over(Vec2d to) {
        up();
        rapid({to.x, to.y, options_.safe_mm});
    }
    void up() {
        if (!above_) rapid({at_.x, at_.y, options_.safe_mm});
    }
    void rapid(Vec3d to) {
        add({MillMove::Kind::rapid, to, {}}, kRapidFeed);
        above_ = true;
    }
    void feed(Vec3d to) {
        if (distance(at_, to) < kSame) return;
        path_.cut_mm += distance(at_, to);
        add({MillMove::Kind::feed, to, {}}, options_.feed_mm_min);
        above_ = false;
    }
    void down_to(double z) {
        path_.cut_mm += std::abs(z - at_.z);
        add({MillMove::Kind::plunge, {at_.x, at_.y, z}, {}}, options_.plunge_mm_min);
        above_ = false;
    }
    void circle(Vec2d centre, double radius) {
        const double way = 2 * std::numbers::pi * radius;
        path_.cut_mm += way;
        path_.minutes += way / options_.feed_mm_min;
        path_.moves.push_back({MillMove::Kind::circle, at_, centre});
    }
    void add(const MillMove& move, double mm_a_minute) {
        path_.minutes += distance(at_, move.to) / mm_a_minute;
        path_.moves.push_back(move);
        at_ = move.to;
    }

    const MillField& field_;
    const MillOptions& options_;
    double links_mm_;
    MillPath path_;
    Vec3d at_;
    bool above_ = true;  ///< at the safe height
};

/// Ways there and back as lines, so that they are put into the order of the others.
std::vector<MillRelief> in_order(std::vector<MillRelief> reliefs, double reach) {
    std::vector<CutLine> starts;
    for (const MillRelief& relief : reliefs) starts.push_back({relief.from.value_or(relief.at), relief.at});
    std::vector<MillRelief> ordered;
    for (const std::size_t i : nearest_first_order(starts, {0, 0}, reach)) ordered.push_back(reliefs[i]);
    return ordered;
}

}  // namespace

MillPath mill_path(const MillField& field, const std::vector<LevelPass>& passes,
                   const std::vector<MillRelief>& reliefs, const std::vector<MillPin>& pins,
                   const MillOptions& options) {
    PathBuilder builder(field, options);
    for (const MillPin& pin : pins) builder.drill(pin);
    for (const LevelPass& pass : passes) {
        const CentreLines lines(field, pass.level, options.cutter_mm / 2);
        builder.cut(lines, pass.fill);
        builder.cut(lines, pass.walls);
        std::vector<MillRelief> here;
        std::copy_if(reliefs.begin(), reliefs.end(), std::back_inserter(here),
                     [&](const MillRelief& each) { return each.from && each.level == pass.level; });
        for (const MillRelief& relief : in_order(std::move(here), options.cutter_mm))
            builder.relieve(lines, relief);
        ++builder.path().levels;
        if (builder.full()) break;
    }
    std::vector<MillRelief> from_above;
    std::copy_if(reliefs.begin(), reliefs.end(), std::back_inserter(from_above),
                 [](const MillRelief& each) { return !each.from; });
    for (const MillRelief& relief : in_order(std::move(from_above), options.cutter_mm)) {
        if (builder.full()) break;
        builder.relieve(CentreLines(field, field.top, options.cutter_mm / 2), relief);
    }
    builder.path().too_long = builder.full();
    builder.finish();
    return std::move(builder.path());
}

MillPath engraving_path(const MillField& field, std::span<const std::vector<Vec2d>> lines, double depth_mm,
                        const MillOptions& options) {
    PathBuilder builder(field, options);
    for (const std::vector<Vec2d>& line : lines)
        if (!line.empty()) builder.engrave(line, depth_mm);
    builder.finish();
    return std::move(builder.path());
}

}  // namespace snug

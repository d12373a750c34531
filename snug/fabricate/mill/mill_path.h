#pragma once

#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/design/mill_options.h"
#include "snug/fabricate/mill/mill_pins.h"
#include "snug/fabricate/mill/mill_relief.h"

namespace snug {

/// One move of the cutter's end, x and y as in mill_field.h, z = 0 at the top of the stock.
struct MillMove {
    enum class Kind {
        rapid,   ///< through air
        feed,    ///< cutting sideways, or down through what is cut already
        plunge,  ///< down into foam
        circle,  ///< a full turn, clockwise from above, about `centre`, ending where it began
    };
    Kind kind = Kind::rapid;
    Vec3d to;
    Vec2d centre;
};

struct MillPath {
    std::vector<MillMove> moves;
    int levels = 0;         ///< passes
    double cut_mm = 0;      ///< way at the feeds
    double minutes = 0;     ///< at the feeds, rapid moves at kRapidFeed
    bool too_long = false;  ///< broken off at kMostMoves
};

constexpr double kRapidFeed = 5000;  // mm a minute: what hobby machines do
constexpr std::size_t kMostMoves = 2'000'000;

/// The pins' holes first, then level by level from above: the filling, the walls, the reliefs. Neighbouring
/// lines are joined where the cutter can go straight without leaving the pocket; everything else goes over
/// the safe height.
[[nodiscard]] MillPath mill_path(const MillField& field, const std::vector<LevelPass>& passes,
                                 const std::vector<MillRelief>& reliefs, const std::vector<MillPin>& pins,
                                 const MillOptions& options);

/// The way of a pointed cutter along open lines (x and y as in mill_field.h), one after another, so deep into
/// the foam that stands where each begins.
[[nodiscard]] MillPath engraving_path(const MillField& field, std::span<const std::vector<Vec2d>> lines,
                                      double depth_mm, const MillOptions& options);

}  // namespace snug

#pragma once

#include <span>
#include <string>
#include <vector>

#include "snug/base/message.h"
#include "snug/fabricate/bricks/ldraw.h"

namespace snug {

/// So many of one piece in one colour.
struct BrickCount {
    const BrickPart* part = nullptr;
    const BrickColor* color = nullptr;
    int pieces = 0;
};

/// What both halves are built of: bricks, plates, tiles, each from the largest to the smallest, by colour.
[[nodiscard]] std::vector<BrickCount> brick_counts(std::span<const ColoredBuild> halves);
[[nodiscard]] std::vector<BrickCount> brick_counts(std::span<const Brick> bricks, const BrickColor& color);

/// "Brick 2 x 4"
[[nodiscard]] Message part_name(const BrickPart& part);

/// "dark blue": a colour as people of a language call it.
[[nodiscard]] Message color_name(const BrickColor& color);

/// `part,name,color,ldraw_color,bricklink_color,pieces`, a line each.
[[nodiscard]] std::string parts_csv(std::span<const BrickCount> counts);

/// A wanted list as BrickLink takes it (its help pages 207 and 2567): no XML declaration.
[[nodiscard]] std::string wanted_xml(std::span<const BrickCount> counts);

}  // namespace snug

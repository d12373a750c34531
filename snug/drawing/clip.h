#pragma once

#include <optional>
#include <vector>

#include "snug/base/vec2.h"

namespace snug {

/// A rectangle on a page; its lower and right edges belong to the neighbours.
struct Window {
    Vec2d min, max;

    [[nodiscard]] bool contains(Vec2d p) const {
        return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y;
    }
};

/// The part of a closed loop within the window; empty where there is none (Sutherland and Hodgman, 1974).
[[nodiscard]] std::vector<Vec2d> clipped_loop(const std::vector<Vec2d>& loop, const Window& window);

/// The parts of a line within the window.
[[nodiscard]] std::vector<std::vector<Vec2d>> clipped_line(const std::vector<Vec2d>& line,
                                                           const Window& window);

}  // namespace snug

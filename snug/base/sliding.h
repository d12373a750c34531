#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace snug {

/// Each value becomes what `choose` (the least, the most) takes of the `window` values that begin with it,
/// and the line loses its last window - 1. A window of any width is two that overlap, of widths that doubling
/// reaches, so the cost is the line's length times the logarithm of the window.
template <class T, class Choose>
void slide(std::vector<T>& line, std::size_t window, Choose choose) {
    for (std::size_t width = 1; width < window;) {
        const std::size_t by = std::min(width, window - width);
        for (std::size_t i = 0; i + by < line.size(); ++i) line[i] = choose(line[i], line[i + by]);
        line.resize(line.size() - by);
        width += by;
    }
}

}  // namespace snug

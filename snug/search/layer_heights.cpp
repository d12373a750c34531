#include "snug/search/layer_heights.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace snug {
namespace {

constexpr std::size_t kMostChoices = 40;

/// All heights that ways have, the greatest first, none below what some item needs at least of the highest.
std::vector<int> heights_of(const ItemMasks& masks, int& least_highest) {
    std::vector<int> heights;
    least_highest = 1;
    for (const MaskPiece& piece : masks.problem.pieces) {
        int least = 1 << 20;
        for (const int shape : piece.shapes) {
            const int height = masks.problem.shapes[static_cast<std::size_t>(shape)].height;
            heights.push_back(height);
            least = std::min(least, height);
        }
        if (!piece.shapes.empty()) least_highest = std::max(least_highest, least);
    }
    std::sort(heights.rbegin(), heights.rend());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
}

/// Those with the same number of layers that never rise, from `from` on.
void add_choices(const std::vector<int>& heights, std::size_t from, int layers, int least_highest,
                 std::vector<int>& begun, std::vector<std::vector<int>>& choices) {
    if (static_cast<int>(begun.size()) == layers) {
        choices.push_back(begun);
        return;
    }
    for (std::size_t i = from; i < heights.size() && choices.size() < 20000; ++i) {
        if (begun.empty() && heights[i] < least_highest) break;
        begun.push_back(heights[i]);
        add_choices(heights, i, layers, least_highest, begun, choices);
        begun.pop_back();
    }
}

/// Where every item has a layer of its own: each as high as what lies there must be.
std::vector<int> own_heights(const ItemMasks& masks, int layers) {
    std::vector<int> heights(static_cast<std::size_t>(layers), 1);
    for (const MaskPiece& piece : masks.problem.pieces) {
        int least = 1 << 20;
        for (const int shape : piece.shapes)
            least = std::min(least, masks.problem.shapes[static_cast<std::size_t>(shape)].height);
        int& here = heights[static_cast<std::size_t>(piece.bin)];
        if (!piece.shapes.empty()) here = std::max(here, least);
    }
    return heights;
}

}  // namespace

std::vector<std::vector<int>> layer_heights(const ItemMasks& masks, int layers, const BlockWalls& walls,
                                            int most) {
    std::vector<std::vector<int>> choices;
    if (layers > 1 && masks.problem.pieces.front().bin >= 0) {
        choices.push_back(own_heights(masks, layers));
        if (height_of_layers(choices.front(), walls) > most) choices.clear();
        return choices;
    }
    int least_highest = 1;
    const std::vector<int> heights = heights_of(masks, least_highest);
    std::vector<int> begun;
    add_choices(heights, 0, layers, least_highest, begun, choices);
    std::erase_if(choices, [&](const auto& each) { return height_of_layers(each, walls) > most; });
    std::stable_sort(choices.begin(), choices.end(), [&](const auto& a, const auto& b) {
        return height_of_layers(a, walls) < height_of_layers(b, walls);
    });
    // The lowest need most room to the sides: some of every height.
    if (choices.size() <= kMostChoices) return choices;
    std::vector<std::vector<int>> some;
    for (std::size_t i = 0; i < kMostChoices; ++i)
        some.push_back(choices[i * (choices.size() - 1) / (kMostChoices - 1)]);
    return some;
}

std::vector<int> heaviest_first(const MaskLayout& layout, const std::vector<double>& mass, int layers) {
    std::vector<double> sum(static_cast<std::size_t>(layers));
    for (std::size_t i = 0; i < layout.size(); ++i) sum[static_cast<std::size_t>(layout[i].bin)] += mass[i];
    std::vector<int> order(sum.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return sum[static_cast<std::size_t>(a)] > sum[static_cast<std::size_t>(b)];
    });
    return order;
}

}  // namespace snug

#include "snug/fabricate/bricks/brick_list.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "snug/words/words.h"

namespace snug {
namespace {

void count(std::span<const Brick> bricks, const BrickColor& color, std::vector<BrickCount>& counts) {
    for (const Brick& brick : bricks) {
        const BrickPart* part =
            brick_part(brick.kind, std::min(brick.rows, brick.columns), std::max(brick.rows, brick.columns));
        const auto found = std::find_if(counts.begin(), counts.end(), [&](const BrickCount& each) {
            return each.part == part && each.color == &color;
        });
        if (found == counts.end())
            counts.push_back({part, &color, 1});
        else
            ++found->pieces;
    }
}

std::vector<BrickCount> in_order(std::vector<BrickCount> counts) {
    // Parts lie in one table from the largest to the smallest of each kind; colours stay in the halves'
    // order.
    std::stable_sort(counts.begin(), counts.end(),
                     [](const BrickCount& a, const BrickCount& b) { return a.part < b.part; });
    return counts;
}

}  // namespace

std::vector<BrickCount> brick_counts(std::span<const ColoredBuild> halves) {
    std::vector<BrickCount> counts;
    for (const ColoredBuild& half : halves) count(half.build->bricks, *half.color, counts);
    return in_order(std::move(counts));
}

std::vector<BrickCount> brick_counts(std::span<const Brick> bricks, const BrickColor& color) {
    std::vector<BrickCount> counts;
    count(bricks, color, counts);
    return in_order(std::move(counts));
}

Message part_name(const BrickPart& part) {
    return say(part.kind == BrickKind::brick   ? "bricks.named_brick"
               : part.kind == BrickKind::plate ? "bricks.named_plate"
                                               : "bricks.named_tile",
               {{"size", std::to_string(part.width) + " x " + std::to_string(part.length)}});
}

Message color_name(const BrickColor& color) {
    // As brick_colors() lists them.
    static constexpr const char* kCodes[] = {
        "color.black",     "color.blue",      "color.green",      "color.red",           "color.yellow",
        "color.white",     "color.tan",       "color.orange",     "color.reddish_brown", "color.light_gray",
        "color.dark_gray", "color.dark_blue", "color.dark_brown", "color.dark_red"};
    const std::span<const BrickColor> colors = brick_colors();
    assert(colors.size() == std::size(kCodes));
    const auto found = std::find_if(colors.begin(), colors.end(),
                                    [&](const BrickColor& each) { return each.name == color.name; });
    return found == colors.end() ? as_it_is(color.name) : say(kCodes[found - colors.begin()]);
}

std::string parts_csv(std::span<const BrickCount> counts) {
    std::string text = "part,name,color,ldraw_color,bricklink_color,pieces\n";
    for (const BrickCount& each : counts)
        text += std::string(each.part->number) + "," + snug::text(part_name(*each.part)) + "," +
                std::string(each.color->name) + "," + std::to_string(each.color->ldraw) + "," +
                std::to_string(each.color->bricklink) + "," + std::to_string(each.pieces) + "\n";
    return text;
}

std::string wanted_xml(std::span<const BrickCount> counts) {
    std::string text = "<INVENTORY>\n";
    for (const BrickCount& each : counts)
        text += "<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>" + std::string(each.part->number) + "</ITEMID><COLOR>" +
                std::to_string(each.color->bricklink) + "</COLOR><MINQTY>" + std::to_string(each.pieces) +
                "</MINQTY></ITEM>\n";
    return text + "</INVENTORY>\n";
}

}  // namespace snug

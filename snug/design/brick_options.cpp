#include "snug/design/brick_options.h"

#include <algorithm>

#include "snug/base/text.h"
#include "snug/design/brick_parts.h"

namespace snug {
namespace {

constexpr int kMostPieces = 10'000'000;

std::string known_colors() {
    std::string names;
    for (const BrickColor& color : brick_colors())
        names += (names.empty() ? "" : ", ") + std::string(color.name);
    return names;
}

std::string known_sizes() {
    std::string names;
    for (const BrickPart& part : brick_parts())
        if (part.kind == BrickKind::brick)
            names +=
                (names.empty() ? "" : ", ") + std::to_string(part.width) + "x" + std::to_string(part.length);
    return names;
}

std::optional<std::string> problem_of_size(const std::string& size) {
    if (brick_size(size)) return {};
    return "no brick is " + quoted(size) + ": take sizes of " + known_sizes();
}

}  // namespace

std::string_view brick_unit_name(BrickUnit unit) {
    switch (unit) {
        case BrickUnit::brick:
            return "brick";
        case BrickUnit::plate:
            return "plate";
        case BrickUnit::automatic:
            break;
    }
    return "auto";
}

std::optional<BrickUnit> brick_unit_from_name(std::string_view name) {
    for (const BrickUnit unit : {BrickUnit::automatic, BrickUnit::brick, BrickUnit::plate})
        if (brick_unit_name(unit) == name) return unit;
    return {};
}

std::string_view brick_rim_name(BrickRim rim) {
    return rim == BrickRim::tiles ? "tiles" : "studs";
}

std::optional<BrickRim> brick_rim_from_name(std::string_view name) {
    for (const BrickRim rim : {BrickRim::studs, BrickRim::tiles})
        if (brick_rim_name(rim) == name) return rim;
    return {};
}

std::optional<std::string> problem_of(const BrickOptions& o) {
    for (const std::string& size : o.family)
        if (auto found = problem_of_size(size)) return found;
    for (const BrickStock& stock : o.stock) {
        if (auto found = problem_of_size(stock.size)) return found;
        if (stock.pieces < 0 || stock.pieces > kMostPieces)
            return "the stock of " + stock.size + " must be from 0 to " + grouped(kMostPieces) +
                   " pieces, not " + std::to_string(stock.pieces);
    }
    for (const std::string& color : {o.lower_color, o.lid_color})
        if (!brick_color(color))
            return "no bricks are known in " + quoted(color) + ": take " + known_colors();
    if (!(o.capacity_n >= 0.01 && o.capacity_n <= 100))
        return "what a contact point of a stud holds must be from 0.01 to 100 newtons, not " +
               number(o.capacity_n, 4);
    return {};
}

}  // namespace snug

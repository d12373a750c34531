#include "snug/design/brick_options.h"

#include "snug/base/text.h"
#include "snug/design/brick_parts.h"
#include "snug/design/option_list.h"

namespace snug {
namespace {

std::vector<Message> known_colors() {
    std::vector<Message> names;
    for (const BrickColor& color : brick_colors()) names.push_back(as_it_is(color.name));
    return names;
}

std::vector<Message> known_sizes() {
    std::vector<Message> sizes;
    for (const BrickPart& part : brick_parts())
        if (part.kind == BrickKind::brick)
            sizes.push_back(as_it_is(std::to_string(part.width) + "x" + std::to_string(part.length)));
    return sizes;
}

std::optional<Message> problem_of_size(const std::string& size) {
    if (brick_size(size)) return {};
    return say("brick.no_size", {{"size", quoted(size)}, {"known", known_sizes()}});
}

}  // namespace

SharedFlag<BrickOptions> brick_color_flag() {
    return {.flag = "--brick-colors",
            .takes = "LOWER,LID",
            .help = {"Bricks: of the lower half and the lid", "ブロック玩具：下とふたの色"},
            .take =
                [](std::string_view text, BrickOptions& bricks) {
                    const std::size_t comma = text.find(',');
                    bricks.lower_color = text.substr(0, comma);
                    bricks.lid_color =
                        comma == std::string_view::npos ? bricks.lower_color : text.substr(comma + 1);
                    return Result<void>();
                },
            .say =
                [](const BrickOptions& bricks) {
                    return std::optional<std::string>(bricks.lower_color + "," + bricks.lid_color);
                },
            .usual = "blue,orange"};
}

std::optional<OptionProblem> problem_of(const BrickOptions& o) {
    if (auto found = out_of_range(o)) return found;
    for (const std::string& size : o.family)
        if (auto found = problem_of_size(size)) return OptionProblem{"family", *found};
    for (const BrickStock& stock : o.stock)
        if (auto found = problem_of_size(stock.size)) return OptionProblem{"stock", *found};
    const auto unknown = [](const std::string& color) {
        return say("brick.no_color", {{"color", quoted(color)}, {"known", known_colors()}});
    };
    if (!brick_color(o.lower_color)) return OptionProblem{"lower_color", unknown(o.lower_color)};
    if (!brick_color(o.lid_color)) return OptionProblem{"lid_color", unknown(o.lid_color)};
    return {};
}

}  // namespace snug

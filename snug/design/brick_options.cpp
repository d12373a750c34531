#include "snug/design/brick_options.h"

#include "snug/base/text.h"
#include "snug/design/brick_parts.h"
#include "snug/design/option_list.h"

namespace snug {
namespace {

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

SharedFlag<BrickOptions> brick_color_flag() {
    return {.flag = "--brick-colors",
            .takes = "LOWER,LID",
            .help = "Bricks: of the lower half and the lid",
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
        return "no bricks are known in " + quoted(color) + ": take " + known_colors();
    };
    if (!brick_color(o.lower_color)) return OptionProblem{"lower_color", unknown(o.lower_color)};
    if (!brick_color(o.lid_color)) return OptionProblem{"lid_color", unknown(o.lid_color)};
    return {};
}

}  // namespace snug

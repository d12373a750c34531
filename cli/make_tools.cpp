#include "cli/make_tools.h"

#include <fmt/core.h>

#include "cli/option_values.h"

namespace snug::cli {
namespace {

/// One of a few words.
template <class Value, class FromName>
Result<void> take_word(const char* option, const std::optional<std::string>& word, FromName from_name,
                       const char* expected, Value& value) {
    if (!word) return {};
    const auto known = from_name(*word);
    if (!known)
        return fail(ErrorKind::usage, fmt::format("{} takes {}, not \"{}\"", option, expected, *word));
    value = *known;
    return {};
}

/// "2x4=100"
Result<BrickStock> parse_stock(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        return fail(
            ErrorKind::usage,
            fmt::format("--brick-stock takes sizes and pieces such as 2x4=100,1x1=40, not \"{}\"", text));
    const auto pieces = parse_integer("--brick-stock", text.substr(equals + 1));
    if (!pieces) return tl::unexpected(pieces.error());
    return BrickStock{text.substr(0, equals), *pieces};
}

Result<void> apply_bricks(const ToolArguments& a, BrickOptions& bricks) {
    if (auto done = take_word("--brick-unit", a.brick_unit, brick_unit_from_name, "auto, brick or plate",
                              bricks.unit);
        !done)
        return done;
    if (auto done = take_word("--brick-rim", a.brick_rim, brick_rim_from_name, "studs or tiles", bricks.rim);
        !done)
        return done;
    if (a.brick_colors) {
        const std::size_t comma = a.brick_colors->find(',');
        bricks.lower_color = a.brick_colors->substr(0, comma);
        bricks.lid_color =
            comma == std::string::npos ? bricks.lower_color : a.brick_colors->substr(comma + 1);
    }
    if (!a.brick_sizes.empty()) bricks.family = a.brick_sizes;
    if (!a.brick_stock.empty()) bricks.stock.clear();
    for (const std::string& text : a.brick_stock) {
        const auto stock = parse_stock(text);
        if (!stock) return tl::unexpected(stock.error());
        bricks.stock.push_back(*stock);
    }
    if (a.brick_capacity) bricks.capacity_n = *a.brick_capacity;
    return {};
}

}  // namespace

void add_tool_options(CLI::App& make, ToolArguments& arguments) {
    auto& a = arguments;
    make.add_option("--brick-unit", a.brick_unit, "Bricks: layers of bricks or of plates (auto)")
        ->type_name("auto|brick|plate");
    make.add_option("--brick-sizes", a.brick_sizes, "Bricks: the sizes to build with (all)")
        ->type_name("2x4,1x2,...")
        ->delimiter(',');
    make.add_option("--brick-colors", a.brick_colors, "Bricks: of the lower half and the lid (blue,orange)")
        ->type_name("LOWER,LID");
    make.add_option("--brick-stock", a.brick_stock, "Bricks: pieces that there are (no limit)")
        ->type_name("2x4=100,1x1=40")
        ->delimiter(',');
    make.add_option("--brick-rim", a.brick_rim, "Bricks: what the halves meet with (studs)")
        ->type_name("studs|tiles");
    make.add_option("--brick-capacity", a.brick_capacity,
                    "Bricks: newtons that a contact point of a stud holds (0.7)")
        ->type_name("N");
    make.add_option("--cutter", a.cutter, "Mill: the flat cutter's diameter (6)")->type_name("MM");
    make.add_option("--flute", a.flute, "Mill: how deep the cutter can go (60)")->type_name("MM");
    make.add_option("--step-down", a.step_down, "Mill: the most that a pass goes down (half the cutter)")
        ->type_name("MM");
    make.add_option("--stepover", a.stepover, "Mill: between paths, in diameters (0.4)")->type_name("SHARE");
    make.add_option("--feed", a.feed, "Mill: feed (1500)")->type_name("MM/MIN");
    make.add_option("--plunge", a.plunge, "Mill: feed downwards (400)")->type_name("MM/MIN");
    make.add_option("--spindle", a.spindle, "Mill: the spindle's speed (16000)")->type_name("RPM");
    make.add_option("--safe-height", a.safe_height, "Mill: of rapid moves above the stock (5)")
        ->type_name("MM");
    make.add_option("--pin", a.pin, "Mill: diameter of the registration pins; 0: none (6)")->type_name("MM");
    make.add_option("--origin", a.origin, "Mill: where X0 Y0 lies on the stock (corner)")
        ->type_name("corner|centre");
    make.add_option("--mould-wall", a.mould_wall, "Mould: thickness of walls and floor (3)")->type_name("MM");
    make.add_option("--mould-rim", a.mould_rim, "Mould: height of the walls above what is poured (5)")
        ->type_name("MM");
    make.add_option("--draft", a.draft, "Mould: lean of upright faces, so that the foam lets go (2)")
        ->type_name("DEGREES");
}

Result<void> apply_tools(const ToolArguments& a, WorkshopOptions& options) {
    if (auto done = apply_bricks(a, options.bricks); !done) return done;
    MillOptions& mill = options.mill;
    if (a.cutter) mill.cutter_mm = *a.cutter;
    if (a.flute) mill.flute_mm = *a.flute;
    if (a.step_down) mill.step_down_mm = *a.step_down;
    if (a.stepover) mill.stepover = *a.stepover;
    if (a.feed) mill.feed_mm_min = *a.feed;
    if (a.plunge) mill.plunge_mm_min = *a.plunge;
    if (a.spindle) mill.spindle_rpm = *a.spindle;
    if (a.safe_height) mill.safe_mm = *a.safe_height;
    if (a.pin) mill.pin_mm = *a.pin;
    if (auto done = take_word("--origin", a.origin, mill_origin_from_name, "corner or centre", mill.origin);
        !done)
        return done;
    if (a.mould_wall) options.mould.wall_mm = *a.mould_wall;
    if (a.mould_rim) options.mould.rim_mm = *a.mould_rim;
    if (a.draft) options.mould.draft_deg = *a.draft;
    return {};
}

}  // namespace snug::cli

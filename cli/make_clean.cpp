#include "cli/make_clean.h"

#include <string_view>

#include "cli/option_values.h"

namespace snug::cli {

void add_clean_options(CLI::App& command, CleanArguments& a) {
    command.add_option("--drop", a.drop, "Leave out separate parts, by their numbers in `snug inspect`")
        ->type_name("2,5-9");
    command.add_option("--drop-below", a.drop_below, "Leave out separate parts that are shorter than this")
        ->type_name("MM");
    command
        .add_option(
            "--cut-plane", a.cut_plane,
            "Cut off what lies behind a plane, such as a table: the direction to keep, and how far the "
            "plane lies along it (0,0,1,12 keeps what is above z = 12 mm)")
        ->type_name("X,Y,Z,MM");
}

Result<void> take_clean(const CleanArguments& a, CleanOptions& options) {
    if (a.drop) {
        auto parts = parse_numbers("--drop", *a.drop);
        if (!parts) return tl::unexpected(parts.error());
        options.drop_parts = std::move(*parts);
    }
    if (a.drop_below) options.drop_below_mm = *a.drop_below;
    if (a.cut_plane) {
        const auto plane = parse_plane("--cut-plane", *a.cut_plane);
        if (!plane) return tl::unexpected(plane.error());
        options.cut_plane = *plane;
    }
    return {};
}

}  // namespace snug::cli

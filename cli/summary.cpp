#include "cli/summary.h"

#include <string_view>

#include <fmt/core.h>

#include "snug/base/one_line.h"
#include "snug/base/text.h"

#include "cli/make_case.h"
#include "cli/make_fit.h"

namespace snug::cli {
namespace {

std::string litres(double mm3) {
    return number(mm3 * 1e-6, 2) + " litres";
}

std::string blocks_of(const DesignSpace& space) {
    return fmt::format("{} blocks of {} mm = {} mm", dimensions(vec_cast<double>(space.blocks), 0),
                       dimensions(space.block_mm, 2), dimensions(space.size()));
}

/// Breaks a sentence into lines of about 90 characters, the later ones indented.
std::string wrapped(std::string_view text, std::size_t indent) {
    constexpr std::size_t kWidth = 90;
    std::string lines;
    std::size_t length = 0;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (length > 0 && length + 1 + word.size() > kWidth) {
            lines += "\n" + std::string(indent, ' ');
            length = 0;
        } else if (length > 0) {
            lines += ' ';
            ++length;
        }
        lines += word;
        length += word.size();
    }
    return lines;
}

std::string findings_lines(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        const std::string_view label = finding.severity == Severity::danger    ? "DANGER"
                                       : finding.severity == Severity::warning ? "Warning"
                                                                               : "Note";
        text += fmt::format("{:<10}{}\n", label, wrapped(one_line(finding.message), 10));
    }
    return text;
}

std::string gap_line(const GapReport& gap) {
    std::string text = fmt::format("widest {} mm; {} lost to the blocks' steps", number(gap.widest_mm, 1),
                                   litres(gap.step_mm3));
    if (gap.undercut_mm3) text += fmt::format(", {} to undercuts", litres(*gap.undercut_mm3));
    return text;
}

}  // namespace

std::string object_line(const Object& object) {
    const auto& measure = object.measure;
    if (object.is_cloud())
        return fmt::format("{}, {} mm, a cloud", counted(object.read.vertices, "point", "points"),
                           dimensions(measure.bounds.size()));
    if (object.is_streamed())
        return fmt::format("{}, {} mm, read in pieces",
                           counted(object.read.triangles, "triangle", "triangles"),
                           dimensions(measure.bounds.size()));
    std::string closed = "closed";
    if (!measure.holes.empty())
        closed = "open (" + counted(measure.holes.size(), "hole", "holes") + ")";
    else if (!measure.watertight)
        closed = "closed, but wound both ways";
    return fmt::format("{}, {}, {} mm, {}", counted(object.read.vertices, "vertex", "vertices"),
                       counted(object.read.triangles, "triangle", "triangles"),
                       dimensions(measure.bounds.size()), closed);
}

std::string summary(const Object& object, const Project& project, const Made& made,
                    const std::string& folder) {
    const Packing& packing = made.packing;
    const FitReport& fit = packing.fit;
    const auto& wall = fit.wall_mm;
    const auto line = [](std::string_view label, const std::string& text) {
        return fmt::format("{:<10}{}\n", label, text);
    };
    std::string text = line("Object", one_line(project.object.name) + ": " + object_line(object));
    text += line("Space", blocks_of(packing.space));
    if (packing.fitted_case) text += case_lines(*packing.fitted_case, packing.foams->parting_level);
    text += line("Foam", fmt::format("lower {}, lid {}, together {}; F {}",
                                     counted(fit.lower_blocks, "block", "blocks"),
                                     counted(fit.upper_blocks, "block", "blocks"), litres(fit.foam_mm3),
                                     number(fit.fill_ratio, 4)));
    text += line("Remove",
                 fmt::format("{} ({})", counted(fit.cut_blocks, "block", "blocks"),
                             litres(static_cast<double>(fit.cut_blocks) * packing.space.block_volume())));
    text += line("Parting", fmt::format("after block {} of {}, counted from below",
                                        packing.foams->parting_level, packing.space.blocks.x));
    text += line("Walls", fmt::format("floor {}, roof {}, back {}, front {}, left {}, right {} mm",
                                      number(wall[0], 1), number(wall[1], 1), number(wall[2], 1),
                                      number(wall[3], 1), number(wall[4], 1), number(wall[5], 1)));
    for (const Notch& notch : packing.notches) text += line("Notch", notch_text(notch));
    if (made.fit.gap) text += line("Gaps", gap_line(*made.fit.gap));
    if (made.fit.bearing) text += line("Bears", wrapped(bearing_text(*made.fit.bearing, project.design), 10));
    text += findings_lines(packing.findings);
    text += line("Files", folder.empty() ? "none are written: a dry run"
                                         : fmt::format("in {}: look at preview.svg first", one_line(folder)));
    return text;
}

}  // namespace snug::cli

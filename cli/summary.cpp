#include "cli/summary.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "snug/base/one_line.h"
#include "snug/base/text.h"
#include "snug/fabricate/kit/case_text.h"
#include "snug/fabricate/kit/pad_pages.h"
#include "snug/fabricate/kit/shock_text.h"
#include "snug/fabricate/kit/zone_text.h"
#include "snug/words/pieces.h"
#include "snug/words/sides.h"
#include "snug/words/words.h"

#include "cli/make_fit.h"
#include "cli/wrapped.h"

namespace snug::cli {
namespace {

constexpr std::size_t kLabel = 10;  // columns

std::string litres(double mm3) {
    return number(mm3 * 1e-6, 2);
}

Message blocks_of(const DesignSpace& space) {
    return say("summary.blocks", {{"blocks", dimensions(vec_cast<double>(space.blocks), 0)},
                                  {"block", dimensions(space.block_mm, 2)},
                                  {"size", dimensions(space.size())}});
}

/// psi, theta, phi
std::string angles_text(const PlacementOptions& placement) {
    const Vec3d& angles = placement.rotation_deg;
    return number(angles.x, 1) + ", " + number(angles.y, 1) + ", " + number(angles.z, 1);
}

Message arranged_text(const Arrangement& arrangement, bool walls_chosen) {
    if (walls_chosen) return say("summary.arranged_in/walls", {{"litres", litres(arrangement.volume_mm3)}});
    std::vector<Message> least;
    if (arrangement.lower_bound_mm3)
        least.push_back(say("summary.at_least", {{"litres", litres(*arrangement.lower_bound_mm3)}}));
    return say(arrangement.cancelled ? "summary.arranged_in/cancelled" : "summary.arranged_in",
               {{"litres", litres(arrangement.volume_mm3)}, {"least", least}});
}

const char* label_of(Severity severity) {
    return severity == Severity::danger    ? "severity.danger"
           : severity == Severity::warning ? "severity.warning"
                                           : "severity.note";
}

Message gap_text(const GapFigures& gap) {
    std::vector<Message> undercut;
    if (gap.undercut_mm3)
        undercut.push_back(say("summary.undercut", {{"litres", litres(*gap.undercut_mm3)}}));
    return say(
        "summary.gap",
        {{"widest", number(gap.widest_mm, 1)}, {"step", litres(gap.step_mm3)}, {"undercut", undercut}});
}

Message foam_text(const FitReport& fit) {
    std::vector<Message> pieces;
    const int count = static_cast<int>(fit.pieces.size());
    for (int i = 0; i < count - (fit.open ? 1 : 0); ++i)
        pieces.push_back(
            say("summary.piece_of",
                {{"foam", foam_of({i, count})}, {"blocks", fit.pieces[static_cast<std::size_t>(i)].blocks}}));
    if (count > 2 || fit.open)
        return say("summary.foam_of_layers",
                   {{"pieces", pieces}, {"litres", litres(fit.foam_mm3)}, {"f", number(fit.fill_ratio, 4)}});
    return say("summary.foam_of", {{"lower", fit.lower().blocks},
                                   {"lid", fit.upper().blocks},
                                   {"litres", litres(fit.foam_mm3)},
                                   {"f", number(fit.fill_ratio, 4)}});
}

Message walls_text(const FitReport& fit) {
    const auto mm = [&](Side side) { return number(fit.wall_mm[side], 1); };
    if (fit.open)
        return say("summary.walls_of_tray", {{"floor", mm(kFloor)},
                                             {"back", mm(kBack)},
                                             {"front", mm(kFront)},
                                             {"left", mm(kLeft)},
                                             {"right", mm(kRight)}});
    return say("summary.walls_of", {{"floor", mm(kFloor)},
                                    {"roof", mm(kRoof)},
                                    {"back", mm(kBack)},
                                    {"front", mm(kFront)},
                                    {"left", mm(kLeft)},
                                    {"right", mm(kRight)}});
}

/// The lines, each a label and what is said under it.
struct Lines {
    Language language;
    std::string text = {};

    void add(std::string_view label, const Message& message) {
        text += padded(label, kLabel) + snug::text(message, language) + "\n";
    }
    void add(const char* label, const Message& message) { add(worded(label), message); }
    /// Over several lines, where it is long.
    void add_sentence(std::string_view label, const Message& message) {
        text += padded(label, kLabel) + wrapped(one_line(snug::text(message, language)), kLabel) + "\n";
    }
    void add_sentence(const char* label, const Message& message) { add_sentence(worded(label), message); }
    [[nodiscard]] std::string worded(const char* label) const { return worded(say(label)); }
    [[nodiscard]] std::string worded(const Message& label) const { return snug::text(label, language); }
};

/// "lens.stl x2" where it lies there twice.
std::string listed_name(std::size_t object, const Project& project) {
    const auto count = std::count_if(
        project.design.items.begin(), project.design.items.end(),
        [&](const ItemOptions& item) { return static_cast<std::size_t>(item.object) == object; });
    return project.objects[object].file.name + (count > 1 ? " x" + std::to_string(count) : "");
}

/// What is said of an item, whose name it bears where there are several.
Message of_item(const Packing& packing, std::size_t item, const Message& what) {
    if (packing.items.size() == 1) return what;
    return say("summary.named", {{"name", one_line(packing.items[item].name)}, {"what", what}});
}

}  // namespace

Message object_text(const Object& object) {
    const auto& measure = object.measure;
    const std::string size = dimensions(measure.bounds.size());
    if (object.is_cloud()) return say("summary.cloud", {{"points", object.read.vertices}, {"size", size}});
    if (object.is_streamed())
        return say("summary.streamed", {{"triangles", object.read.triangles}, {"size", size}});
    Message closed = say("summary.closed");
    if (!measure.holes.empty())
        closed = say("summary.open", {{"holes", measure.holes.size()}});
    else if (!measure.watertight)
        closed = say("summary.wound");
    return say("summary.mesh", {{"vertices", object.read.vertices},
                                {"triangles", object.read.triangles},
                                {"size", size},
                                {"closed", closed}});
}

std::string summary(std::span<const Object> objects, const Project& project, const Made& made,
                    const std::string& folder, Language language) {
    const Packing& packing = made.packing;
    const FitReport& fit = packing.fit;
    const double cut_mm3 = static_cast<double>(fit.cut_blocks) * packing.space.block_volume();
    Lines lines{language};
    for (std::size_t object = 0; object < objects.size(); ++object)
        lines.add("summary.object", say("summary.named", {{"name", one_line(listed_name(object, project))},
                                                          {"what", object_text(objects[object])}}));
    lines.add("summary.space", blocks_of(packing.space));
    if (made.search)
        lines.add("summary.lies", say("summary.turned", {{"angles", angles_text(project.design.placement)}}));
    if (made.arrangement) lines.add("summary.arranged", arranged_text(*made.arrangement, made.walls_chosen));
    if (packing.fitted_case) {
        lines.add("summary.case", case_text(*packing.fitted_case));
        std::string label = lines.worded("summary.fillers");
        for (const Filler& filler : fillers(*packing.fitted_case, packing.foams->parting.back(), fit.open)) {
            lines.add(std::string_view(label), filler_text(filler));
            label.clear();
        }
    }
    lines.add("summary.foam", foam_text(fit));
    lines.add("summary.remove",
              say("summary.removed", {{"blocks", fit.cut_blocks}, {"litres", litres(cut_mm3)}}));
    std::string levels;
    for (const int level : packing.foams->parting)
        levels += (levels.empty() ? "" : ", ") + std::to_string(level);
    lines.add("summary.parting",
              say("summary.parting_after",
                  {{"level", levels}, {"blocks", std::to_string(packing.space.blocks.x)}}));
    lines.add("summary.walls", walls_text(fit));
    for (std::size_t i = 0; i < packing.items.size(); ++i)
        if (const double mm = packing.items[i].settled_mm; mm > 0)
            lines.add("summary.settled",
                      of_item(packing, i, say("summary.settled_by", {{"mm", number(mm, 1)}})));
    for (const LiftSlot& slot : packing.lift.slots)
        lines.add("summary.lift",
                  say("summary.lift_at", {{"piece", foam_of(slot.piece)}, {"side", side_text(slot.side)}}));
    for (const Notch& notch : packing.notches) {
        const Message what = notch_text(notch);
        lines.add("summary.notch", of_item(packing, notch.item, what));
    }
    for (std::size_t i = 0; i < packing.pads.pads.size(); ++i)
        lines.add(lines.worded(say("summary.pad", {{"number", std::to_string(i + 1)}})),
                  of_item(packing, packing.pads.pads[i].item, pad_text(packing.pads.pads[i], packing.space)));
    if (made.fit.gap) lines.add("summary.gaps", gap_text(*made.fit.gap));
    if (made.fit.bearing)
        lines.add_sentence("summary.bears", bearing_text(*made.fit.bearing, *packing.foams, project.design,
                                                         made.packing.protection.has_value()));
    if (made.packing.protection && made.packing.protection->drop_mm && made.packing.protection->foam) {
        lines.add_sentence("summary.drop", drop_text(*made.packing.protection));
        for (const Message& face : face_texts(*made.packing.protection)) lines.add(std::string_view(), face);
        if (const auto borne = borne_text(*made.packing.protection))
            lines.add_sentence(std::string_view(), *borne);
        lines.add_sentence(std::string_view(), say("summary.drop_claim"));
    }
    if (packing.protection)
        for (const ZoneReport& zone : packing.protection->zones)
            lines.add_sentence(lines.worded(say("summary.zone", {{"zone", zone.number}})),
                               of_item(packing, zone.item, zone_text(zone)));
    for (const Finding& finding : packing.findings)
        lines.add_sentence(label_of(finding.severity), said_of_item(finding));
    lines.add("summary.files",
              folder.empty() ? say("summary.dry") : say("summary.in_folder", {{"folder", one_line(folder)}}));
    return lines.text;
}

}  // namespace snug::cli

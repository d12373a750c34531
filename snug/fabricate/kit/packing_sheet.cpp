#include "snug/fabricate/kit/packing_sheet.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/kit/block_names.h"
#include "snug/fabricate/kit/finger_room.h"
#include "snug/fabricate/kit/packing_picture.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr double kPictureGap = 6;  // mm
constexpr double kMarkIndent = 8;  // mm
constexpr double kFactIndent = 30;
constexpr double kFindingIndent = 24;
constexpr std::array<std::string_view, 4> kSides{"back", "front", "left", "right"};

struct Picture {
    PictureParts parts;
    std::string_view caption;
};
constexpr std::array<Picture, 3> kPictures{{{{false, false}, "1  Lower foam, cavity up"},
                                            {{true, false}, "2  Object in the lower foam"},
                                            {{true, true}, "3  Lid, here turned over its BACK edge"}}};

void draw_pictures(PageFlow& flow, const PackedObject& packed) {
    const double width = (flow.width() - 2 * kPictureGap) / 3, height = width * 1.02;
    const Vec2d corner = flow.room(height + 9);
    for (std::size_t i = 0; i < kPictures.size(); ++i) {
        const Vec2d at = corner + Vec2d{static_cast<double>(i) * (width + kPictureGap), 0};
        draw_packing_picture(flow.page(), at + Vec2d{2, 6}, {width - 4, height - 7}, kPictures[i].parts,
                             packed.design.foams, packed.design.space, packed.mesh, packed.placement);
        flow.page().text(at + Vec2d{width / 2, height + 4.6}, std::string(kPictures[i].caption),
                         {kSmallText, kInk, true, TextAnchor::middle});
    }
}

/// "C7": the column of blocks over a place.
std::string column_at(Vec3d where, const DesignSpace& space) {
    const auto cell = [&](int axis) {
        const int i = static_cast<int>((where[axis] - space.face(axis, 0)) / space.block_mm[axis]);
        return std::clamp(i, 0, space.blocks[axis] - 1);
    };
    return row_name(cell(1)) + column_name(cell(2));
}

std::string lifting_text(const std::array<FingerRoom, 4>& room, const DesignSpace& space) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return room[a].mm > room[b].mm; });
    std::string fitting;
    for (const std::size_t side : order)
        if (room[side].mm >= kFingerWidth)
            fitting += (fitting.empty() ? "" : ", ") + std::string(kSides[side]) + " " +
                       number(room[side].mm, 0) + " mm at " + column_at(room[side].where, space);
    if (!fitting.empty())
        return "Lift out by hand where fingers fit beside the object: " + fitting +
               ". Never by a thin or projecting part.";
    const FingerRoom& widest = room[order[0]];
    return "No side leaves the " + number(kFingerWidth, 0) + " mm that a finger wants (widest: " +
           (widest.mm > 0 ? std::string(kSides[order[0]]) + ", " + number(widest.mm, 0) + " mm at " +
                                column_at(widest.where, space)
                          : std::string("none")) +
           "). Lay two ribbons across the lower foam before the object, their ends outside, and lift by "
           "them.";
}

void tell_order(PageFlow& flow, const PackedObject& packed) {
    const std::array<FingerRoom, 4> room = finger_room(packed.mesh, packed.placement, packed.design.space,
                                                       packed.design.blocks, packed.design.foams);
    const std::string steps[] = {
        "Stand the case with the lower foam in it, cavity up, the edge marked BACK away from you. The cavity "
        "must "
        "be empty and free of crumbs.",
        "Lower the object straight down into its cavity, as in picture 2, without turning or pressing. Where "
        "it "
        "does not go in by its own weight, take it out and look why.",
        "Put the lid on by hand, cavity down, BACK over BACK, the marked corners together. The rims must "
        "meet "
        "all round without force. Never press the lid with the case's cover.",
        "To unpack, lift the lid straight up first. " + lifting_text(room, packed.design.space)};
    flow.heading("How to lay it in");
    int step = 0;
    for (const std::string& text : steps)
        flow.item(std::to_string(++step), text, {kBodyText, kSoftInk, true}, kMarkIndent);
}

std::string walls_text(const FitReport& fit) {
    const auto& wall = fit.wall_mm;
    const std::array<std::pair<std::string_view, Side>, 6> sides{{{"floor", kFloor},
                                                                  {"lid", kRoof},
                                                                  {"back", kBack},
                                                                  {"front", kFront},
                                                                  {"left", kLeft},
                                                                  {"right", kRight}}};
    std::string text;
    for (const auto& side : sides)
        text += (text.empty() ? "" : " · ") + std::string(side.first) + " " + number(wall[side.second], 1);
    return text + " mm";
}

void tell_facts(PageFlow& flow, const PackedObject& packed) {
    const PackMaterial& material = packed.material;
    const WorkshopOptions& options = packed.options;
    const TextLook mark{kBodyText, kSoftInk, true};
    const auto fact = [&](std::string_view name, const std::string& text) {
        flow.item(name, text, mark, kFactIndent);
        flow.space(-0.8);
    };
    flow.heading("What it is");
    fact("Object", packed.design.object_name + ", " + dimensions(packed.size_mm) + " mm" +
                       (options.mass_kg ? ", " + number(*options.mass_kg, 3) + " kg" : ", weight not given"));
    fact("Foam, closed", dimensions(packed.design.space.size()) + " mm (x upward, y from BACK, z across)");
    fact("Walls", walls_text(packed.fit));
    std::string weight = number(packed.fit.foam_mm3 * 1e-6, 2) + " litres";
    if (material.foam_kg) weight += ", " + number(*material.foam_kg, 3) + " kg";
    if (material.foam_kg && options.mass_kg)
        weight +=
            "; with the object " + number(*material.foam_kg + *options.mass_kg, 3) + " kg, without the case";
    fact("Foam", weight);
    if (material.cost)
        fact("Material", number(material.litres.value_or(0), 2) + " litres, " + number(*material.cost, 2) +
                             (options.currency.empty() ? "" : " " + options.currency));
}

void tell_findings(PageFlow& flow, const std::vector<Finding>& findings) {
    flow.heading("What to know");
    if (findings.empty()) flow.paragraph("Nothing was found in the shape of the foam.");
    for (const Finding& finding : findings) {
        const bool danger = finding.severity == Severity::danger;
        const std::string_view name = danger                                  ? "DANGER"
                                      : finding.severity == Severity::warning ? "Warning"
                                                                              : "Note";
        flow.item(name, text(finding.message, Language::english),
                  {kBodyText, danger ? kAlarm : kSoftInk, true}, kFindingIndent);
    }
}

void tell_unchecked(PageFlow& flow) {
    static constexpr std::string_view kUnchecked[] = {
        "Drops and shocks: neither the foam's thickness nor its stiffness was matched to the object's weight "
        "and "
        "fragility.",
        "Pressure: whether the foam dents where the object rests on a small area, or sags in a long store.",
        "The material near collections: gases, plasticisers, dust, colour, flammability. Ask a conservator; "
        "put tissue or film between where in doubt.",
        "The model itself: whether it is the object's true size and shape, as it is today.",
    };
    flow.heading("What was not checked");
    for (const std::string_view text : kUnchecked) flow.item("-", text, {kBodyText, kSoftInk}, 4);
}

}  // namespace

DrawingDocument packing_sheet(const PackedObject& packed) {
    const std::string title = packed.design.object_name + ": packing sheet";
    PageFlow flow(paper_mm(packed.options.paper), packed.design.object_name,
                  "Packing sheet · travels with the box · " + dimensions(packed.size_mm) + " mm", kInk);
    draw_pictures(flow, packed);
    tell_order(flow, packed);
    tell_facts(flow, packed);
    tell_findings(flow, packed.findings);
    tell_unchecked(flow);
    DrawingDocument document{"packing-sheet", title, flow.finish(), false};
    for (Drawing& page : document.pages) page.title = title;
    return document;
}

}  // namespace snug

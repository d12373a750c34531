#include "snug/fabricate/kit/packing_sheet.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "snug/base/text.h"
#include "snug/check/drop_sentence.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/kit/block_names.h"
#include "snug/fabricate/kit/case_text.h"
#include "snug/fabricate/kit/drop_pictures.h"
#include "snug/fabricate/kit/finger_room.h"
#include "snug/fabricate/kit/packing_record.h"
#include "snug/fabricate/kit/pad_pages.h"
#include "snug/fabricate/kit/shock_text.h"
#include "snug/fabricate/kit/zone_text.h"
#include "snug/words/pieces.h"
#include "snug/words/sides.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr double kPictureGap = 6;  // mm
constexpr double kMarkIndent = 8;  // mm
constexpr double kFactIndent = 30;
constexpr double kFindingIndent = 24;
constexpr std::array<Side, 4> kSides{kBack, kFront, kLeft, kRight};  // as finger_room() has them

constexpr std::array<PictureParts, 3> kPictures{{{false, false}, {true, false}, {true, true}}};

/// Under a picture of the only layer.
Message caption(std::size_t picture, bool items) {
    constexpr std::array<const char*, 3> kCaptions{"packing.picture_lower", "packing.picture_object",
                                                   "packing.picture_lid"};
    return say(picture == 1 && items ? "packing.picture_items" : kCaptions[picture]);
}

/// Pictures of several layers are numbered on.
std::size_t picture_number(int layer, std::size_t picture) {
    return 3 * static_cast<std::size_t>(layer - 1) + picture + 1;
}

Message caption(std::size_t picture, int layer, const Foams& foams) {
    const std::string number = std::to_string(picture_number(layer, picture));
    if (picture == 1)
        return say("packing.picture_layer", {{"number", number}, {"layer", std::to_string(layer)}});
    return say(picture == 0 ? "packing.picture_below" : "packing.picture_above",
               {{"number", number}, {"piece", marked_piece(foams.at(picture == 0 ? layer - 1 : layer))}});
}

void draw_pictures(PageFlow& flow, const PackedObject& packed) {
    const double width = (flow.width() - 2 * kPictureGap) / 3, height = width * 1.02;
    const Foams& foams = packed.design.foams;
    for (const PackedLayer& layer : packed.layers) {
        const Vec2d corner = flow.room(height + 9);
        for (std::size_t i = 0; i < kPictures.size(); ++i) {
            if (kPictures[i].lid && !foams.has(foams.at(layer.layer))) continue;
            const Vec2d at = corner + Vec2d{static_cast<double>(i) * (width + kPictureGap), 0};
            draw_packing_picture(flow.page(), at + Vec2d{2, 6}, {width - 4, height - 7}, kPictures[i], foams,
                                 packed.design.space, layer);
            flow.page().text(at + Vec2d{width / 2, height + 4.6},
                             packed.layers.size() == 1 ? caption(i, packed.items.size() > 1)
                                                       : caption(i, layer.layer, foams),
                             {kSmallText, kInk, true, TextAnchor::middle});
        }
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

/// Room for fingers beside an object, the widest first.
struct Grips {
    std::vector<Message> places;    ///< where they fit
    std::optional<Message> widest;  ///< none where there is no room at all
};

/// Whether a hand there would come to a place that is kept off.
bool near_zone(Vec3d where, const std::vector<Box3d>& zones) {
    return std::any_of(zones.begin(), zones.end(), [&](const Box3d& zone) {
        return where.y > zone.min.y - kFingerWidth && where.y < zone.max.y + kFingerWidth &&
               where.z > zone.min.z - kFingerWidth && where.z < zone.max.z + kFingerWidth;
    });
}

Grips grips(const PackedItem& item, const FoamDesign& design) {
    const auto layer = static_cast<std::size_t>(item.layer) - 1;
    const std::array<FingerRoom, 4> room =
        finger_room(item.mesh, item.placement, design.space, design.layers[layer], design.foams.pieces[layer],
                    design.foams.parting[layer]);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return room[a].mm > room[b].mm; });
    const auto place = [&](const char* code, std::size_t side) {
        return say(code, {{"side", side_text(kSides[side])},
                          {"mm", number(room[side].mm, 0)},
                          {"column", column_at(room[side].where, design.space)}});
    };
    Grips found;
    for (const std::size_t side : order) {
        if (!(room[side].mm > 0) || near_zone(room[side].where, item.zones)) continue;
        if (room[side].mm >= kFingerWidth) found.places.push_back(place("packing.place", side));
        if (!found.widest) found.widest = place("packing.widest", side);
    }
    return found;
}

Message lifting_text(const PackedObject& packed) {
    const bool open = packed.design.foams.open();
    if (packed.layers.size() > 1) return say(open ? "packing.unpack_open_layers" : "packing.unpack_layers");
    if (packed.items.size() > 1) return say(open ? "packing.unpack_open_items" : "packing.unpack_items");
    const Grips found = grips(packed.items.front(), packed.design);
    if (!found.places.empty())
        return say(open ? "packing.unpack_open" : "packing.unpack", {{"places", found.places}});
    return say(open ? "packing.unpack_open_ribbons" : "packing.unpack_ribbons",
               {{"mm", number(kFingerWidth, 0)}, {"widest", found.widest.value_or(say("figure.none"))}});
}

/// "1 camera"
std::vector<Message> items_of(const PackedObject& packed, int layer) {
    std::vector<Message> names;
    for (std::size_t i = 0; i < packed.items.size(); ++i)
        if (packed.items[i].layer == layer)
            names.push_back(
                say("packing.numbered", {{"number", std::to_string(i + 1)}, {"name", packed.items[i].name}}));
    return names;
}

/// Layer by layer from below.
std::vector<Message> laying_steps(const PackedObject& packed) {
    if (packed.layers.size() == 1)
        return {packed.items.size() == 1 ? say("packing.lay") : say("packing.lay_items")};
    std::vector<Message> steps;
    for (const PackedLayer& layer : packed.layers) {
        const std::string picture = std::to_string(picture_number(layer.layer, 1));
        steps.push_back(say("packing.lay_layer", {{"layer", std::to_string(layer.layer)},
                                                  {"items", items_of(packed, layer.layer)},
                                                  {"picture", picture}}));
        const Piece above = packed.design.foams.at(layer.layer);
        if (!above.middle()) continue;
        const bool slots = std::any_of(packed.lift.begin(), packed.lift.end(),
                                       [&](const LiftSlot& slot) { return slot.piece == above; });
        steps.push_back(say(slots ? "packing.put_middle" : "packing.put_middle_ribbons",
                            {{"piece", marked_piece(above)}}));
    }
    return steps;
}

/// Pads that reach into what lies under them keep the rims apart until the case is closed over them.
Message closing_step(const PackedObject& packed) {
    if (packed.design.foams.open()) return say("packing.leave_open");
    const bool presses =
        packed.pads.squeeze_mm > 0 && std::any_of(packed.pads.pads.begin(), packed.pads.pads.end(),
                                                  [](const FillPad& pad) { return pad.above; });
    return presses ? say("packing.close/pressing", {{"mm", number(packed.pads.squeeze_mm, 1)}})
                   : say("packing.close");
}

void tell_order(PageFlow& flow, const PackedObject& packed) {
    flow.heading(say("packing.how"));
    std::vector<Message> steps{say("packing.stand")};
    if (!packed.pads.pads.empty()) steps.push_back(say("packing.lay_pads"));
    for (Message& step : laying_steps(packed)) steps.push_back(std::move(step));
    steps.push_back(closing_step(packed));
    steps.push_back(lifting_text(packed));
    flow.steps(steps, kMarkIndent);
}

Message walls_text(const FitReport& fit) {
    const auto mm = [&](Side side) { return number(fit.wall_mm[side], 1); };
    if (fit.open)
        return say("packing.walls_of_tray", {{"floor", mm(kFloor)},
                                             {"back", mm(kBack)},
                                             {"front", mm(kFront)},
                                             {"left", mm(kLeft)},
                                             {"right", mm(kRight)}});
    return say("packing.walls_of", {{"floor", mm(kFloor)},
                                    {"lid", mm(kRoof)},
                                    {"back", mm(kBack)},
                                    {"front", mm(kFront)},
                                    {"left", mm(kLeft)},
                                    {"right", mm(kRight)}});
}

Message item_text(const PackedItem& item) {
    const std::string size = dimensions(item.size_mm);
    if (!item.mass_kg) return say("packing.object_unweighed", {{"name", item.name}, {"size", size}});
    return say("packing.object_of", {{"name", item.name}, {"size", size}, {"kg", number(*item.mass_kg, 3)}});
}

/// With where to take hold of it, where there are several.
Message listed_item(const PackedItem& item, const PackedObject& packed) {
    Message text = item_text(item);
    if (packed.items.size() == 1) return text;
    if (packed.layers.size() > 1)
        text = say("packing.in_layer", {{"item", text}, {"layer", std::to_string(item.layer)}});
    const Grips found = grips(item, packed.design);
    if (found.places.empty()) return say("packing.without_fingers", {{"item", text}});
    return say("packing.with_fingers", {{"item", text}, {"places", found.places}});
}

/// Of all items, where each is known.
std::optional<double> mass_of(const std::vector<PackedItem>& items) {
    double sum = 0;
    for (const PackedItem& item : items) {
        if (!item.mass_kg) return {};
        sum += *item.mass_kg;
    }
    return sum;
}

/// Of items and foam, where both are known.
std::optional<double> content_kg(const PackedObject& packed) {
    const std::optional<double> items = mass_of(packed.items);
    if (!items || !packed.material.foam_kg) return {};
    return *items + *packed.material.foam_kg;
}

Message foam_text(const PackedObject& packed) {
    const std::string litres = number(packed.fit.foam_mm3 * 1e-6, 2);
    const std::optional<double>& foam_kg = packed.material.foam_kg;
    if (!foam_kg) return say("figure.litres", {{"litres", litres}});
    const std::string kg = number(*foam_kg, 3);
    const auto all_kg = content_kg(packed);
    if (!all_kg) return say("packing.foam_weighs", {{"litres", litres}, {"kg", kg}});
    return say("packing.foam_and_object", {{"litres", litres}, {"kg", kg}, {"all_kg", number(*all_kg, 3)}});
}

/// What a hand lifts: each piece of foam, where several lie on each other.
std::vector<Message> piece_masses(const PackedObject& packed) {
    std::vector<Message> masses;
    const Foams& foams = packed.design.foams;
    if (!packed.material.foam_kg || foams.layers() == 1) return masses;
    const double blocks = static_cast<double>(std::max(1LL, packed.fit.foam_blocks()));
    for (const Piece piece : foams.all()) {
        const auto own = static_cast<double>(packed.fit.pieces[static_cast<std::size_t>(piece.index)].blocks);
        masses.push_back(say(
            "packing.piece_weighs",
            {{"piece", marked_piece(piece)}, {"kg", number(*packed.material.foam_kg * own / blocks, 3)}}));
    }
    return masses;
}

/// What the foam goes into, and the strips that fill what its blocks leave there.
std::vector<std::pair<Message, Message>> case_facts(const PackedObject& packed) {
    const Foams& foams = packed.design.foams;
    const Vec3d size = outer_size(foams, packed.design.space);
    if (!packed.fitted_case)
        return {
            {say("summary.case"), say("packing.any_case", {{"size", dimensions({size.z, size.y, size.x})}})}};
    std::vector<std::pair<Message, Message>> facts{{say("summary.case"), case_text(*packed.fitted_case)}};
    for (const Filler& filler : fillers(*packed.fitted_case, foams.parting.back(), foams.open()))
        facts.emplace_back(facts.size() == 1 ? say("summary.fillers") : as_it_is(""), filler_text(filler));
    return facts;
}

void tell_facts(PageFlow& flow, const PackedObject& packed) {
    const PackMaterial& material = packed.material;
    const auto fact = [&](const Message& name, const Message& what) {
        flow.item(name, what, {kBodyText, kSoftInk, true}, kFactIndent);
        flow.space(-0.8);
    };
    flow.heading(say("packing.what"));
    for (std::size_t i = 0; i < packed.items.size(); ++i)
        fact(packed.items.size() == 1 ? say("summary.object")
                                      : say("packing.item", {{"number", std::to_string(i + 1)}}),
             listed_item(packed.items[i], packed));
    const FoamDesign& design = packed.design;
    fact(say(design.foams.open() ? "packing.tray" : "packing.closed"),
         say("packing.closed_of", {{"size", dimensions(outer_size(design.foams, design.space))}}));
    for (const auto& [name, what] : case_facts(packed)) fact(name, what);
    fact(say("summary.walls"), walls_text(packed.fit));
    fact(say("summary.foam"), foam_text(packed));
    if (const auto masses = piece_masses(packed); !masses.empty())
        fact(say("packing.pieces"), say("packing.pieces_of", {{"pieces", masses}}));
    const std::string& currency = packed.options.currency;
    if (material.cost)
        fact(say("packing.material"),
             say("packing.material_of", {{"litres", number(material.litres.value_or(0) / material.copies, 2)},
                                         {"cost", number(*material.cost / material.copies, 2) +
                                                      (currency.empty() ? "" : " " + currency)}}));
}

void tell_findings(PageFlow& flow, const std::vector<Finding>& findings) {
    flow.heading(say("packing.know"));
    if (findings.empty()) flow.paragraph(say("packing.nothing_found"));
    for (const Finding& finding : findings) {
        const bool danger = finding.severity == Severity::danger;
        flow.item(say(danger                                  ? "severity.danger"
                      : finding.severity == Severity::warning ? "severity.warning"
                                                              : "severity.note"),
                  said_of_item(finding), {kBodyText, danger ? kAlarm : kSoftInk, true}, kFindingIndent);
    }
}

/// Of a pack whose drops were looked at.
bool drops_are_told(const PackedObject& packed) {
    return packed.protection && packed.protection->drop_mm && packed.protection->foam;
}

/// Whether each side is shown to be enough; none where nothing was asked.
std::optional<Message> drops_verdict(const Protection& all) {
    std::vector<Message> over;
    for (const Side side : all.worst_first()) {
        const ItemProtection& item = all.items[all.worst_item(side)];
        if (!item.asked_g) return {};
        if (!is_enough(item.faces[static_cast<std::size_t>(side)], item)) over.push_back(fallen_on(side));
    }
    return over.empty() ? say("packing.drops_enough") : say("packing.drops_over", {{"sides", over}});
}

void tell_drops(PageFlow& flow, const PackedObject& packed) {
    if (!drops_are_told(packed)) return;
    flow.heading(say("packing.drops"));
    flow.paragraph(drop_text(*packed.protection));
    if (const auto borne = borne_text(*packed.protection)) flow.paragraph(*borne);
    if (const auto verdict = drops_verdict(*packed.protection)) flow.paragraph(*verdict);
    std::vector<FallingMesh> meshes;
    for (const PackedItem& item : packed.items) meshes.push_back({item.mesh, item.placement});
    draw_drop_pictures(flow, fall_pictures(packed.design.foams, packed.design.space, meshes),
                       *packed.protection);
    flow.paragraph(say("packing.drops_claim"));
    if (!packed.protection->foam->source.empty())
        flow.paragraph(say("packing.drops_source", {{"source", packed.protection->foam->source}}));
}

void tell_zones(PageFlow& flow, const PackedObject& packed) {
    if (!packed.protection || packed.protection->zones.empty()) return;
    flow.heading(say("packing.zones"));
    for (const ZoneReport& zone : packed.protection->zones) {
        const Message what = zone_text(zone);
        const bool alone = packed.items.size() == 1;
        flow.item(
            as_it_is(std::to_string(zone.number)),
            alone ? what : say("summary.named", {{"name", packed.items[zone.item].name}, {"what", what}}),
            {kBodyText, kSoftInk}, 6);
    }
    flow.paragraph(say("packing.zones_claim"));
}

void tell_pads(PageFlow& flow, const PackedObject& packed) {
    std::vector<std::string> names;
    if (packed.items.size() > 1)
        for (const PackedItem& item : packed.items) names.push_back(item.name);
    tell_pads(flow, PadPlans{packed.pads, packed.design.foams, packed.design.space, std::move(names)});
}

void tell_unchecked(PageFlow& flow, bool dropped) {
    flow.heading(say("packing.unchecked"));
    for (const char* const code :
         {dropped ? "packing.unchecked_other_drops" : "packing.unchecked_drops", "packing.unchecked_pressure",
          "packing.unchecked_material", "packing.unchecked_model"})
        flow.item(as_it_is("-"), say(code), {kBodyText, kSoftInk}, 4);
}

}  // namespace

DrawingDocument packing_sheet(const PackedObject& packed) {
    const FoamDesign& design = packed.design;
    const std::string title = text(say("packing.title", {{"name", design.object_name}}), design.language);
    PageFlow flow(paper_mm(packed.options.paper), as_it_is(design.object_name),
                  packed.items.size() == 1
                      ? say("packing.subtitle", {{"size", dimensions(packed.items.front().size_mm)}})
                      : say("packing.subtitle_items", {{"items", packed.items.size()}}),
                  kInk, design.language);
    draw_pictures(flow, packed);
    tell_order(flow, packed);
    tell_pads(flow, packed);
    tell_facts(flow, packed);
    tell_drops(flow, packed);
    tell_zones(flow, packed);
    tell_findings(flow, packed.findings);
    tell_unchecked(flow, drops_are_told(packed));
    draw_packing_record(flow, {packed.items.size(), content_kg(packed), drops_are_told(packed)});
    DrawingDocument document{"packing-sheet", title, flow.finish(), false};
    for (Drawing& page : document.pages) page.title = title;
    return document;
}

}  // namespace snug

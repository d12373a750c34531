#include "snug/fabricate/mould/mould_guide.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/mould/mould_picture.h"
#include "snug/words/pieces.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr double kNumberIndent = 8;      // mm
constexpr std::size_t kMostListed = 60;  // parts in the guide's table; the rest are in parts.csv

Message litres(double mm3) {
    return litres_text(mm3 * 1e-6);
}

void list_parts(PageFlow& flow, const Mould& mould) {
    if (mould.made.parts.size() < 2) return;
    flow.heading(say("mould.its_parts"));
    flow.paragraph(say("mould.where_parts"), {kSmallText, kSoftInk});
    const std::vector<double> shares{0, 0.2, 0.34, 0.48, 0.64};
    flow.row({say("mould.part"), say("mould.left"), say("mould.front"), say("mould.up"), say("mould.size")},
             shares, {kSmallText, kSoftInk, true});
    const std::size_t listed = std::min(mould.made.parts.size(), kMostListed);
    for (std::size_t i = 0; i < listed; ++i) {
        const MouldPart& part = mould.made.parts[i];
        flow.row(
            {as_it_is(mould.names[i]), as_it_is(number(part.at_mm.x, 1)), as_it_is(number(part.at_mm.y, 1)),
             as_it_is(number(part.at_mm.z, 1)), as_it_is(dimensions(part.size_mm))},
            shares, {});
    }
    if (listed < mould.made.parts.size())
        flow.paragraph(say("mould.others", {{"parts", std::to_string(mould.made.parts.size() - listed)}}),
                       {kSmallText, kSoftInk});
}

/// What the picture shows, in words.
Message picture_text(const MouldPicture& picture) {
    std::vector<Message> numbers;
    if (picture.has_numbers())
        numbers.push_back(say("mould.numbers", {{"mm", number(picture.level_mm(), 2)}}));
    return say("mould.read_picture",
               {{"numbers", numbers},
                {"corner", say(picture.form.margin > 1 ? "mould.corner_rim" : "mould.corner")}});
}

std::vector<Drawing> mould_pages(const FoamDesign& design, const Mould& mould, Vec2d paper) {
    const Vec3d size = mould.form.size();
    PageFlow flow(paper, say("mould.heading", {{"half", marked_piece(mould.form.half)}}),
                  say("mould.page_of", {{"name", design.object_name},
                                        {"size", dimensions({size.z, size.y, size.x})},
                                        {"litres", litres(mould.made.pour_mm3)}}),
                  piece_ink(mould.form.half), design.language);
    MouldPicture picture(mould.form, flow.width());
    picture.move_to(flow.room(picture.height()), flow.width());
    draw_mould(flow.page(), picture, mould);
    flow.space(3);
    const Vec2d scale = flow.room(12);
    draw_core_scale(flow.page(), picture, scale);
    flow.paragraph(picture_text(picture), {kBodyText, kSoftInk});
    list_parts(flow, mould);
    return flow.finish();
}

Message pour_text(const Mould& mould) {
    const MouldForm& form = mould.form;
    return say(form.margin > 1 ? "mould.pour_to_ledge" : "mould.pour_to_top",
               {{"half", marked_piece(form.half)},
                {"litres", litres(mould.made.pour_mm3)},
                {"mm", number(form.mm(0, form.pour_level) - form.mm(0, 1), 1)}});
}

std::vector<Message> order_of_work(const std::vector<Mould>& moulds, const WorkshopOptions& options) {
    std::size_t parts = 0;
    int bores = 0;
    std::vector<Message> pours;
    for (const Mould& mould : moulds) {
        parts += mould.made.parts.size();
        bores += mould.made.bores;
        pours.push_back(pour_text(mould));
    }
    std::vector<Message> steps{say("mould.print")};
    if (parts > moulds.size()) steps.push_back(say(bores > 0 ? "mould.join_dowels" : "mould.join"));
    steps.push_back(say("mould.release"));
    steps.push_back(say("mould.pour", {{"pours", pours}}));
    steps.push_back(say("mould.cure"));
    steps.push_back(say(options.mould.rim_mm > 0 ? "mould.mark_rim" : "mould.mark"));
    steps.push_back(say("mould.pull"));
    if (moulds.size() > 1) steps.push_back(say("mould.close"));
    return steps;
}

void tell_moulds(PageFlow& flow, const std::vector<Mould>& moulds, std::size_t beds) {
    const std::vector<double> shares{0, 0.16, 0.5, 0.62, 0.82};
    flow.row({as_it_is(""), say("mould.column_outside"), say("mould.column_parts"), say("mould.column_pour"),
              say("mould.column_plastic")},
             shares, {kSmallText, kSoftInk, true});
    for (const Mould& mould : moulds) {
        const Vec3d size = mould.form.size();
        flow.row({marked_piece(mould.form.half), as_it_is(dimensions({size.z, size.y, size.x})),
                  as_it_is(std::to_string(mould.made.parts.size())), litres(mould.made.pour_mm3),
                  litres(mould.made.plastic_mm3)},
                 shares, {});
    }
    flow.paragraph(say("mould.beds", {{"beds", beds}}), {kSmallText, kSoftInk});
}

}  // namespace

DrawingDocument mould_guide(const FoamDesign& design, const std::vector<Mould>& moulds,
                            const WorkshopOptions& options, std::size_t beds) {
    const Vec2d paper = paper_mm(options.paper);
    const std::string title = text(say("mould.title", {{"name", design.object_name}}), design.language);
    PageFlow flow(paper, as_it_is(design.object_name),
                  say("mould.subtitle", {{"wall", number(options.mould.wall_mm)},
                                         {"rim", number(options.mould.rim_mm)},
                                         {"draft", number(options.mould.draft_deg)}}),
                  kInk, design.language);
    tell_moulds(flow, moulds, beds);
    flow.space(2);
    flow.heading(say("page.order_of_work"));
    flow.steps(order_of_work(moulds, options), kNumberIndent);
    DrawingDocument document{"mould-guide", title, flow.finish(), false};
    for (const Mould& mould : moulds) {
        std::vector<Drawing> pages = mould_pages(design, mould, paper);
        document.pages.insert(document.pages.end(), std::make_move_iterator(pages.begin()),
                              std::make_move_iterator(pages.end()));
    }
    for (Drawing& page : document.pages) page.title = title;
    return document;
}

}  // namespace snug

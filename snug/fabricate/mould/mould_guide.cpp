#include "snug/fabricate/mould/mould_guide.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/mould/mould_picture.h"

namespace snug {
namespace {

constexpr double kNumberIndent = 8;      // mm
constexpr std::size_t kMostListed = 60;  // parts in the guide's table; the rest are in parts.csv

std::string litres(double mm3) {
    return number(mm3 * 1e-6, 2) + " litres";
}

void list_parts(PageFlow& flow, const Mould& mould) {
    if (mould.made.parts.size() < 2) return;
    flow.heading("Its parts");
    flow.paragraph(
        "Where the least corner of each stands: mm from the left, from the front and from the table.",
        {kSmallText, kSoftInk});
    const std::vector<double> shares{0, 0.2, 0.34, 0.48, 0.64};
    flow.row({"part", "left", "front", "up", "size"}, shares, {kSmallText, kSoftInk, true});
    const std::size_t listed = std::min(mould.made.parts.size(), kMostListed);
    for (std::size_t i = 0; i < listed; ++i) {
        const MouldPart& part = mould.made.parts[i];
        flow.row({mould.names[i], number(part.at_mm.x, 1), number(part.at_mm.y, 1), number(part.at_mm.z, 1),
                  dimensions(part.size_mm)},
                 shares, {});
    }
    if (listed < mould.made.parts.size())
        flow.paragraph(
            "The other " + std::to_string(mould.made.parts.size() - listed) + " are in mould/parts.csv.",
            {kSmallText, kSoftInk});
}

std::vector<Drawing> mould_pages(const FoamDesign& design, const Mould& mould, Vec2d paper) {
    const std::string name(half_title(mould.form.half));
    const Vec3d size = mould.form.size();
    PageFlow flow(paper, name + ": the mould",
                  design.object_name + " · from above, as it stands on the table · " +
                      dimensions({size.z, size.y, size.x}) + " mm · pour " + litres(mould.made.pour_mm3),
                  half_ink(mould.form.half));
    MouldPicture picture(mould.form, flow.width());
    picture.move_to(flow.room(picture.height()), flow.width());
    draw_mould(flow.page(), picture, mould);
    flow.space(3);
    const Vec2d scale = flow.room(12);
    draw_core_scale(flow.page(), picture, scale);
    flow.paragraph(std::string("The foam lies in it cavity down: the core makes the cavity, and where it is "
                               "white the foam's rim lies on the "
                               "mould's floor. ") +
                       (picture.has_numbers() ? "Numbers are the core's height in blocks of " +
                                                    number(picture.level_mm(), 2) + " mm. "
                                              : "") +
                       "The black corner is column A1" +
                       (mould.form.margin > 1 ? ", where the mould has no rim. " : ". ") +
                       "Leaning faces are not drawn.",
                   {kBodyText, kSoftInk});
    list_parts(flow, mould);
    return flow.finish();
}

std::string pour_line(const MouldForm& form) {
    const std::string height =
        number(form.mm(0, form.pour_level) - form.mm(0, 1), 1) + " mm above the mould's floor";
    return form.margin > 1 ? "the narrow ledge that runs round below the rim, " + height
                           : "the top of the walls, " + height;
}

std::vector<std::string> order_of_work(const std::vector<Mould>& moulds, const WorkshopOptions& options) {
    std::size_t parts = 0;
    int bores = 0;
    std::string pours;
    for (const Mould& mould : moulds) {
        parts += mould.made.parts.size();
        bores += mould.made.bores;
        pours += (pours.empty() ? "" : "; ") + std::string(half_title(mould.form.half)) + ": " +
                 litres(mould.made.pour_mm3) + ", to " + pour_line(mould.form);
    }
    const bool apart = parts > moulds.size();
    std::vector<std::string> steps{
        "Print each bed as it lies, without supports: nothing overhangs. Layers of 0.2 mm or finer, walls of "
        "at least three lines; "
        "the core may be filled sparsely. Write LOWER or LID on each mould."};
    if (apart)
        steps.push_back(
            std::string("Put the parts of a mould together on a flat board as its picture shows") +
            (bores > 0 ? ", with the dowels in their bores" : "") +
            ", and glue or clamp them. Seal every joint from inside with wax, modelling clay or tape: what "
            "is poured finds every gap.");
    steps.push_back(
        "Smooth what is rough, then brush all inner faces with the release agent that the foam's or "
        "silicone's maker names; "
        "printed layers hold foam fast without it.");
    steps.push_back("Level the mould. Pour " + pours +
                    ". These are litres of what has set. Foams expand many times as they rise: weigh out by "
                    "the maker's free-rise "
                    "density, less at first, and close the top with a flat greased board that lets air out, "
                    "so that the rise ends at the line.");
    steps.push_back(
        "Let it cure as long as the maker says. Trim what stands above the line flat: that is the outer side "
        "of the foam.");
    steps.push_back(
        "Write LOWER or LID on that side, and BACK along the edge that the picture marks so, before it comes "
        "out" +
        std::string(options.mould.rim_mm > 0 ? "; the corner of the mould without a rim is column A1 at BACK."
                                             : "."));
    steps.push_back(
        "Pull the foam straight up, loosening it along the walls first; or take the mould apart at its "
        "joints. "
        "Turn it over from front to back: it is the half, cavity up; BACK now lies away from you "
        "in the lower foam, towards you in the lid.");
    steps.push_back(
        "Close the empty halves once, lid over lower foam, BACK over BACK: the rims touch all round.");
    return steps;
}

void tell_moulds(PageFlow& flow, const std::vector<Mould>& moulds, std::size_t beds) {
    const std::vector<double> shares{0, 0.16, 0.5, 0.62, 0.82};
    flow.row({"", "mould outside, mm", "parts", "to pour", "plastic, solid"}, shares,
             {kSmallText, kSoftInk, true});
    for (const Mould& mould : moulds) {
        const Vec3d size = mould.form.size();
        flow.row({std::string(half_title(mould.form.half)), dimensions({size.z, size.y, size.x}),
                  std::to_string(mould.made.parts.size()), litres(mould.made.pour_mm3),
                  litres(mould.made.plastic_mm3)},
                 shares, {});
    }
    flow.paragraph(
        "On " + counted(beds, "bed", "beds") + ": mould/bed-01.3mf and on, or each part on its own as STL.",
        {kSmallText, kSoftInk});
}

}  // namespace

DrawingDocument mould_guide(const FoamDesign& design, const std::vector<Mould>& moulds,
                            const WorkshopOptions& options, std::size_t beds) {
    const Vec2d paper = paper_mm(options.paper);
    const std::string title = design.object_name + ": mould guide";
    PageFlow flow(paper, design.object_name,
                  "Moulds to pour foam or silicone into · walls " + number(options.mould.wall_mm) +
                      " mm · rim " + number(options.mould.rim_mm) + " mm · draft " +
                      number(options.mould.draft_deg) + " degrees",
                  kInk);
    tell_moulds(flow, moulds, beds);
    flow.space(2);
    flow.heading("Order of work");
    int step = 0;
    for (const std::string& text : order_of_work(moulds, options))
        flow.item(std::to_string(++step), text, {kBodyText, kSoftInk, true}, kNumberIndent);
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

#include "snug/fabricate/mould/mould.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/rotation.h"
#include "snug/base/text.h"
#include "snug/design/option_list.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/mould/mould_form.h"
#include "snug/fabricate/mould/mould_guide.h"
#include "snug/fabricate/mould/mould_parts.h"
#include "snug/fabricate/printing/print_things.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

/// Blocks from the outer side to the cavity, those that the case lacks included.
long long cast_blocks(const Grid<Run>& kept) {
    long long blocks = 0;
    for (const Run run : kept) blocks += run.end;
    return blocks;
}

std::string word_of(Half half) {
    return half == Half::lower ? "lower" : "lid";
}

Result<std::vector<Mould>> all_moulds(const FoamDesign& design, const WorkshopOptions& options) {
    std::vector<Mould> moulds;
    for (const Half half : {Half::lower, Half::lid}) {
        const Grid<Run> kept = kept_runs(design.foams, half, design.space.blocks.x);
        if (cast_blocks(kept) == 0) continue;
        Mould mould{mould_form(half, kept, design.space.block_mm, options.mould), {}, {}};
        auto made = mould_parts(mould.form, options.mould.draft_deg, options.print);
        if (!made) return tl::unexpected(made.error());
        mould.made = std::move(*made);
        for (std::size_t i = 0; i < mould.made.parts.size(); ++i)
            mould.names.push_back(word_of(half) + "-" + two_digits(i + 1));
        moulds.push_back(std::move(mould));
    }
    if (moulds.empty()) return fail(ErrorKind::usage, say("mould.nothing_to_cast"));
    return moulds;
}

/// Where each part's least corner stands in the assembled mould, in mm from the left, from the front and from
/// the table, as the mould is seen from above, and its size there.
PackFile parts_list(const std::vector<Mould>& moulds) {
    std::string text = "part,left_mm,front_mm,up_mm,width_mm,depth_mm,height_mm,turned_deg\n";
    for (const Mould& mould : moulds)
        for (std::size_t i = 0; i < mould.made.parts.size(); ++i) {
            const MouldPart& part = mould.made.parts[i];
            text += mould.names[i];
            for (const Vec3d& v : {part.at_mm, part.size_mm})
                for (int axis = 0; axis < 3; ++axis) text += "," + number(v[axis], 4);
            text += part.turned ? ",90\n" : ",0\n";
        }
    return text_file("mould/parts.csv", text);
}

/// Below the pour level, along its whole height.
double greatest_lean_mm(const MouldForm& form, double draft_deg) {
    const SineCosine lean = sine_cosine_degrees(draft_deg);
    return lean.sine / lean.cosine * (form.mm(0, form.pour_level) - form.mm(0, 1));
}

void tell_draft(const FoamDesign& design, const std::vector<Mould>& moulds, double draft_deg,
                WorkshopPack& pack) {
    const Message lean =
        say(draft_deg == 1 ? "draft.degree" : "draft.degrees", {{"degrees", number(draft_deg)}});
    std::vector<Message> smaller, cut;
    for (const Mould& mould : moulds) {
        const Half half = mould.form.half;
        const long long blocks = cast_blocks(kept_runs(design.foams, half, design.space.blocks.x));
        const double whole = static_cast<double>(blocks) * design.space.block_volume();
        smaller.push_back(say("draft.foam", {{"foam", foam_of(half)},
                                             {"mm", number(greatest_lean_mm(mould.form, draft_deg), 1)},
                                             {"lost_litres", number((whole - mould.made.pour_mm3) * 1e-6, 2)},
                                             {"litres", number(whole * 1e-6, 2)}}));
        if (mould.made.upright_at_cuts) cut.push_back(foam_of(half));
        if (mould.made.lost_blocks > 0)
            pack.findings.push_back(
                {Severity::warning,
                 say("narrow_foam",
                     {{"blocks", mould.made.lost_blocks}, {"foam", foam_of(half)}, {"lean", lean}})});
    }
    if (draft_deg > 0)
        pack.findings.push_back({Severity::note, say("draft", {{"lean", lean}, {"foams", smaller}})});
    if (draft_deg > 0 && !cut.empty())
        pack.findings.push_back(
            {Severity::note,
             say("upright", {{"foams", cut.size() > 1 ? say("upright.both") : cut.front()}})});
}

void tell_missing(const FoamDesign& design, Half half, WorkshopPack& pack) {
    long long missing = 0;
    for (const Run kept : kept_runs(design.foams, half, design.space.blocks.x)) missing += kept.first;
    if (missing == 0) return;
    pack.findings.push_back(
        {Severity::warning,
         say("trim",
             {{"blocks", missing},
              {"foam", foam_of(half)},
              {"litres", number(static_cast<double>(missing) * design.space.block_volume() * 1e-6, 3)}})});
}

void tell_figures(const std::vector<Mould>& moulds, std::size_t bores, std::size_t beds,
                  const PrintOptions& print, WorkshopPack& pack) {
    double plastic = 0, pour = 0;
    long long parts = 0;
    for (const Mould& mould : moulds) {
        pack.figures.push_back(
            {say(mould.form.half == Half::lower ? "figure.parts_lower" : "figure.parts_lid"),
             as_it_is(std::to_string(mould.made.parts.size()))});
        plastic += mould.made.plastic_mm3;
        pour += mould.made.pour_mm3;
        parts += static_cast<long long>(mould.made.parts.size());
    }
    if (bores > 0) pack.figures.push_back({say("figure.dowels"), dowels_text(bores, print)});
    pack.figures.push_back({say("figure.beds"), as_it_is(std::to_string(beds))});
    pack.figures.push_back({say("figure.plastic"), litres_text(plastic * 1e-6)});
    for (const Mould& mould : moulds)
        pack.figures.push_back({say(mould.form.half == Half::lower ? "figure.pour_lower" : "figure.pour_lid"),
                                litres_text(mould.made.pour_mm3 * 1e-6)});
    pack.material.pieces = parts + static_cast<long long>(bores);
    pack.material.litres = pour * 1e-6;
}

}  // namespace

Result<WorkshopPack> mould_pack(const FoamDesign& design, const WorkshopOptions& options) {
    if (design.foams.layers() > 1)
        return fail(ErrorKind::usage, say("mould.layers", {{"ways", ways_for_layers()}}));
    if (const auto problem = out_of_range(options.mould)) return fail(ErrorKind::usage, problem->message);
    if (const auto problem = problem_of(options.print)) return fail(ErrorKind::usage, problem->message);
    const auto moulds = all_moulds(design, options);
    if (!moulds) return tl::unexpected(moulds.error());

    WorkshopPack pack;
    std::vector<PrintThing> things;
    std::size_t bores = 0;
    int without_joint = 0;
    for (const Mould& mould : *moulds) {
        for (std::size_t i = 0; i < mould.names.size(); ++i)
            things.push_back({mould.names[i], piece_color(mould.form.half), mould.made.parts[i].solid});
        bores += static_cast<std::size_t>(mould.made.bores);
        without_joint += mould.made.without_joint;
    }
    add_dowels(bores, options.print, things);
    const std::size_t beds =
        add_beds(things, options.print.bed_mm,
                 text(say("print.mould_title", {{"name", design.object_name}}), design.language), "mould",
                 "bed", pack);
    add_stls(things, "mould", pack);
    pack.files.push_back(parts_list(*moulds));
    pack.documents.push_back(mould_guide(design, *moulds, options, beds));
    tell_figures(*moulds, bores, beds, options.print, pack);
    for (const Mould& mould : *moulds) tell_missing(design, mould.form.half, pack);
    tell_draft(design, *moulds, options.mould.draft_deg, pack);
    if (without_joint > 0)
        pack.findings.push_back(no_dowel_finding("no_dowel/plastic", without_joint, options.print));
    return pack;
}

}  // namespace snug

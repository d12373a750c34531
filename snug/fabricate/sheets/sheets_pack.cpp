#include "snug/fabricate/sheets/sheets_pack.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/drawing_dxf.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/kit/piece_names.h"
#include "snug/fabricate/sheets/cut_piece.h"
#include "snug/fabricate/sheets/dowel_holes.h"
#include "snug/fabricate/sheets/liner_slits.h"
#include "snug/fabricate/sheets/nesting.h"
#include "snug/fabricate/sheets/sheet_assembly.h"
#include "snug/fabricate/sheets/sheet_drawing.h"
#include "snug/fabricate/sheets/sheet_findings.h"
#include "snug/fabricate/sheets/sheet_fit_test.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {
namespace {

void add_drawing(WorkshopPack& pack, const std::string& name, const Drawing& drawing,
                 const SheetOptions& options) {
    if (options.svg) pack.files.push_back(text_file(name + ".svg", drawing_svg(drawing)));
    if (options.dxf) pack.files.push_back(text_file(name + ".dxf", drawing_dxf(drawing)));
}

/// All pieces of the foams, and where their dowels go.
struct Stacks {
    SheetMeasure measure;
    std::vector<SheetStack> halves;
    std::vector<DowelHoles> dowels;
};

Result<Stacks> stacks_of(const FoamDesign& design, const SheetOptions& options) {
    if (auto problem = problem_of(options)) return fail(ErrorKind::usage, std::move(problem->message));
    const double narrowest = std::min(design.space.block_mm.y, design.space.block_mm.z);
    if (options.kerf_mm >= narrowest)
        return fail(ErrorKind::usage, say("sheets.kerf", {{"kerf_mm", number(options.kerf_mm)},
                                                          {"block_mm", number(narrowest)}}));
    const auto measure = sheet_measure(design, wanted_thickness_mm(options, design.space.block_mm.x));
    if (!measure) return tl::unexpected(measure.error());
    Stacks stacks{*measure, {}, {}};
    for (const Piece piece : design.foams.all()) {
        auto stack = sheet_stack(design, piece, *measure);
        if (!stack) return tl::unexpected(stack.error());
        stacks.dowels.push_back(dowel_holes(*stack, options));
        stacks.halves.push_back(std::move(*stack));
    }
    return stacks;
}

/// Every piece of all stacks in one list.
struct AllPieces {
    std::vector<const SheetStack*> stacks;
    std::vector<const SheetPiece*> pieces;
    std::vector<CutPiece> cuts;
    std::vector<std::string> unnumbered;
};

AllPieces all_pieces(const Stacks& stacks, const SheetOptions& options, std::span<const ItemLabel> labels) {
    AllPieces all;
    for (std::size_t half = 0; half < stacks.halves.size(); ++half) {
        const auto slits = liner_slits(stacks.halves[half], options.liner_slit_mm);
        for (const SheetPiece& piece : stacks.halves[half].pieces) {
            all.stacks.push_back(&stacks.halves[half]);
            all.pieces.push_back(&piece);
            all.cuts.push_back(
                cut_piece(stacks.halves[half], piece, stacks.dowels[half], options, labels, slits));
            if (!all.cuts.back().numbered) all.unnumbered.push_back(piece.name);
        }
    }
    return all;
}

/// All of them so many times, copy after copy.
void add_copies(AllPieces& all, int copies) {
    const AllPieces one = all;
    for (int copy = 1; copy < copies; ++copy) {
        all.stacks.insert(all.stacks.end(), one.stacks.begin(), one.stacks.end());
        all.pieces.insert(all.pieces.end(), one.pieces.begin(), one.pieces.end());
        all.cuts.insert(all.cuts.end(), one.cuts.begin(), one.cuts.end());
    }
}

std::string stock_name(int stock) {
    const std::string digits = std::to_string(stock + 1);
    return "sheets/" + (digits.size() < 2 ? "0" + digits : digits);
}

/// Where each piece lies; x and y of its cells' upper left corner, and of a point in its foam.
std::string index_csv(const AllPieces& all, const Nesting& nesting, int copies) {
    std::string text =
        "piece,half,sheet,stock,x_mm,y_mm,first_column,first_row,columns,rows,cells,point_x_mm,point_y_mm,"
        "in_offcut_of,copy\n";
    for (std::size_t i = 0; i < all.pieces.size(); ++i) {
        const SheetPiece& piece = *all.pieces[i];
        const PiecePlace& place = nesting.places[i];
        const Vec2d cell = all.stacks[i]->cell_mm;
        int column = 0;
        while (!piece.mask.contains(column, 0)) ++column;
        text += piece.name;
        text += "," + pack_stem(all.stacks[i]->piece);
        for (const int value : {piece.sheet + 1, place.stock + 1}) text += "," + std::to_string(value);
        for (const double value : {place.corner.x, place.corner.y}) text += "," + number(value, 4);
        for (const int value : {piece.column, piece.row, piece.mask.width, piece.mask.height, piece.cells})
            text += "," + std::to_string(value);
        text += "," + number(place.corner.x + (column + 0.5) * cell.x, 4);
        text += "," + number(place.corner.y + 0.5 * cell.y, 4) + ",";
        if (place.host >= 0) text += all.pieces[static_cast<std::size_t>(place.host)]->name;
        text += "," + std::to_string(i * static_cast<std::size_t>(copies) / all.pieces.size() + 1) + "\n";
    }
    return text;
}

/// The widest piece of the first stock sheet: the longer, the surer.
ScaleCheck scale_check(const AllPieces& all, const Nesting& nesting, const SheetOptions& options) {
    ScaleCheck check{stock_name(0) + (options.dxf ? ".dxf" : ".svg"), {}, 0};
    for (std::size_t i = 0; i < all.pieces.size(); ++i) {
        if (nesting.places[i].stock != 0) continue;
        const std::vector<Vec2d>& outer = all.cuts[i].outer;
        const auto [left, right] = std::minmax_element(
            outer.begin(), outer.end(), [](const Vec2d a, const Vec2d b) { return a.x < b.x; });
        if (right->x - left->x <= check.width_mm) continue;
        check.width_mm = right->x - left->x;
        check.piece = all.pieces[i]->name;
    }
    return check;
}

/// What to buy.
Message stock_text(const Nesting& nesting, double thick_mm) {
    const std::string size =
        number(nesting.stock_mm.x) + " x " + number(nesting.stock_mm.y) + " x " + number(thick_mm, 3);
    const int second = nesting.stocks - nesting.first_color_stocks;
    if (second == 0) return say("figure.stock_of", {{"sheets", nesting.stocks}, {"size", size}});
    return say("figure.stock_of/colors",
               {{"sheets", nesting.first_color_stocks}, {"others", second}, {"size", size}});
}

void add_figures(WorkshopPack& pack, const Stacks& stacks, const AllPieces& all, const Nesting& nesting,
                 int copies) {
    int sheets = 0;
    for (const SheetStack& stack : stacks.halves) sheets += copies * stack.count;
    double cut = 0, foam = 0;
    for (const CutPiece& piece : all.cuts) cut += cut_length(piece);
    for (std::size_t i = 0; i < all.pieces.size(); ++i)
        foam += all.pieces[i]->cells * all.stacks[i]->cell_mm.x * all.stacks[i]->cell_mm.y;
    const double thick = stacks.measure.thickness_mm;
    const double stock = nesting.stock_mm.x * nesting.stock_mm.y * nesting.stocks;
    pack.figures = {
        {say("figure.sheets"), say("figure.sheets_of", {{"sheets", sheets}, {"mm", number(thick, 3)}})},
        {say("figure.pieces"), as_it_is(grouped(all.pieces.size()))},
        {say("figure.stock"), stock_text(nesting, thick)},
        {say("figure.foam_in_pieces"),
         say("figure.foam_of_stock", {{"litres", number(foam * thick / 1e6, 2)},
                                      {"percent", number(100 * foam / std::max(stock, 1e-9), 0)}})},
        {say("figure.cutting"), as_it_is(number(cut / 1000, 2) + " m")},
    };
    pack.material.copies = copies;
    pack.material.pieces = static_cast<long long>(all.pieces.size());
    pack.material.litres = stock * thick / 1e6;
}

void add_stock_files(WorkshopPack& pack, const AllPieces& all, const Nesting& nesting,
                     const FoamDesign& design, const SheetMeasure& measure, const SheetOptions& options) {
    for (int stock = 0; stock < nesting.stocks; ++stock) {
        const bool colors = nesting.first_color_stocks < nesting.stocks;
        const char* const code = !colors                              ? "sheets.stock_title"
                                 : stock < nesting.first_color_stocks ? "sheets.stock_title/upper"
                                                                      : "sheets.stock_title/below";
        const Message title = say(code, {{"name", design.object_name},
                                         {"sheet", std::to_string(stock + 1)},
                                         {"sheets", std::to_string(nesting.stocks)},
                                         {"mm", number(measure.thickness_mm, 3)}});
        add_drawing(pack, stock_name(stock), stock_drawing(all.cuts, nesting, stock, title, design.language),
                    options);
    }
    pack.files.push_back(text_file("sheets/index.csv", index_csv(all, nesting, options.copies)));
}

}  // namespace

Result<WorkshopPack> sheets_pack(const FoamDesign& design, const SheetOptions& options, Vec2d page_mm) {
    const auto stacks = stacks_of(design, options);
    if (!stacks) return tl::unexpected(stacks.error());
    AllPieces all = all_pieces(*stacks, options, design.labels);
    add_copies(all, options.copies);
    std::vector<PieceToNest> to_nest;
    for (std::size_t i = 0; i < all.pieces.size(); ++i) {
        const SheetPiece& piece = *all.pieces[i];
        const bool uppermost = piece.sheet == all.stacks[i]->count - 1;
        to_nest.push_back({piece.name, &piece.mask, piece.cells, options.second_color && !uppermost ? 1 : 0});
    }
    const auto nesting = nest(to_nest, stacks->halves.front().cell_mm, options);
    if (!nesting) return tl::unexpected(nesting.error());

    WorkshopPack pack;
    add_stock_files(pack, all, *nesting, design, stacks->measure, options);
    for (const LayerTest& layer : fit_tests(design))
        if (const auto ring = sheet_fit_test(layer.test, design, options))
            add_drawing(pack, fit_test_stem(design, layer.layer), *ring, options);
    std::vector<SheetAssembly> halves;
    for (std::size_t half = 0; half < stacks->halves.size(); ++half)
        halves.push_back({stacks->halves[half], stacks->dowels[half], stacks->measure.thickness_mm});
    pack.documents.push_back(
        sheet_assembly(halves, design, options, scale_check(all, *nesting, options), page_mm));
    add_figures(pack, *stacks, all, *nesting, options.copies);
    for (const SheetAssembly& half : halves) add_sheet_findings(pack.findings, design, half, options);
    add_unnumbered_finding(pack.findings, all.unnumbered);
    sort_by_severity(pack.findings);
    return pack;
}

}  // namespace snug

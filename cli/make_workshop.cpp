#include "cli/make_workshop.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "snug/words/words.h"

#include "cli/option_values.h"
#include "cli/pdf.h"
#include "cli/wrapped.h"
#include "cli/zip.h"

namespace snug::cli {

void add_workshop_options(CLI::App& make, WorkshopArguments& arguments) {
    auto& a = arguments;
    make.add_option("--for", a.work,
                    "Also make what the workshop needs; takes the usual foam of that way of working unless "
                    "--preset names one")
        ->type_name("sponge|sheets|print|bricks|mill|mould");
    make.add_option("--paper", a.paper, "Paper of what is printed (a4)")->type_name("a4|letter|a3");
    make.add_option("--price", a.price, "Price of a litre of the material, for the cost")
        ->type_name("12.50EUR");
    make.add_option("--mass", a.mass, "Mass of the object, for the packing sheet")->type_name("KG");
    make.add_option("--sheet", a.sheet, "Sheets: their thickness (a block's depth)")->type_name("MM");
    make.add_option("--stock", a.stock, "Sheets: a sheet as it is sold (1000x600)")->type_name("LxW");
    make.add_option("--kerf", a.kerf, "Sheets: width that a cut takes away (0)")->type_name("MM");
    make.add_option("--bed", a.bed, "Print, mould: the printer's bed and height (250x210x210)")
        ->type_name("XxYxZ");
    make.add_option("--dowel", a.dowel, "Sheets, print, mould: diameter of the dowels; 0: none (6)")
        ->type_name("MM");
    add_tool_options(make, a.tools);
    make.add_flag("--dry-run", a.dry_run, "Say what would be made and what it takes; write nothing");
}

Result<std::optional<std::string>> implied_preset(const WorkshopArguments& a, const FoamChoice& choice) {
    if (!a.work) return std::nullopt;
    const auto work = workshop_from_name(*a.work);
    if (!work) return fail(ErrorKind::usage, "--for: " + unknown_workshop(*a.work));
    if (choice.preset_named || choice.from_project) return std::nullopt;
    return std::string(usual_preset(*work));
}

namespace {

/// What belongs to sheets and prints.
Result<void> apply_sheets_and_print(const WorkshopArguments& a, WorkshopOptions& options) {
    if (a.sheet) options.sheets.thickness_mm = *a.sheet;
    if (a.kerf) options.sheets.kerf_mm = *a.kerf;
    if (a.stock) {
        const auto stock = parse_rectangle("--stock", *a.stock);
        if (!stock) return tl::unexpected(stock.error());
        options.sheets.stock_mm = *stock;
    }
    if (a.bed) {
        const auto bed = parse_sizes("--bed", *a.bed);
        if (!bed) return tl::unexpected(bed.error());
        options.print.bed_mm = *bed;
    }
    if (a.dowel) {
        options.print.joint = *a.dowel > 0 ? PrintJoint::dowels : PrintJoint::none;
        if (*a.dowel == 0) options.sheets.dowels = 0;
        if (*a.dowel != 0) options.sheets.dowel_mm = options.print.dowel_diameter_mm = *a.dowel;
    }
    return {};
}

}  // namespace

Result<void> apply_workshop(const WorkshopArguments& a, Design& design) {
    WorkshopOptions& options = design.workshop;
    if (a.work) {
        const auto work = workshop_from_name(*a.work);
        if (!work) return fail(ErrorKind::usage, "--for: " + unknown_workshop(*a.work));
        options.work = *work;
    }
    if (a.paper) options.paper = *a.paper;
    if (a.mass) options.mass_kg = *a.mass;
    if (a.price) {
        const auto price = parse_price("--price", *a.price);
        if (!price) return tl::unexpected(price.error());
        options.price_per_litre = price->amount;
        options.currency = price->currency;
    }
    if (auto done = apply_sheets_and_print(a, options); !done) return done;
    return apply_tools(a.tools, options);
}

std::vector<std::string> workshop_folders() {
    std::vector<std::string> folders;
    for (const Workshop work : {Workshop::sponge, Workshop::sheets, Workshop::print, Workshop::bricks,
                                Workshop::mill, Workshop::mould})
        folders.emplace_back(workshop_name(work));
    return folders;
}

std::string workshop_summary(const WorkshopPack& pack, const Design& design, Language language) {
    std::size_t widest = 0;
    for (const PackFigure& figure : pack.figures)
        widest = std::max(widest, columns_of(text(figure.label, language)));
    const std::string_view work = workshop_name(design.workshop.work);
    std::string lines = text(say("summary.workshop", {{"work", work}}), language) + "\n";
    for (const PackFigure& figure : pack.figures)
        lines +=
            "  " + padded(text(figure.label, language), widest) + "  " + text(figure.value, language) + "\n";
    return lines;
}

Result<std::vector<PackFile>> workshop_files(const WorkshopPack& pack) {
    std::vector<PackFile> files;
    for (const PackFile& file : pack.files) files.push_back({file.name, file.bytes});
    for (const PackContainer& container : pack.containers) {
        auto bytes = write_zip(container);
        if (!bytes) return tl::unexpected(bytes.error());
        files.push_back({container.name, std::move(*bytes)});
    }
    for (const DrawingDocument& document : pack.documents) {
        auto bytes = write_pdf(document);
        if (!bytes) return tl::unexpected(bytes.error());
        files.push_back({document.name + ".pdf", std::move(*bytes)});
    }
    return files;
}

}  // namespace snug::cli

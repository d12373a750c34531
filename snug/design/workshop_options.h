#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "snug/base/vec2.h"
#include "snug/design/brick_options.h"
#include "snug/design/mill_options.h"
#include "snug/design/mould_options.h"
#include "snug/design/print_options.h"
#include "snug/design/sheet_options.h"
#include "snug/design/sponge_options.h"

namespace snug {

/// A way of working, which decides what a maker is handed. `none`: the foams' own files only.
enum class Workshop { none, sponge, sheets, print, bricks, mill, mould };
template <>
struct Names<Workshop> {
    static constexpr std::string_view list[] = {"", "sponge", "sheets", "print", "bricks", "mill", "mould"};
};
/// In the same order, the presets that they take where none is named.
constexpr std::string_view kUsualPresets[] = {"paper",      "slit-15", "sheet-10", "print",
                                              "lego-brick", "mill",    "cast"};
static_assert(std::size(kUsualPresets) == names_of<Workshop>().size());

/// Papers that are known.
constexpr std::string_view kPapers[] = {"a4", "letter", "a3"};

/// The one that a way of working takes.
[[nodiscard]] std::string_view usual_preset(Workshop workshop);

struct WorkshopOptions {
    Workshop work = Workshop::none;
    std::string paper = "a4";               ///< a4, letter or a3
    std::optional<double> price_per_litre;  ///< of the material, 0 or more; none: the cost is not known
    std::string currency;                   ///< as it stands behind the price: "EUR"; may be empty
    std::optional<double> mass_kg;          ///< of the object, above 0; none: not known
    std::optional<double> density_kg_m3;    ///< of the material, above 0; none: the preset's
    SpongeOptions sponge;
    SheetOptions sheets;
    PrintOptions print;
    BrickOptions bricks;
    MillOptions mill;
    MouldOptions mould;
    friend bool operator==(const WorkshopOptions&, const WorkshopOptions&) = default;
};

/// A sheet of this paper, upright; A4 where the name is none that problem_of() takes.
[[nodiscard]] Vec2d paper_mm(std::string_view paper);

/// --price and --dowel.
[[nodiscard]] SharedFlag<WorkshopOptions> price_flag();
[[nodiscard]] SharedFlag<WorkshopOptions> dowel_flag();

template <class Visit>
void visit_options(Visit& visit, WorkshopOptions& workshop) {
    visit.option(
        workshop.work,
        {.json = "for",
         .flag = "--for",
         .label = {"the way of working", "作り方"},
         .help = {"Also make what the workshop needs; takes the usual foam of that way of working "
                  "unless --preset names one",
                  "製作に必要なものも作ります。--preset がなければ、その作り方の通常の材料を使います"}});
    visit.option(workshop.paper, {.json = "paper",
                                  .flag = "--paper",
                                  .takes = "a4|letter|a3",
                                  .label = {"the paper", "用紙"},
                                  .help = {"Paper of what is printed", "印刷物の用紙"},
                                  .words = kPapers});
    visit.option(workshop.price_per_litre,
                 {.json = "price_per_litre",
                  .flag = "--price",
                  .range = {0, 1e6},
                  .step = 0.01,
                  .label = {"the price of a litre", "リットル単価"},
                  .help = {"Price of a litre of the material", "材料 1 リットルの価格"}});
    visit.option(workshop.currency,
                 {.json = "currency",
                  .flag = "--price",
                  .label = {"the currency", "通貨"},
                  .help = {"As it stands behind the price: EUR", "価格の後に書く文字：EUR"}});
    visit.flag(workshop, price_flag());
    visit.option(workshop.mass_kg,
                 {.json = "mass_kg",
                  .flag = "--mass",
                  .takes = "KG",
                  .unit = "kg",
                  .range = kAbove0,
                  .step = 0.01,
                  .label = {"the object's mass", "対象物の質量"},
                  .help = {"Mass of the object, for the packing sheet", "対象物の質量（梱包票に使います）"},
                  .scope = Scope::item});
    visit.option(workshop.density_kg_m3, {.json = "density_kg_m3",
                                          .flag = "--density",
                                          .takes = "KG/M3",
                                          .unit = "kg/m3",
                                          .range = kAbove0,
                                          .step = 1,
                                          .label = {"the density of the foam", "緩衝材の密度"},
                                          .help = {"Density of the material", "材料の密度"},
                                          .usual = {"the preset's", "選んだ緩衝材の値"}});
    visit.group(workshop.sponge, {.json = "sponge", .title = {"Slit sponge", "スリットスポンジ"}});
    visit.group(workshop.sheets, {.json = "sheets", .title = {"Sheets", "シート"}});
    visit.group(workshop.print, {.json = "print", .title = {"Printing", "3D プリント"}});
    visit.flag(workshop, dowel_flag());
    visit.group(workshop.bricks, {.json = "bricks", .title = {"Bricks", "ブロック玩具"}});
    visit.group(workshop.mill, {.json = "mill", .title = {"Milling", "切削"}});
    visit.group(workshop.mould, {.json = "mould", .title = {"Moulds", "型"}});
}

/// What is out of range; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const WorkshopOptions& options);

}  // namespace snug

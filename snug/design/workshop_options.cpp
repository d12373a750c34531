#include "snug/design/workshop_options.h"

#include <algorithm>
#include <iterator>

#include "snug/base/text.h"
#include "snug/design/option_list.h"
#include "snug/design/option_text.h"

namespace snug {
namespace {

/// In the order of kPapers.
constexpr Vec2d kPaperSizes[] = {{210, 297}, {215.9, 279.4}, {297, 420}};
constexpr std::size_t kLongestCurrency = 12;

/// "12.50", "12.50EUR", "12.50 EUR"
Result<void> take_price(std::string_view text, WorkshopOptions& workshop) {
    const std::size_t end = std::min(text.find_first_not_of("+-.0123456789"), text.size());
    std::string_view currency = text.substr(end);
    while (!currency.empty() && currency.front() == ' ') currency.remove_prefix(1);
    const bool word = currency.find_first_of("0123456789.,;") == std::string_view::npos;
    const auto amount = typed_number(text.substr(0, end));
    if (!word || !amount)
        return not_what_it_takes("--price", say("takes.price", {{"example", "12.50"}, {"other", "12.50EUR"}}),
                                 text);
    workshop.price_per_litre = *amount;
    workshop.currency = currency;
    return {};
}

std::optional<std::string> say_price(const WorkshopOptions& workshop) {
    if (!workshop.price_per_litre) return {};
    return exact(*workshop.price_per_litre) + workshop.currency;
}

Result<void> take_dowel(std::string_view text, WorkshopOptions& workshop) {
    const auto diameter = typed_number(text);
    if (!diameter) return not_what_it_takes("--dowel", say("takes.number_of", {{"unit", "mm"}}), text);
    workshop.print.dowels = *diameter > 0;
    if (*diameter == 0)
        workshop.sheets.dowels = 0;
    else
        workshop.sheets.dowel_mm = workshop.print.dowel_diameter_mm = *diameter;
    return {};
}

std::optional<std::string> say_dowel(const WorkshopOptions& workshop) {
    const double diameter = workshop.print.dowel_diameter_mm;
    if (!workshop.print.dowels && workshop.sheets.dowels == 0) return "0";
    if (workshop.print.dowels && workshop.sheets.dowel_mm == diameter) return exact(diameter);
    return {};
}

}  // namespace

SharedFlag<WorkshopOptions> price_flag() {
    return {.flag = "--price",
            .takes = "12.50EUR",
            .help = {"Price of a litre of the material, for the cost",
                     "材料 1 リットルの価格（費用の計算に使います）"},
            .take = take_price,
            .say = say_price};
}

SharedFlag<WorkshopOptions> dowel_flag() {
    return {.flag = "--dowel",
            .takes = "MM",
            .help = {"Sheets, print, mould: diameter of the dowels; 0: none",
                     "シート・3D プリント・型：ダボの直径。0 ならなし"},
            .take = take_dowel,
            .say = say_dowel,
            .usual = "6"};
}

std::string_view usual_preset(Workshop workshop) {
    return kUsualPresets[static_cast<std::size_t>(workshop)];
}

Vec2d paper_mm(std::string_view paper) {
    for (std::size_t i = 0; i < std::size(kPapers); ++i)
        if (kPapers[i] == paper) return kPaperSizes[i];
    return kPaperSizes[0];
}

std::optional<OptionProblem> problem_of(const WorkshopOptions& options) {
    if (auto found = out_of_range(options)) return found;
    if (options.currency.size() > kLongestCurrency)
        return OptionProblem{"currency", say("price.currency", {{"found", quoted(options.currency)}})};
    if (auto found = problem_of(options.sheets)) return found->within("sheets");
    if (auto found = problem_of(options.print)) return found->within("print");
    if (auto found = problem_of(options.bricks)) return found->within("bricks");
    return {};
}

}  // namespace snug

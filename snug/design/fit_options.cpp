#include "snug/design/fit_options.h"

#include "snug/design/option_text.h"

namespace snug {
namespace {

Result<void> take_sizes(std::string_view text, FitOptions& fit) {
    if (text == "none") {
        fit.notches.reset();
        return {};
    }
    const std::vector<double> sizes = typed_numbers(text, 'x');
    if (sizes.size() != 2 && (sizes.size() != 3 || sizes[2] <= 0))
        return not_what_it_takes("--notches",
                                 say("takes.notches", {{"example", "80x40"}, {"other", "80x40x25"}}), text);
    if (!fit.notches) fit.notches.emplace();
    fit.notches->width_mm = sizes[0];
    fit.notches->depth_mm = sizes[1];
    fit.notches->room_mm = sizes.size() == 3 ? sizes[2] : NotchOptions{}.room_mm;
    return {};
}

std::optional<std::string> say_sizes(const FitOptions& fit) {
    if (!fit.notches) return "none";
    return exact({fit.notches->width_mm, fit.notches->depth_mm, fit.notches->room_mm}, 'x');
}

Result<void> take_places(std::string_view text, NotchOptions& notches) {
    const std::vector<double> places = typed_numbers(text, ',');
    if (places.empty() || places.size() > 2)
        return not_what_it_takes("--notch-at", say("takes.places", {{"example", "0"}, {"other", "-20,10"}}),
                                 text);
    notches.first_mm = places.front();
    notches.second_mm = places.back();
    return {};
}

std::optional<std::string> say_places(const NotchOptions& notches) {
    if (!notches.first_mm || !notches.second_mm) return {};
    return exact({*notches.first_mm, *notches.second_mm}, ',');
}

Result<void> take_relief(std::string_view text, FitOptions& fit) {
    if (text == "none") {
        fit.relief.reset();
        return {};
    }
    const std::vector<double> sizes = typed_numbers(text, 'x');
    if (sizes.size() != 2)
        return not_what_it_takes("--relief", say("takes.relief", {{"example", "40x60"}, {"other", "none"}}),
                                 text);
    fit.relief = ReliefOptions{sizes[0], sizes[1]};
    return {};
}

std::optional<std::string> say_relief(const FitOptions& fit) {
    if (!fit.relief) return "none";
    return exact({fit.relief->height_mm, fit.relief->island_mm}, 'x');
}

Result<void> take_lift(std::string_view text, FitOptions& fit) {
    if (text == "none") {
        fit.lift.reset();
        return {};
    }
    const std::vector<double> sizes = typed_numbers(text, 'x');
    if (sizes.size() != 2)
        return not_what_it_takes("--lift", say("takes.lift", {{"example", "90x25"}, {"other", "none"}}),
                                 text);
    fit.lift = LiftOptions{sizes[0], sizes[1]};
    return {};
}

std::optional<std::string> say_lift(const FitOptions& fit) {
    if (!fit.lift) return "none";
    return exact({fit.lift->width_mm, fit.lift->depth_mm}, 'x');
}

Result<void> take_pads(std::string_view text, FitOptions& fit) {
    if (text == "none") {
        fit.pads.reset();
        return {};
    }
    const std::vector<double> sizes = typed_numbers(text, ',');
    if (sizes.empty() || sizes.size() > 2)
        return not_what_it_takes("--pads", say("takes.pads", {{"example", "2"}, {"other", "2,1"}}), text);
    fit.pads = PadOptions{sizes[0], sizes.size() == 2 ? sizes[1] : 0};
    return {};
}

std::optional<std::string> say_pads(const FitOptions& fit) {
    if (!fit.pads) return "none";
    return exact({fit.pads->sheet_mm, fit.pads->squeeze_mm}, ',');
}

}  // namespace

SharedFlag<FitOptions> pads_flag() {
    return {
        .flag = "--pads",
        .takes = "MM[,MM]|none",
        .help = {"Pads of sheet foam that fill what block steps leave around an item: the sheet's thickness, "
                 "and how far those above may press on it (0)",
                 "ブロックの段が残すすきまを埋める詰め板：板の厚さ、上の板が対象物を押してよい量（0）"},
        .take = take_pads,
        .say = say_pads};
}

SharedFlag<FitOptions> relief_flag() {
    return {
        .flag = "--relief",
        .takes = "40x60|none",
        .help = {"Let an item stand on islands of its foam alone: how high they stand free x how wide they "
                 "are",
                 "対象物を、緩衝材の島だけに載せます：島の周りが空いた高さ x 島の幅"},
        .take = take_relief,
        .say = say_relief};
}

SharedFlag<FitOptions> lift_flag() {
    return {.flag = "--lift",
            .takes = "90x25|none",
            .help = {"Two recesses at the edges of each piece above the lowest to lift it by: width x depth",
                     "一番下を除く各緩衝材の縁に設ける、持ち上げるための二つのくぼみ：幅 x 奥行き"},
            .take = take_lift,
            .say = say_lift};
}

SharedFlag<FitOptions> notch_size_flag() {
    return {.flag = "--notches",
            .takes = "80x40[x25]|none",
            .help = {"Two recesses beside the object for the fingers: width x depth, and room outwards (25)",
                     "対象物の脇の、指を入れる二つのくぼみ：幅 x 深さ、外への奥行き（25）"},
            .take = take_sizes,
            .say = say_sizes};
}

SharedFlag<NotchOptions> notch_place_flag() {
    return {.flag = "--notch-at",
            .takes = "MM[,MM]",
            .help = {"Their middles along the object's sides, from the middle of the space",
                     "側面に沿った指かけの中心（空間の中心から）"},
            .take = take_places,
            .say = say_places,
            .usual = {"auto", "自動"}};
}

}  // namespace snug

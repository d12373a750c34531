#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/design/option.h"

namespace snug {

/// What a finger wants beside an item: how far it reaches down, and how wide it is. mm.
constexpr double kFingerDepth = 25, kFingerWidth = 18;

/// The axis that leads from one notch to the other.
enum class NotchAxis { y, z };
template <>
struct Names<NotchAxis> {
    static constexpr std::string_view list[] = {"y", "z"};
};

/// Two opposite recesses of the lower foam beside the object, for the fingers that lift it. Lengths in mm,
/// cut in whole blocks.
struct NotchOptions {
    double width_mm = 80;             ///< along the object's side
    double depth_mm = 40;             ///< below the parting level
    double room_mm = 25;              ///< from the object outwards
    std::optional<NotchAxis> axis;    ///< none: chosen
    std::optional<double> first_mm;   ///< middle of the one at -y or -z along the other axis; none: chosen
    std::optional<double> second_mm;  ///< middle of the opposite one; none: chosen
    friend bool operator==(const NotchOptions&, const NotchOptions&) = default;
};

/// Recesses at two opposite edges of every piece above the lowest, for the hands that lift it out of the
/// case. mm, cut in whole blocks.
struct LiftOptions {
    double width_mm = 90;  ///< along the piece's edge
    double depth_mm = 25;  ///< from the edge inwards
    friend bool operator==(const LiftOptions&, const LiftOptions&) = default;
};

/// Pieces of sheet foam that fill what block steps leave between an item and the foam. mm.
struct PadOptions {
    double sheet_mm = 2;    ///< of the sheet that they are stacked from
    double squeeze_mm = 0;  ///< that those above an item press on it at most
    friend bool operator==(const PadOptions&, const PadOptions&) = default;
};

/// Foam of the lower half that is taken away under an item, so that it stands on islands alone: less foam
/// pushes back in a drop. mm, cut in whole blocks.
struct ReliefOptions {
    double height_mm = 40;  ///< that the islands stand free, nearly through the foam
    double island_mm = 60;  ///< how wide and long each is at least
    friend bool operator==(const ReliefOptions&, const ReliefOptions&) = default;
};

/// What makes the cut foam one to work and live with.
struct FitOptions {
    bool settle = false;                  ///< items are lowered until they lie on foam
    std::optional<PadOptions> pads;       ///< none: no pads
    std::optional<ReliefOptions> relief;  ///< none: an item lies on all of its foam
    double least_rib_mm = 0;              ///< foam between cavities that is thinner is cut away; 0: none is
    std::optional<NotchOptions> notches;  ///< none: no recesses
    std::optional<LiftOptions> lift;      ///< none: no recesses
    std::optional<double> creep_kpa;      ///< pressure that the foam bears for long, above 0; none: not known
    friend bool operator==(const FitOptions&, const FitOptions&) = default;
};

/// --notches and --notch-at.
[[nodiscard]] SharedFlag<FitOptions> notch_size_flag();
[[nodiscard]] SharedFlag<NotchOptions> notch_place_flag();
/// --lift.
[[nodiscard]] SharedFlag<FitOptions> lift_flag();
/// --pads.
[[nodiscard]] SharedFlag<FitOptions> pads_flag();
/// --relief.
[[nodiscard]] SharedFlag<FitOptions> relief_flag();

template <class Visit>
void visit_options(Visit& visit, NotchOptions& notches) {
    constexpr Range kSize{.least = 0, .most = 10000, .above = true};
    constexpr Range kPlace{.least = -1e6, .most = 1e6};
    visit.option(notches.width_mm,
                 {.json = "width_mm",
                  .flag = "--notches",
                  .unit = "mm",
                  .range = kSize,
                  .step = 1,
                  .label = {"the notches' width", "指かけの幅"},
                  .help = {"How wide a recess is along the object's side", "対象物の側面に沿ったくぼみの幅"},
                  .scope = Scope::item});
    visit.option(notches.depth_mm,
                 {.json = "depth_mm",
                  .flag = "--notches",
                  .unit = "mm",
                  .range = kSize,
                  .step = 1,
                  .label = {"the notches' depth", "指かけの深さ"},
                  .help = {"How far it goes down below the parting level", "分割の高さから下への深さ"},
                  .scope = Scope::item});
    visit.option(notches.room_mm,
                 {.json = "room_mm",
                  .flag = "--notches",
                  .unit = "mm",
                  .range = kSize,
                  .step = 1,
                  .label = {"the notches' room", "指かけの奥行き"},
                  .help = {"How far it reaches outwards from the object", "対象物から外への奥行き"},
                  .scope = Scope::item});
    visit.option(notches.axis,
                 {.json = "axis",
                  .flag = "--notch-axis",
                  .label = {"the notches' axis", "指かけの向き"},
                  .help = {"The axis along which they lie opposite each other", "二つが向かい合う方向の軸"},
                  .usual = {"auto", "自動"},
                  .none = "auto",
                  .scope = Scope::item});
    visit.option(notches.first_mm,
                 {.json = "first_mm",
                  .flag = "--notch-at",
                  .unit = "mm",
                  .range = kPlace,
                  .step = 1,
                  .label = {"the first notch's place", "一つ目の指かけの位置"},
                  .help = {"The middle of the recess at -y or -z, from the middle of the space",
                           "-y または -z 側のくぼみの中心（空間の中心から）"},
                  .usual = {"auto", "自動"},
                  .scope = Scope::item});
    visit.option(notches.second_mm, {.json = "second_mm",
                                     .flag = "--notch-at",
                                     .unit = "mm",
                                     .range = kPlace,
                                     .step = 1,
                                     .label = {"the second notch's place", "二つ目の指かけの位置"},
                                     .help = {"The middle of the opposite one", "反対側のくぼみの中心"},
                                     .usual = {"auto", "自動"},
                                     .scope = Scope::item});
    visit.flag(notches, notch_place_flag());
}

template <class Visit>
void visit_options(Visit& visit, LiftOptions& lift) {
    constexpr Range kSize{.least = 0, .most = 10000, .above = true};
    visit.option(lift.width_mm, {.json = "width_mm",
                                 .flag = "--lift",
                                 .unit = "mm",
                                 .range = kSize,
                                 .step = 1,
                                 .label = {"the lift slots' width", "持ち上げ口の幅"},
                                 .help = {"How wide a recess is along the edge of a piece of foam",
                                          "緩衝材の縁に沿ったくぼみの幅"}});
    visit.option(lift.depth_mm,
                 {.json = "depth_mm",
                  .flag = "--lift",
                  .unit = "mm",
                  .range = kSize,
                  .step = 1,
                  .label = {"the lift slots' depth", "持ち上げ口の奥行き"},
                  .help = {"How far it reaches from the edge inwards", "縁から内側への奥行き"}});
}

template <class Visit>
void visit_options(Visit& visit, PadOptions& pads) {
    visit.option(pads.sheet_mm,
                 {.json = "sheet_mm",
                  .flag = "--pads",
                  .unit = "mm",
                  .range = {.least = 0.2, .most = 100},
                  .step = 0.5,
                  .label = {"the pads' sheet", "詰め板の厚さ"},
                  .help = {"How thick the sheet is that pads are stacked from", "重ねて使う板の厚さ"}});
    visit.option(pads.squeeze_mm, {.json = "squeeze_mm",
                                   .flag = "--pads",
                                   .unit = "mm",
                                   .range = {.least = 0, .most = 50},
                                   .step = 0.5,
                                   .label = {"the pads' squeeze", "詰め板の押し込み"},
                                   .help = {"How far pads above an item press on it at most",
                                            "上の詰め板が対象物を押す最大の量"}});
}

template <class Visit>
void visit_options(Visit& visit, ReliefOptions& relief) {
    constexpr Range kSize{.least = 0, .most = 10000, .above = true};
    visit.option(relief.height_mm, {.json = "height_mm",
                                    .flag = "--relief",
                                    .unit = "mm",
                                    .range = kSize,
                                    .step = 1,
                                    .label = {"the relief's height", "くり抜きの高さ"},
                                    .help = {"How high the islands stand free that an item lies on",
                                             "対象物を載せる島の、周りが空いた高さ"}});
    visit.option(relief.island_mm,
                 {.json = "island_mm",
                  .flag = "--relief",
                  .unit = "mm",
                  .range = kSize,
                  .step = 1,
                  .label = {"the relief's islands", "くり抜きの島の幅"},
                  .help = {"How wide and long each island is at least", "それぞれの島の幅と長さの最小"}});
}

template <class Visit>
void visit_options(Visit& visit, FitOptions& fit) {
    visit.option(fit.settle,
                 {.json = "settle",
                  .flag = "--settle",
                  .label = {"settling", "下へ寄せる設定"},
                  .help = {"Lower items until they lie on the foam below, not above a block's step",
                           "ブロックの段の上に浮かせず、下の緩衝材に載るまで対象物を下げます"}});
    visit.flag(fit, pads_flag());
    visit.group(fit.pads, {.json = "pads", .title = {"Pads", "詰め板"}, .flag = "--pads"});
    visit.flag(fit, relief_flag());
    visit.group(fit.relief, {.json = "relief", .title = {"Relief", "くり抜き"}, .flag = "--relief"});
    visit.option(fit.least_rib_mm, {.json = "least_rib_mm",
                                    .flag = "--least-rib",
                                    .takes = "MM",
                                    .unit = "mm",
                                    .range = {.least = 0, .most = 10000},
                                    .step = 1,
                                    .label = {"the least rib", "リブの最小厚さ"},
                                    .help = {"Cut away foam between cavities that is thinner than this",
                                             "くぼみの間に残る緩衝材がこれより薄ければ切り取ります"},
                                    .usual = {"0: none", "0：なし"}});
    visit.flag(fit, notch_size_flag());
    visit.group(fit.notches, {.json = "notches", .title = {"Notches", "指かけ"}, .flag = "--notches"});
    visit.flag(fit, lift_flag());
    visit.group(fit.lift, {.json = "lift", .title = {"Lift slots", "持ち上げ口"}, .flag = "--lift"});
    visit.option(fit.creep_kpa,
                 {.json = "creep_kpa",
                  .flag = "--creep",
                  .takes = "KPA",
                  .unit = "kPa",
                  .range = {.least = 0, .most = 1e6, .above = true},
                  .label = {"the pressure that the foam bears for long", "緩衝材が長く耐える圧力"},
                  .help = {"Pressure that the foam bears for long", "緩衝材が長く耐える圧力"},
                  .usual = {"the preset's", "選んだ緩衝材の値"}});
}

}  // namespace snug

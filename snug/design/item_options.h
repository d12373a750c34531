#pragma once

#include <optional>
#include <string>

#include "snug/base/vec.h"
#include "snug/design/clearance.h"
#include "snug/design/option.h"
#include "snug/design/search_options.h"
#include "snug/design/zone.h"

namespace snug {

constexpr int kMostItems = 1000;
/// How an item is given a place on the command line, for sentences that advise it.
constexpr const char* kPlacedItem = "lens.stl:move=0x40x0";
constexpr const char* kLockedItem = "lens.stl:move=0x40x0,lock=yes";

/// An object as it lies in the case. What it leaves open is as the design has it for all.
struct ItemOptions {
    int object = 0;     ///< which of the project's objects, from 0
    std::string name;   ///< empty: its file's
    std::string group;  ///< items of one group may share a pocket; empty: of none
    int layer = 1;      ///< of the layers that stand on each other; the lowest is 1
    std::optional<Vec3d> rotation_deg;
    std::optional<Vec3d>
        offset_mm;  ///< from the middle of the space; none: beside the others, see place_items()
    std::optional<Clearance> clearance_mm;
    std::optional<double> mass_kg;
    std::optional<Vec3d> centre_mm;     ///< of its mass, in the coordinates of its file
    std::optional<double> fragility_g;  ///< what it bears
    Zones zones;                        ///< that foam keeps away from; none: the design's
    bool lock = false;                  ///< an arrangement leaves it where it is
    friend bool operator==(const ItemOptions&, const ItemOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, ItemOptions& item) {
    visit.option(item.object, {.json = "object",
                               .range = {0, kMostItems - 1},
                               .label = {"the number of the object", "対象物の番号"},
                               .help = {"Which of the project's objects it is, from 0",
                                        "プロジェクトの何番目の対象物か（0 から）"},
                               .scope = Scope::item});
    visit.option(item.name, {.json = "name",
                             .label = {"the name", "名前"},
                             .help = {"What it is called on pages", "印刷物に載る名前"},
                             .usual = {"its file's", "ファイルの名前"},
                             .scope = Scope::item,
                             .word = "name"});
    visit.option(item.group, {.json = "group",
                              .label = {"the group", "グループ"},
                              .help = {"Items of one group may share a pocket",
                                       "同じグループのものは一つのくぼみに入れられます"},
                              .usual = {"none", "なし"},
                              .scope = Scope::item,
                              .word = "group"});
    visit.option(item.layer,
                 {.json = "layer",
                  .range = {1, kMostLayers},
                  .step = 1,
                  .label = {"the layer", "段"},
                  .help = {"Which layer it lies in; 1 is the lowest", "どの段に置くか（1 が最下段）"},
                  .scope = Scope::item,
                  .word = "layer"});
    visit.option(item.rotation_deg, {.json = "rotation_deg",
                                     .unit = {"degrees", "度"},
                                     .range = {-1e6, 1e6},
                                     .step = 1,
                                     .label = {"an angle", "角度"},
                                     .help = {"Its own rotation", "これだけの回転"},
                                     .usual = {"the design's", "全体の設定"},
                                     .scope = Scope::item,
                                     .word = "rotate"});
    visit.option(item.offset_mm,
                 {.json = "offset_mm",
                  .unit = "mm",
                  .range = {-kGreatestLength, kGreatestLength},
                  .step = 1,
                  .label = {"an offset", "移動量"},
                  .help = {"Its own shift from the middle of the space", "空間の中心からの、これだけの移動"},
                  .usual = {"beside the others", "ほかのものの隣"},
                  .scope = Scope::item,
                  .word = "move"});
    visit.option(item.clearance_mm, {.json = "clearance_mm",
                                     .unit = "mm",
                                     .range = {-kGreatestLength, kGreatestLength},
                                     .step = 0.1,
                                     .label = {"the clearance", "クリアランス"},
                                     .help = {"Its own clearance", "これだけのクリアランス"},
                                     .usual = {"the design's", "全体の設定"},
                                     .scope = Scope::item,
                                     .word = "clearance"});
    visit.option(item.mass_kg, {.json = "mass_kg",
                                .unit = "kg",
                                .range = kAbove0,
                                .label = {"the mass", "質量"},
                                .help = {"Its own mass", "これだけの質量"},
                                .usual = {"the design's", "全体の設定"},
                                .scope = Scope::item,
                                .word = "mass"});
    visit.option(item.centre_mm, {.json = "centre_mm",
                                  .unit = "mm",
                                  .range = {-kFarthestPlace, kFarthestPlace},
                                  .label = {"the centre of mass", "重心"},
                                  .help = {"Where its mass is centred, in the coordinates of its file",
                                           "重心の位置（ファイルの座標）"},
                                  .usual = {"the design's", "全体の設定"},
                                  .scope = Scope::item,
                                  .word = "centre"});
    visit.option(item.fragility_g, {.json = "fragility_g",
                                    .unit = "G",
                                    .range = {.least = 1, .most = 10000},
                                    .label = {"the shock that it bears", "耐える衝撃"},
                                    .help = {"The greatest shock that it bears", "耐える最大の衝撃"},
                                    .usual = {"the design's", "全体の設定"},
                                    .scope = Scope::item,
                                    .word = "fragility"});
    visit.option(item.zones, {.json = "zones",
                              .label = {"the places to keep off", "触れない場所"},
                              .help = {"Places on it that foam keeps away from", "緩衝材を離しておく場所"},
                              .usual = {"the design's", "全体の設定"},
                              .scope = Scope::item,
                              .word = "keep-off"});
    visit.option(item.lock,
                 {.json = "lock",
                  .label = {"the lock", "固定"},
                  .help = {"An arrangement leaves it where it is", "並べるときも、この場所に残します"},
                  .scope = Scope::item,
                  .word = "lock"});
}

}  // namespace snug

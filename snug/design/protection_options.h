#pragma once

#include <optional>
#include <string>

#include "snug/base/vec.h"
#include "snug/design/clearance.h"
#include "snug/design/drop_rules.h"
#include "snug/design/foam_material.h"
#include "snug/design/option.h"
#include "snug/design/zone.h"

namespace snug {

/// What the pack must protect from, and what is known of its foam.
struct ProtectionOptions {
    std::optional<double> height_mm;          ///< of the drop; none: by `rule`
    std::optional<DropRule> rule;             ///< none of both: no drop is looked at
    std::optional<double> fragility_g;        ///< what the item bears; none: by `fragility`
    std::optional<FragilityClass> fragility;  ///< none of both: a shock is told but not judged
    /// Where the item's mass is centred, in the coordinates of its file, mm; none: of one density throughout.
    std::optional<Vec3d> centre_mm;
    Zones zones;                       ///< of each item that has none of its own
    std::optional<FoamMaterial> foam;  ///< none: nothing is known of it
    friend bool operator==(const ProtectionOptions&, const ProtectionOptions&) = default;

    [[nodiscard]] bool drops() const { return height_mm || rule; }
    /// What was asked for, G; none: nothing.
    [[nodiscard]] std::optional<double> asked_g() const {
        return fragility_g ? fragility_g
               : fragility ? std::optional(snug::fragility_g(*fragility))
                           : std::nullopt;
    }
};

/// --drop-height and --fragility: a number or a word.
[[nodiscard]] SharedFlag<ProtectionOptions> drop_height_flag();
[[nodiscard]] SharedFlag<ProtectionOptions> fragility_flag();

template <class Visit>
void visit_options(Visit& visit, ProtectionOptions& protection) {
    visit.option(protection.height_mm,
                 {.json = "height_mm",
                  .flag = "--drop-height",
                  .unit = "mm",
                  .range = {.least = 10, .most = 10000},
                  .step = 10,
                  .often = 1200,
                  .label = {"the height of the drop", "落下高さ"},
                  .help = {"From which height the closed case falls on each of its sides",
                           "閉じたケースがどの面からも落ちる高さ"}});
    visit.option(protection.rule, {.json = "rule",
                                   .flag = "--drop-height",
                                   .label = {"the rule of the drop's height", "落下高さの決まり"},
                                   .help = {"The height as a rule has it for the packed mass",
                                            "梱包後の質量に対して規格が定める高さ"}});
    visit.flag(protection, drop_height_flag());
    visit.option(protection.fragility_g,
                 {.json = "fragility_g",
                  .flag = "--fragility",
                  .unit = "G",
                  .range = {.least = 1, .most = 10000},
                  .step = 1,
                  .often = 150,
                  .label = {"the shock that the object bears", "対象物が耐える衝撃"},
                  .help = {"The greatest shock that the object bears", "対象物が耐える最大の衝撃"},
                  .scope = Scope::item});
    visit.option(protection.fragility, {.json = "fragility",
                                        .flag = "--fragility",
                                        .label = {"the class of fragility", "壊れやすさの区分"},
                                        .help = {"How delicate it is, by the low end of a class",
                                                 "壊れやすさの区分（区分の下限の値を使います）"},
                                        .scope = Scope::item});
    visit.flag(protection, fragility_flag());
    visit.option(protection.centre_mm,
                 {.json = "centre_mm",
                  .flag = "--centre",
                  .takes = "X,Y,Z",
                  .unit = "mm",
                  .range = {-kFarthestPlace, kFarthestPlace},
                  .label = {"the centre of mass", "重心"},
                  .help = {"Where the object's mass is centred, in the coordinates of its file in mm",
                           "対象物の重心の位置（ファイルの座標、mm）"},
                  .usual = {"one density is assumed", "密度は一様とみなします"},
                  .separator = ',',
                  .scope = Scope::item});
    visit.option(
        protection.zones,
        {.json = "zones",
         .flag = "--keep-off",
         .takes = "PLACE:MM",
         .label = {"the places to keep off", "触れない場所"},
         .help = {"Places that foam keeps away from, by so many mm: part=3:15, or X,Y,Z,R:15 for what "
                  "lies within R mm of a point of the file; :press=2kPa tells what they bear, :loose "
                  "that nothing may touch them",
                  "緩衝材を離しておく場所と距離（mm）：part=3:15、またはファイルの点から R mm 以内なら "
                  "X,Y,Z,R:15。:press=2kPa は耐える圧力、:loose は何も触れてはならないことを表します"},
         .usual = {"none", "なし"},
         .scope = Scope::item});
    visit.group(protection.foam,
                {.json = "foam", .title = {"The foam's data", "緩衝材のデータ"}, .flag = "--foam"});
}

/// What is out of range; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const ProtectionOptions& options);

}  // namespace snug

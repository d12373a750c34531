#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/case_options.h"
#include "snug/design/clean_options.h"
#include "snug/design/clearance.h"
#include "snug/design/fit_options.h"
#include "snug/design/hand_edit.h"
#include "snug/design/item_options.h"
#include "snug/design/option.h"
#include "snug/design/parting_levels.h"
#include "snug/design/protection_options.h"
#include "snug/design/search_options.h"
#include "snug/design/walls.h"
#include "snug/design/workshop_options.h"

// Everything that a user chooses, one struct for each stage of the method, with its default beside each
// field.

namespace snug {

/// Limits of what may be asked for.
constexpr int kMostBlocks = 4096;
constexpr double kLeastBlockSize = 0.1;        // mm
constexpr double kGreatestBlockSize = 10000;   // mm
constexpr double kLeastClearanceShare = -0.4;  // of the smallest block side

enum class Unit { mm, cm, m, in };
[[nodiscard]] double millimetres(Unit unit);
template <>
struct Names<Unit> {
    static constexpr std::string_view list[] = {"mm", "cm", "m", "in"};
};

struct ObjectOptions {
    std::optional<Unit> units;         ///< of the file; not chosen: mm, if the size is plausible
    double scale = 1;                  ///< on top of the unit, > 0
    std::optional<double> longest_mm;  ///< scales the longest side to this instead of units and scale
    bool cap = false;                  ///< span the holes of an open object
    double point_radius_mm = 0;        ///< of a cloud's points; 0: from their spacing
    CleanOptions clean;
    friend bool operator==(const ObjectOptions&, const ObjectOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, ObjectOptions& object) {
    visit.option(object.units, {.json = "units",
                                .flag = "--units",
                                .label = {"the unit", "単位"},
                                .help = {"The unit of the file", "ファイルの単位"},
                                .usual = "mm",
                                .none = "auto",
                                .scope = Scope::object});
    visit.option(object.scale, {.json = "scale",
                                .flag = "--scale",
                                .takes = "S",
                                .range = {1e-9, 1e9},
                                .label = {"the scale", "倍率"},
                                .help = {"Multiply every length by this", "すべての長さに掛ける倍率"},
                                .scope = Scope::object});
    visit.option(object.longest_mm,
                 {.json = "longest_mm",
                  .flag = "--longest",
                  .takes = "MM",
                  .unit = "mm",
                  .range = {1e-3, kGreatestLength},
                  .step = 1,
                  .label = {"the longest side", "最も長い辺"},
                  .help = {"Scale the object's longest side to this", "対象物の最も長い辺をこの長さにします"},
                  .scope = Scope::object});
    visit.option(object.cap, {.json = "cap",
                              .flag = "--cap",
                              .label = {"the cap", "穴ふさぎ"},
                              .help = {"Close the holes of an open object before cutting",
                                       "切る前に、開いた対象物の穴をふさぎます"},
                              .scope = Scope::object});
    visit.option(object.point_radius_mm, {.json = "point_radius_mm",
                                          .flag = "--point-radius",
                                          .takes = "MM",
                                          .unit = "mm",
                                          .range = {.least = 1e-6, .most = kGreatestLength, .or_zero = true},
                                          .step = 0.1,
                                          .label = {"the radius of a point", "点の半径"},
                                          .help = {"Point clouds: each point counts as a ball of this radius",
                                                   "点群：各点をこの半径の球とみなします"},
                                          .usual = {"0: from the spacing", "0：間隔から決めます"},
                                          .scope = Scope::object});
    visit.group(object.clean,
                {.json = "clean", .title = {"What is no part of the object", "対象物でないもの"}});
}

struct SpaceOptions {
    std::string preset = "paper";                     ///< the foam's name, see presets.h
    std::optional<Vec3i> blocks = Vec3i{30, 18, 18};  ///< 1 to 4096 an axis; none: the object plus walls
    Vec3d block_mm{15, 15, 22};                       ///< 0.1 to 10,000 an axis
    std::optional<Walls> wall_mm;      ///< least foam on each side; none: 50 where the space is fitted
    std::optional<double> between_mm;  ///< least foam between two items; none: see wanted_between_mm()
    /// A tray, which has no lid: how deep each item is sunk at least, up to 1 as a share of its height, above
    /// that in mm; none: foams that close.
    std::optional<double> open;
    friend bool operator==(const SpaceOptions&, const SpaceOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, SpaceOptions& space) {
    visit.option(space.preset,
                 {.json = "preset",
                  .flag = "--preset",
                  .takes = "NAME",
                  .label = {"the preset", "緩衝材の種類"},
                  .help = {"A foam that `snug presets` lists: block size and clearance",
                           "`snug presets` にある緩衝材：ブロックの大きさとクリアランスが決まります"}});
    visit.option(space.blocks, {.json = "blocks",
                                .flag = "--blocks",
                                .takes = "30x18x18|auto",
                                .range = {1, kMostBlocks},
                                .step = 1,
                                .label = {"a count of blocks", "ブロック数"},
                                .help = {"Blocks along x, y, z, or auto: the object plus walls",
                                         "x、y、z 方向のブロック数。auto なら対象物と壁に合わせます"},
                                .none = "auto"});
    visit.option(space.block_mm, {.json = "block_mm",
                                  .flag = "--block-size",
                                  .takes = "15x15x22",
                                  .unit = "mm",
                                  .range = {kLeastBlockSize, kGreatestBlockSize},
                                  .label = {"a side of a block", "ブロックの辺"},
                                  .help = {"Size of a block in mm", "ブロックの大きさ（mm）"}});
    visit.option(
        space.wall_mm,
        {.json = "wall_mm",
         .flag = "--wall",
         .takes = "MM|X,Y,Z|SIX|protect",
         .unit = "mm",
         .range = {0, kGreatestLength},
         .step = 1,
         .often = 150,
         .label = {"the wall", "壁の厚さ"},
         .help =
             {"Least foam between object and case: all sides, or X,Y,Z, or "
              "floor,roof,back,front,left,right; protect: as thick as --fragility asks",
              "対象物とケースの間に残す緩衝材の最小の厚さ：全面、または X,Y,Z、または底,上,奥,手前,左,右。"
              "protect は --fragility に足りる厚さ"},
         .usual = {"0; 50 with --blocks auto", "0、--blocks auto なら 50"}});
    visit.option(space.between_mm, {.json = "between_mm",
                                    .flag = "--between",
                                    .takes = "MM",
                                    .unit = "mm",
                                    .range = {0, kGreatestLength},
                                    .step = 1,
                                    .label = {"the foam between items", "もの同士の間の緩衝材"},
                                    .help = {"Least foam between two items that are of no common group",
                                             "同じグループでない二つのものの間に残す緩衝材の最小の厚さ"},
                                    .usual = {"a block, at least 12.7", "ブロック一つ、12.7 以上"}});
    visit.option(
        space.open,
        {.json = "open",
         .flag = "--open",
         .takes = "SHARE|MM",
         .range = {.least = 0, .most = kGreatestLength, .above = true},
         .step = 0.05,
         .often = 1,
         .label = {"how deep items are sunk", "沈める深さ"},
         .help = {"A tray without a lid: items are sunk by this share of their height or, above 1, by so "
                  "many mm",
                  "ふたのないトレイ：対象物を高さのこの割合だけ沈めます。1 より大きい値は mm です"}});
}

struct PlacementOptions {
    Vec3d rotation_deg;  ///< Euler angles psi, theta, phi about the fixed axes x, then y, then z
    Vec3d offset_mm;     ///< from the centre of the space
    friend bool operator==(const PlacementOptions&, const PlacementOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, PlacementOptions& placement) {
    visit.option(placement.rotation_deg, {.json = "rotation_deg",
                                          .flag = "--rotate",
                                          .takes = "PSI,THETA,PHI",
                                          .unit = {"degrees", "度"},
                                          .range = {-1e6, 1e6},
                                          .step = 1,
                                          .label = {"an angle", "角度"},
                                          .help = {"Degrees about the fixed axes x, then y, then z",
                                                   "固定した x、y、z 軸の順にまわす角度（度）"},
                                          .separator = ',',
                                          .scope = Scope::item});
    visit.option(placement.offset_mm,
                 {.json = "offset_mm",
                  .flag = "--move",
                  .takes = "X,Y,Z",
                  .unit = "mm",
                  .range = {-kGreatestLength, kGreatestLength},
                  .step = 1,
                  .label = {"an offset", "移動量"},
                  .help = {"Shift from the centre of the space in mm", "空間の中心からの移動（mm）"},
                  .separator = ',',
                  .scope = Scope::item});
}

struct CutOptions {
    Clearance clearance_mm;  ///< the object is grown by this
    /// The paper's literal "overlap or touch": blocks that only touch are cut too.
    bool cut_on_touch = false;
    double liner_mm = 0;  ///< of a cloth or film between object and foam, on top of the clearance, 0 or more
    /// Of the studs that stand into the cavity from both halves, on top of the clearance along x. Follows
    /// from the way of working: checked() sets it.
    double stud_mm = 0;

    /// With liner and studs; from -0.4 of the smallest block side upward.
    [[nodiscard]] Clearance whole_clearance_mm() const {
        const Clearance lined = clearance_mm + liner_mm;
        const Vec3d studs{stud_mm, 0, 0};
        return {lined.lower + studs, lined.upper + studs};
    }
    friend bool operator==(const CutOptions&, const CutOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, CutOptions& cut) {
    visit.option(
        cut.clearance_mm,
        {.json = "clearance_mm",
         .flag = "--clearance",
         .takes = "MM|X,Y,Z|SIX",
         .unit = "mm",
         .range = {-kGreatestLength, kGreatestLength},
         .step = 0.1,
         .often = 20,
         .label = {"the clearance", "クリアランス"},
         .help = {"Grow the object by this on every side: one number, or X,Y,Z, or six: X,Y,Z for the "
                  "lower foam, then for the upper; negative squeezes it, down to -0.4 of the smallest "
                  "side of a block",
                  "対象物をすべての方向にこれだけ大きくみなします：数値一つ、X,Y,Z "
                  "の三つ、または下の緩衝材の X,Y,Z と上の緩衝材の X,Y,Z "
                  "の六つ。負の値は締めつけます（ブロックの最も短い辺の -0.4 倍まで）"},
         .scope = Scope::item});
    visit.option(cut.liner_mm,
                 {.json = "liner_mm",
                  .flag = "--liner",
                  .takes = "MM",
                  .unit = "mm",
                  .range = {0, kGreatestLength},
                  .step = 0.1,
                  .label = {"the liner", "内張りの厚さ"},
                  .help = {"Thickness of a cloth between object and foam, on top of the clearance",
                           "対象物と緩衝材の間の布の厚さ（クリアランスに加わります）"}});
    visit.option(cut.cut_on_touch, {.json = "cut_on_touch",
                                    .flag = "--cut-on-touch",
                                    .label = {"the cut on touch", "触れるだけのブロックの切り取り"},
                                    .help = {"Also cut blocks that the object merely touches",
                                             "対象物が触れるだけのブロックも切ります"}});
}

struct PartingOptions {
    /// For each layer the blocks below it where no item of it touches, 0 to nx, rising; none: chosen.
    std::optional<PartingLevels> level;
    friend bool operator==(const PartingOptions&, const PartingOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, PartingOptions& parting) {
    visit.option(parting.level,
                 {.json = "level",
                  .flag = "--parting",
                  .takes = "auto|LEVEL,...",
                  .unit = {"blocks", "ブロック"},
                  .range = {0, kMostBlocks},
                  .step = 1,
                  .label = {"the parting level", "分割の高さ"},
                  .help = {"Blocks below the parting where the object does not touch, for each layer",
                           "対象物のない所で分割面の下に来るブロック数（段ごと）"},
                  .usual = {"auto", "自動"},
                  .none = "auto"});
}

/// Files that foams are written as.
constexpr std::string_view kFormats[] = {"stl", "ply"};

struct OutputOptions {
    std::vector<std::string> formats{"stl", "ply"};  ///< of the foams
    friend bool operator==(const OutputOptions&, const OutputOptions&) = default;
};

template <class Visit>
void visit_options(Visit& visit, OutputOptions& output) {
    visit.option(output.formats,
                 {.json = "formats",
                  .flag = "--formats",
                  .takes = "stl,ply",
                  .label = {"a format", "ファイルの形式"},
                  .help = {"Formats of the foams: stl, ply", "緩衝材のファイル形式：stl、ply"},
                  .usual = {"both", "両方"},
                  .words = kFormats});
}

struct Design {
    ObjectOptions object;  ///< of each object that has none of its own
    SpaceOptions space;
    PlacementOptions placement;         ///< of each item that has none of its own
    std::vector<ItemOptions> items{1};  ///< what lies in the case, 1 to kMostItems
    CutOptions cut;
    PartingOptions parting;
    HandEdits edits;  ///< by hand, of what is computed
    OutputOptions output;
    CaseOptions case_options;
    FitOptions fit;
    ProtectionOptions protection;
    SearchOptions search;
    WorkshopOptions workshop;
    friend bool operator==(const Design&, const Design&) = default;
};

template <class Visit>
void visit_options(Visit& visit, Design& design) {
    visit.group(design.object, {.json = "object", .title = {"The object", "対象物"}});
    visit.group(design.space, {.json = "space", .title = {"The design space", "空間"}});
    visit.group(design.placement, {.json = "placement", .title = {"How the object lies", "対象物の置き方"}});
    visit.group(design.items, {.json = "items", .title = {"What lies in the case", "中に置くもの"}});
    visit.group(design.cut, {.json = "cut", .title = {"What is cut away", "切り取り方"}});
    visit.group(design.fit, {.json = "fit", .title = {"A foam to work and live with", "使いやすい緩衝材"}});
    visit.group(design.parting, {.json = "parting", .title = {"Where the halves part", "分割"}});
    visit.option(
        design.edits,
        {.json = "edits",
         .flag = "--edit",
         .takes = "PIECE:J:K:N",
         .label = {"the edits by hand", "手作業の変更"},
         .help = {"Blocks that are taken out of a column by hand beside what is computed, or put back "
                  "where N is negative: lower:12:7:1, upper:12:7:-2, middle-1:12:7:1:under",
                  "計算結果に加えて手作業で列から取り除くブロック（N が負なら戻します）：lower:12:7:1、"
                  "upper:12:7:-2、middle-1:12:7:1:under"},
         .usual = {"none", "なし"}});
    visit.group(design.output, {.json = "output", .title = {"The files of the foams", "緩衝材のファイル"}});
    visit.group(design.case_options, {.json = "case", .title = {"The case", "ケース"}});
    visit.group(design.protection, {.json = "protection", .title = {"What it must bear", "耐えるべきこと"}});
    visit.group(design.search, {.json = "search", .title = {"The search", "探索"}});
    visit.group(design.workshop, {.json = "workshop", .title = {"The workshop", "製作"}});
}

/// The walls that the design asks for: the chosen ones, or 50 mm (the usual least for parcels) where the
/// space is fitted to the object, or none. Of a tray 25.4 mm (as makers of trays do) in place of 50, below it
/// in any case, and none above.
[[nodiscard]] Walls wanted_wall_mm(const SpaceOptions& space);

/// The foam that stands between two items: as chosen, or one block along y and z, at least 12.7 mm.
[[nodiscard]] double wanted_between_mm(const SpaceOptions& space);

/// The least clearance that blocks of this size take.
[[nodiscard]] double least_clearance_mm(Vec3d block_mm);
/// What foam gives way to an item: the design's choices with the item's own clearance.
[[nodiscard]] CutOptions cut_of(const ItemOptions& item, const Design& design);
/// Its own or the design's.
[[nodiscard]] const Zones& zones_of(const ItemOptions& item, const Design& design);
/// An item's own mass or the one that holds for each; and of all items, where all are known.
[[nodiscard]] std::optional<double> mass_kg(const ItemOptions& item, const Design& design);
[[nodiscard]] std::optional<double> mass_kg(const Design& design);
/// The highest level where the halves may part.
[[nodiscard]] int highest_parting(const Design& design);
/// How many layers its items lie in.
[[nodiscard]] int layers_of(const Design& design);

/// The first choice of an object that is out of range, by its path within them.
[[nodiscard]] std::optional<OptionProblem> problem_of(const ObjectOptions& object);
/// The first thing that is out of range; none where all is well. Paths are those of a project's design.
[[nodiscard]] std::optional<OptionProblem> problem_of(const Design& design);

/// The design with what follows from its other choices filled in, or the first thing that is out of range, as
/// an Error of kind `usage`.
[[nodiscard]] Result<Design> checked(Design design);

}  // namespace snug

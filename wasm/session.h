#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "snug/check/find_relief.h"
#include "snug/check/packing.h"
#include "snug/depth/item_depths.h"
#include "snug/object/object.h"
#include "snug/search/direction_map.h"
#include "snug/search/placement_search.h"

#include "wasm/object_store.h"
#include "wasm/values.h"

namespace snug::wasm {

/// {files: [{name, bytes}], report, pack}: what `snug make` writes for objects; no pack where the design
/// asks for none, and PDF and zip are left to the caller.
[[nodiscard]] val make_files(std::span<Object> objects, Project project, Language language,
                             const Progress& progress);

/// Keeps objects between calls, so that only designs and results pass between JavaScript and the library.
/// Designs are JSON texts as they stand in a project; `objects` are those that the design's items are of,
/// each {number, name, bytes, sha256, own}: the number that it was loaded by, its file, and its own choices
/// as a design's JSON text or null. Failures are {error, kind} and change nothing.
class Session {
  public:
    /// Reads a file and keeps its object under a number of its own. An implausible size is no failure: the
    /// object is kept, and its size_mm is null until a design chooses the unit. `tools`: what scenes need
    /// (scene_tools.h).
    val load(int number, const val& bytes, const std::string& name, const std::string& design,
             const val& tools);
    /// Forgets the objects of all other numbers.
    void keep(const val& numbers);
    /// What the design's object options make of an object.
    val describe(int number, const std::string& design);
    /// An object in mm, before the placement; as the file has it while it has no size in mm. {positions,
    /// indices, parts}: of each vertex the number of its part, null where there is one alone.
    [[nodiscard]] val mesh(int number) const;
    val pack(const std::string& design, const val& objects);
    /// Of the last packing: its gaps, what the objects lie on, all findings, and the relief that would do
    /// more in its drop on the floor.
    [[nodiscard]] val gaps(const val& progress);
    /// What the items of the last packing meet in a drop.
    [[nodiscard]] val drops();
    /// What squeezes what in the drop on a side (0 to 5) of the last packing, or at rest (null).
    [[nodiscard]] val contacts(const val& side);
    /// {design}: with the walls that the design asks for (protecting_walls.h).
    val protecting_walls(const std::string& design, const val& objects, const val& progress);
    /// Three whole proposals (plan.h): {plan, designs, previews}, the first plan_json() as a text, the others
    /// of each a JSON text and an SVG. `wishes`: {carrier, ways, cases, own_blocks}, the words of the command
    /// line.
    val plan(const std::string& design, const val& objects, const val& wishes, const std::string& language,
             const val& progress);
    /// Of the last packing: what becomes of the zones of its items, {zones, findings} (zone_values.h).
    [[nodiscard]] val zones();
    /// Of points (x, y, z after each other, design coordinates) from the surface of the last packing's
    /// objects.
    val distances(const val& points);
    /// Starts a search where the design stands, for one item; another object ends it.
    val start_search(const std::string& design, const val& objects);
    /// Looks on for some milliseconds.
    val search_step();
    /// Of the search: the best few placements that differ.
    [[nodiscard]] val distinct() const;
    /// The design with the fewest blocks that hold the one item and its walls, and the placement for them:
    /// {design}.
    val fit_case(const std::string& design, const val& objects, const val& progress);
    /// All items that are not locked, where they take the least room, and others that differ; `better` is
    /// given every better design on the way (arrangements.h).
    val arrange(const std::string& design, const val& objects, const val& progress, const val& better);
    /// As many of one item as go into the given space.
    val fill(const std::string& design, const val& objects, int item, const val& progress, const val& better);
    /// Starts a map of what is cut by direction, for one item in the design's space; another object ends it.
    val start_map(const std::string& design, const val& objects);
    /// Goes on with it for some milliseconds.
    val map_step();
    /// The known cases that hold the items as the design places them, the best fill first.
    val rank_cases(const std::string& design, const val& objects);
    /// What the design's way of working takes: {figures, findings}.
    val workshop_figures(const std::string& design, const val& objects);
    /// Everything that `snug make` writes for the design and the objects' files, in a language ("en", "ja").
    val output_files(const std::string& design, const val& objects, const std::string& language,
                     const val& progress);

  private:
    [[nodiscard]] Result<Project> lay_out(const std::string& design, const val& objects);
    [[nodiscard]] Result<Project> lay_out_one(const std::string& design, const val& objects);
    /// What a search of one object begins with, which is prepared for many by then.
    struct SearchedOne {
        Design design;
        Packing packing;
        std::vector<ItemZone> zones;
    };
    [[nodiscard]] Result<SearchedOne> begin_with_one(const std::string& design, const val& objects);
    Result<Protection> protection_of(Packing& packing);
    Result<std::optional<ReliefOffer>> relief_offer();
    void forget_results();
    void prepare_what_changes(const Design& design);

    ObjectStore store_;
    std::uint64_t edition_ = 0;  ///< of the store, that everything below is of
    std::optional<Packing> packing_;
    Design packed_;                         ///< that packing_ is of
    std::optional<Protection> protection_;  ///< of packing_, once it was asked for
    KeptDepths depths_;                     ///< of packing_
    std::optional<PlacementSearch> search_;
    DesignSpace searched_;
    std::optional<DirectionMap> map_;
};

}  // namespace snug::wasm

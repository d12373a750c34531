#pragma once

#include <optional>
#include <string>

#include "snug/check/packing.h"
#include "snug/check/surface_distance.h"
#include "snug/mesh/mesh.h"
#include "snug/object/object.h"
#include "snug/search/direction_map.h"
#include "snug/search/placement_search.h"

#include "wasm/values.h"

namespace snug::wasm {

/// {files: [{name, bytes}], report, pack}: what `snug make` writes for an object; no pack where the design
/// asks for none, and PDF and zip are left to the caller.
[[nodiscard]] val make_files(Object& object, Project project, Language language, const Progress& progress);

/// Keeps the object between calls, so that only designs and results pass between JavaScript and the library.
/// Designs are JSON texts as they stand in a project. Failures are {error, kind} and change nothing.
class Session {
  public:
    /// Reads a file and makes it the object. An implausible size is no failure: the object is kept, and its
    /// size_mm is null until a design chooses the unit. `tools`: what scenes need (scene_tools.h).
    val load(const val& bytes, const std::string& name, const std::string& design, const val& tools);
    /// What the design's object options make of the object that is loaded.
    val describe(const std::string& design);
    /// The object in mm, before the placement; as the file has it while it has no size in mm. {positions,
    /// indices}.
    [[nodiscard]] val mesh() const;
    val pack(const std::string& design);
    /// Of the last packing: its gaps, what the object lies on, and all findings.
    [[nodiscard]] val gaps(const val& progress) const;
    /// Of points (x, y, z after each other, design coordinates) from the surface of the last packing's
    /// object.
    val distances(const val& points);
    /// Starts a search where the design stands; another object ends it.
    val start_search(const std::string& design);
    /// Looks on for some milliseconds.
    val search_step();
    /// Of the search: the best few placements that differ.
    [[nodiscard]] val distinct() const;
    /// The design with the fewest blocks that hold the object and its walls, and the placement for them:
    /// {design}.
    val fit_case(const std::string& design, const val& progress);
    /// Starts a map of what is cut by direction, for the design's space; another object ends it.
    val start_map(const std::string& design);
    /// Goes on with it for some milliseconds.
    val map_step();
    /// The known cases that hold the object as the design places it, the best fill first.
    val rank_cases(const std::string& design);
    /// What the design's way of working takes: {figures, findings}.
    val workshop_figures(const std::string& project);
    /// Everything that `snug make` writes for the design and the object's file, in a language ("en", "ja").
    val output_files(const std::string& project, const std::string& language, const val& progress);

  private:
    [[nodiscard]] std::optional<Error> prepare_for(const Design& design);

    std::optional<Mesh> read_;  ///< as the file has it, in its own unit
    Box3d box_;                 ///< of read_
    ObjectOptions options_;     ///< that object_ was prepared with
    std::optional<Object> object_;
    std::optional<Packing> packing_;
    Design packed_;                           ///< that packing_ is of
    std::optional<SurfaceDistance> surface_;  ///< of object_, once it was asked for
    std::optional<PlacementSearch> search_;   ///< of object_
    DesignSpace searched_;
    std::optional<DirectionMap> map_;  ///< of object_
};

}  // namespace snug::wasm

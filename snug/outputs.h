#pragma once

#include <functional>
#include <optional>
#include <string>

#include "snug/design/project.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/formats/mesh_files.h"
#include "snug/pipeline.h"
#include "snug/search/search_design.h"

namespace snug {

/// A file to be written, by its name within the output folder.
struct OutputFile {
    std::string name;
    FileBytes bytes;
};

/// One line a column, j (y) over k (z), header `j,k,lower_blocks,upper_blocks`: blocks that are kept, of nx.
/// Where a case leaves blocks out, `lower_first,upper_first` follow: the first block that a half keeps, from
/// -x; 0 and nx where it keeps none.
[[nodiscard]] std::string depths_csv(const FoamPair& foams, int nx);

/// What was found out about a packing besides what it says itself.
struct Measured {
    std::optional<GapReport> gap;
    std::optional<BearingReport> bearing;
    std::optional<SearchReport> search;
    const WorkshopPack* pack = nullptr;
};

/// Gaps and bearing of a packing with foams; adds to its findings. Nothing for an object that is no mesh in
/// memory. Fails only when cancelled.
[[nodiscard]] Result<Measured> measure_fit(const Object& object, Packing& packing, const Design& design,
                                           const Progress& progress = {});

/// What was made and what a person must know of it; fields as the command line's contract names them. Without
/// foams the foam and wall fields are null; what was not measured is null or, for a search or a pack, left
/// out.
[[nodiscard]] std::string report_json(const Object& object, const Project& project, const Packing& packing,
                                      const Measured& measured);

/// Takes one file after the other, so that they need not all be held at once. An error ends the making.
using TakeFile = std::function<Result<void>(const OutputFile&)>;

/// Everything that `snug make` writes for a packing with foams, the report left out (it holds the time that
/// writing took): foams in the design's formats, depths, preview, project. Fills packing.timing.solids. Fails
/// only where `take` does.
[[nodiscard]] Result<void> make_output_files(const Object& object, const Project& project,
                                             const Measured& measured, Packing& packing,
                                             const TakeFile& take);

}  // namespace snug

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "snug/design/project.h"
#include "snug/fabricate/mesh_files.h"
#include "snug/fabricate/workshop_pack.h"
#include "snug/pipeline.h"
#include "snug/search/search_design.h"

namespace snug {

/// A file to be written, by its name within the output folder.
struct OutputFile {
    std::string name;
    FileBytes bytes;
};

/// One line a column, j (y) over k (z), header `j,k,lower_blocks,upper_blocks`.
[[nodiscard]] std::string depths_csv(const FoamPair& foams);

/// What was made and what a person must know of it; fields as the command line's contract names them. Without
/// foams the foam, wall and gap fields are null; without a search or a pack there are no fields of them.
[[nodiscard]] std::string report_json(const Object& object, const ObjectFile& file, const Packing& packing,
                                      const std::optional<GapReport>& gap,
                                      const std::optional<SearchReport>& search = {},
                                      const WorkshopPack* pack = nullptr);

/// Everything that `snug make` writes for a packing with foams, the report left out (it holds the time that
/// writing took): foams in the design's formats, depths, preview, project. Fills packing.timing.solids.
[[nodiscard]] std::vector<OutputFile> output_files(const Object& object, const Project& project,
                                                   Packing& packing);

}  // namespace snug

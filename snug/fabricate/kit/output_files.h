#pragma once

#include <functional>
#include <span>
#include <string>

#include "snug/base/result.h"
#include "snug/design/project.h"
#include "snug/fabricate/kit/made.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/foam/foams.h"
#include "snug/object/object.h"

namespace snug {

/// One line a column, j (y) over k (z), header `j,k,lower_blocks,upper_blocks`: blocks that are kept, of nx.
/// Where a case leaves blocks out, `lower_first,upper_first` follow: the first block that a half keeps, from
/// -x; 0 and nx where it keeps none. Of pieces between layers `middle_1_blocks,middle_1_first` and so on.
[[nodiscard]] std::string depths_csv(const Foams& foams, const Grid<Run>& available, int nx);

/// A drawing of the foams, opened, with what lies in them, as SVG (picture/preview.h).
[[nodiscard]] std::string preview_of(std::span<const Object> objects, const Project& project,
                                     const Made& made);

/// Takes one file after the other, so that they need not all be held at once. An error ends the making.
using TakeFile = std::function<Result<void>(const PackFile&)>;

/// The files of foams, whatever they are made of: foams in the design's formats, depths, preview, project;
/// the report is left out, since it holds the time that writing took (report_json.h). Fills
/// made.packing.timing.solids. Fails only where `take` does.
[[nodiscard]] Result<void> make_output_files(std::span<const Object> objects, const Project& project,
                                             Made& made, const TakeFile& take);

}  // namespace snug

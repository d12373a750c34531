#pragma once

#include <functional>
#include <span>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/packing.h"
#include "snug/depth/item_depths.h"
#include "snug/design/design.h"
#include "snug/design/project.h"
#include "snug/fabricate/kit/made.h"
#include "snug/fabricate/kit/output_files.h"
#include "snug/fabricate/kit/report_json.h"
#include "snug/fabricate/processes.h"
#include "snug/object/object.h"
#include "snug/object/prepare.h"
#include "snug/search/arrange.h"
#include "snug/words/words.h"

// The whole method, from objects to everything that a person gets (Fukusato and Kita, Computational Design
// and Fabrication of Protective Foam, 2025). Each stage stands in the folder of its name; make.cpp is the
// place to read them in their order:
//
//   bytes --formats--> mesh, cloud or stream --prepare()--> object in mm
//
//   pack(): objects --space-> where the items lie, and which blocks there are
//                   --depth-> for each item and column the lowest and highest x          (section 3.1)
//                   --foam--> the run of blocks that each column loses                   (section 3.2)
//                             and the two foams that stay                                (section 3.3)
//                   --check-> walls, pieces, and what a person must know
//   make():  --search-------> first a better placement or case, or how several items lie, if it is wanted
//            pack()
//            --check--------> what the items meet in a drop
//            --fabricate----> what a way of working takes to the workshop
//            --check--------> gaps, and what the items lie on
//
//   make_output_files() and report_json(), in fabricate/kit/, tell of all this in files.

namespace snug {

/// Long work that tells how far it is.
enum class Stage { walls, cut, drops, workshop, gaps };

/// What only some builds have, and whom long work tells. All of it may be left out.
struct Tools {
    /// Looks for a better placement or case of one object and writes it into the design, see search_design().
    /// None: the design stays.
    std::function<Result<SearchReport>(Object&, Design&)> search;
    /// Arranges several items and writes where they lie into the design, see arrange(). None: they lie as
    /// place_items() has it.
    std::function<Result<Arrangement>(std::span<Object>, Design&)> arrange;
    bool protecting_walls = false;  ///< the walls are chosen for what the design must bear, see that function
    LpSolver solve_lp;              ///< none: the bricks' strength is not checked, and the pack says so
    Language language = Language::english;  ///< of everything that is written or drawn for people
    /// Is asked when one begins; what it gives is told how far that stage is.
    std::function<Progress(Stage)> progress;
};

/// The foams of the design's items, which are objects of any kind. `design` must be checked() already.
/// Without foams, but with the findings `outside`, where an item leaves the space. Fails with kind `usage`
/// where a fitted space would need too many blocks or the parting level lies outside it, with kind
/// `does_not_fit` where not one block goes into the case, and, for a stream, as place() and object_depths()
/// do. `kept`: what items saw at the last packing, see item_depths(); what they see now takes its place.
[[nodiscard]] Result<Packing> pack(std::span<const Object> objects, const Design& design,
                                   const Progress& progress = {}, KeptDepths* kept = nullptr);
[[nodiscard]] Result<Packing> pack(const Object& object, const Design& design, const Progress& progress = {});

/// Everything that a person gets, ready to be written. What a search finds is written into the project, and a
/// streamed object gets its stand-in. Without foams nothing else is made. Fails as pack(), the search and
/// workshop_pack() do, and when cancelled.
[[nodiscard]] Result<Made> make(std::span<Object> objects, Project& project, const Tools& tools = {});
[[nodiscard]] Result<Made> make(Object& object, Project& project, const Tools& tools = {});

}  // namespace snug

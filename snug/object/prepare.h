#pragma once

#include <optional>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/formats/triangle_stream.h"
#include "snug/mesh/mesh.h"
#include "snug/object/object.h"

// From what was read to an object in millimetres.

namespace snug {

/// Whether an object of this size (in the file's unit) is one that no one packs in such blocks: smaller than
/// a block on every axis, or longer than 5 m. The sentence says what each unit would make of it. None where
/// the unit was chosen.
[[nodiscard]] std::optional<Error> implausible_size(Vec3d size, const Design& design);

/// Scales a mesh or cloud to millimetres, refuses an implausible size unless the unit was chosen, drops what
/// the design drops, measures the rest and looks for holes. Fails with kind `input`, and `usage` as cleaned()
/// does.
[[nodiscard]] Result<Object> prepare(Mesh mesh, const Design& design);

/// An object that is never whole in memory, after one pass over its file: its bounding box, as the design
/// turns it; a second pass where it is scaled to its longest side or lies at survey coordinates. What needs
/// all of the object at once is not known: whether it is closed, its parts and holes, undercuts. Fails as
/// above, and with kind `usage` for holes to be closed and parts to be dropped.
[[nodiscard]] Result<Object> prepare(TriangleStream stream, const Design& design,
                                     const Progress& progress = {});

/// Makes packings and climbs many times faster, with the same results. Takes about as long as reading the
/// file, so it does not pay for one packing.
void prepare_for_many(Object& object);

/// Gives a streamed object its stand-in from the cubes that a pass for depths has marked. Others have theirs.
void take_stand_in(Object& object);

/// The same before any depths were wanted, such as for a search, which the stand-in is good for: it holds the
/// object, so what holds the one holds the other. One pass.
[[nodiscard]] Result<void> mark_stand_in(Object& object, const Progress& progress = {});

}  // namespace snug

#pragma once

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/formats/triangle_stream.h"
#include "snug/pipeline.h"

namespace snug {

/// A packing of an object that was never whole in memory; of the object, its kind says what is not known.
struct StreamedPacking {
    Object object;
    Packing packing;
};

/// The method in two passes over the file: its turned bounding box, then the depth maps; a third where the
/// object is scaled to its longest side or lies at survey coordinates, and one more where the two halves have
/// clearances of their own. Depths and foams are those of pack() to the byte; what needs all of the object at
/// once is not known: whether it is closed, its parts and holes, undercuts, and so whether foam would grow
/// inside it (the note `streamed` says so). Fails as prepare() and pack() do, and with kind `usage` for holes
/// to be closed.
[[nodiscard]] Result<StreamedPacking> pack_stream(const TriangleStream& stream, const Design& design,
                                                  const Progress& progress = {});

/// The object alone, for a search: its stand-in holds all of it, so what holds the one holds the other.
[[nodiscard]] Result<Object> stand_in(const TriangleStream& stream, const Design& design,
                                      const Progress& progress = {});

}  // namespace snug

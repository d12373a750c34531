#pragma once

#include "snug/formats/threemf_model.h"
#include "snug/formats/xml_read.h"

namespace snug {

/// At the start of a `mesh`: adds it to the object and stops behind its end. Errors (input) name the line.
[[nodiscard]] Result<void> read_3mf_mesh(XmlReader& xml, double mm_per_unit, ThreeMfObject& object);

}  // namespace snug

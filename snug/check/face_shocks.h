#pragma once

#include <vector>

#include "snug/check/face_stops.h"
#include "snug/check/packing.h"
#include "snug/check/pad_contacts.h"
#include "snug/check/protection_report.h"
#include "snug/design/foam_material.h"
#include "snug/design/stress_curve.h"

namespace snug {

/// Why no drop of an item can be computed, before its foam is looked at.
[[nodiscard]] NoShock obstacle(const Protection& all, const ItemProtection& item, const Packing& packing);

/// What is told of a face: all, or what a search compares, without what is met at rest, the forces on the way
/// and how much more foam would do.
enum class FaceDetail { all, shock };

/// What each item meets on the two sides of an axis, and along x at rest: into its faces and `rest`. Items
/// that reach one another move together.
void add_face_shocks(const AxisContacts& contacts, const Packing& packing, const Curves& curves,
                     Protection& all, FaceDetail detail = FaceDetail::all);

}  // namespace snug

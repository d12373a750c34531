#pragma once

#include <array>
#include <optional>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/exact_cut.h"
#include "snug/search/shock_estimate.h"
#include "snug/search/shock_wishes.h"
#include "snug/space/design_space.h"

namespace snug {

/// What one object would meet on each side for what it bears (Protection::margins()), wherever it lies in a
/// space: estimated of many placements, by the full calculation of the few that are decided.
class ShockMargins {
  public:
    /// From where the design has it. `object`: with its mesh or stand-in; it must outlive this. Fails as
    /// lacking_for_search() and packed_shocks() do.
    [[nodiscard]] static Result<ShockMargins> start(const Object& object, const Design& design,
                                                    const DesignSpace& space, PackIt pack_it);

    /// By the full calculation.
    [[nodiscard]] const std::array<double, 6>& at_start() const { return at_start_; }
    [[nodiscard]] std::array<double, 6> estimated(const ExactCut& exact) const { return estimate_(exact); }
    /// None where it cannot be packed so.
    [[nodiscard]] std::optional<std::array<double, 6>> in_full(Vec3d rotation_deg, Vec3d offset_mm) const;

  private:
    ShockMargins(const Object& object, Design design, PackIt pack_it, std::array<double, 6> at_start,
                 ShockEstimate estimate);

    const Object* object_;
    Design design_;
    PackIt pack_it_;
    std::array<double, 6> at_start_;
    ShockEstimate estimate_;
};

}  // namespace snug

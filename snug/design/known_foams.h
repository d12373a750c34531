#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/design/foam_material.h"
#include "snug/words/words.h"

namespace snug {

/// The foams that Snug knows figures of, each of one named product and with its source.
[[nodiscard]] const std::vector<FoamMaterial>& built_in_foams();

/// A foam's title: one that Snug brings in the language, a user's own as it was written.
[[nodiscard]] std::string title_of(const FoamMaterial& foam, Language language);

/// Foams from a user's own file: a JSON array of objects with the fields of FoamMaterial, `name` and either
/// "curve", points of strain and kPa, or "points" of a cushion curve (cushion_points.h): static stress in
/// kPa, G, thickness in mm, height of the drop in mm. Fails (kind usage) with the entry and the field that
/// are wrong, or with how badly the points agree.
[[nodiscard]] Result<std::vector<FoamMaterial>> parse_foams(std::string_view json);

/// The last foam of that name, or an Error (kind usage) that lists the known names.
[[nodiscard]] Result<FoamMaterial> find_foam(const std::vector<FoamMaterial>& known, std::string_view name);

/// Puts it into the design, with what it bears for long and, where it is known, its density.
void apply(const FoamMaterial& foam, Design& design);

}  // namespace snug

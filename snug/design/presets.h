#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/words/words.h"

namespace snug {

/// A real foam or material: its blocks along x (the insertion axis), y and z, and how it is worked.
struct Preset {
    std::string name;   ///< what --preset takes
    std::string title;  ///< one line for people
    Vec3d block_mm;
    double clearance_mm = 0;
    std::optional<double> density_kg_m3;  ///< none where it depends on the maker
    std::optional<double> creep_kpa;      ///< pressure that it bears for long; none where that is not known
    bool rigid = false;                   ///< true: holds, but does not cushion
    std::string worked;                   ///< how a person gets the blocks out
    Division division = Division::none;   ///< whether it may be cut to other sizes
    std::optional<double> wall_mm = {};   ///< around things, of what is rigid; none: what they meet decides
    friend bool operator==(const Preset&, const Preset&) = default;
};

/// What a preset is, in one line: one that Snug brings in the language, a user's own as it was written.
[[nodiscard]] std::string title_of(const Preset& preset, Language language);

/// The presets that Snug brings, the default ("paper") first.
[[nodiscard]] const std::vector<Preset>& built_in_presets();

/// Presets from a user's own file: a JSON array of objects with the fields of Preset; name and block_mm are
/// required. Fails (kind usage) with the entry and the field that are wrong.
[[nodiscard]] Result<std::vector<Preset>> parse_presets(std::string_view json);

/// The last preset of that name, or an Error (kind usage) that lists the known names.
[[nodiscard]] Result<Preset> find_preset(const std::vector<Preset>& known, std::string_view name);

/// Sets the block size, clearance, division and creep limit to the preset's.
void apply(const Preset& preset, Design& design);

/// Whether what a design makes holds, but does not cushion; what a user's own preset is of is not known here.
[[nodiscard]] bool is_rigid(const Design& design);

}  // namespace snug

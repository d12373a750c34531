#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/cases.h"
#include "snug/design/design.h"
#include "snug/design/foam_material.h"
#include "snug/design/presets.h"
#include "snug/words/words.h"

// The flags of `snug make` that say something about the design, made from the table of options.

namespace snug {

/// A flag as the help shows it.
struct Flag {
    std::string name;      ///< "--least-rib"
    std::string takes;     ///< "MM"; empty: nothing, typing it is enough
    std::string help;      ///< with the default in brackets
    bool many = false;     ///< several words may follow
    bool repeats = false;  ///< it may be typed more than once
};

/// All of them, in the table's order, --set last; their help in a language.
[[nodiscard]] const std::vector<Flag>& design_flags(Language language = Language::english);

/// One flag as it was typed; several words are joined by commas.
struct TypedFlag {
    std::string flag;
    std::string text;
};

[[nodiscard]] bool was_typed(std::span<const TypedFlag> typed, std::string_view flag);

/// What names may be typed; asked for only where a name was.
struct KnownNames {
    std::function<Result<std::vector<Preset>>()> presets;
    std::function<Result<std::vector<KnownCase>>()> cases;
    std::function<Result<std::vector<FoamMaterial>>()> foams;
};

/// The presets, cases and foams that Snug brings.
[[nodiscard]] KnownNames built_in_names();

/// Puts what was typed into the design: the preset and the foam first, so that explicit sizes win, then each
/// flag in the table's order, then every --set PATH=VALUE. `from_project`: the design has its foam already,
/// so that a way of working implies none. Errors are of kind `usage` and name the flag. Ranges are for
/// checked().
[[nodiscard]] Result<Design> with_flags(std::span<const TypedFlag> typed, Design design, bool from_project,
                                        const KnownNames& known);

/// One flag of one option, such as "--wall", for commands that take few.
[[nodiscard]] Result<void> take_flag(const TypedFlag& typed, Design& design);

}  // namespace snug

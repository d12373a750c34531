#pragma once

#include <optional>
#include <string_view>

#include "snug/base/names.h"

namespace snug {

/// From which height a pack is dropped, by its gross mass.
enum class DropRule {
    ista_1a,   ///< ISTA 1A
    ista_2a,   ///< ISTA 2A
    ista_3a,   ///< ISTA 3A, its ordinary drops; not verified against the standard
    d4169_2,   ///< ASTM D4169, manual handling, assurance level II; not verified against the standard
    handling,  ///< how packs of a mass are handled, in the lineage of MIL-HDBK-304
};
template <>
struct Names<DropRule> {
    static constexpr std::string_view list[] = {"ista-1a", "ista-2a", "ista-3a", "d4169-2", "handling"};
};

/// What the rule is called in sentences: "ISTA 2A".
[[nodiscard]] std::string_view title_of(DropRule rule);
/// Whether its heights were read in two sources that agree; the others are of the field's common knowledge.
[[nodiscard]] bool is_verified(DropRule rule);
/// The height in mm; none where the pack is heavier than the rule goes.
[[nodiscard]] std::optional<double> drop_height_mm(DropRule rule, double gross_kg);

/// How delicate things are that are packed, each by the least G of its band.
enum class FragilityClass {
    museum,               ///< a museum object of which nothing is known: 25 G
    extremely_fragile,    ///< instruments that are aligned precisely: 15 to 25
    very_delicate,        ///< instruments and electronics on shock mounts: 25 to 40
    delicate,             ///< office electronics: 40 to 60
    moderately_delicate,  ///< monitors, stereos: 60 to 85
    moderately_rugged,    ///< appliances: 85 to 115
    rugged,               ///< machinery: above 115
};
template <>
struct Names<FragilityClass> {
    static constexpr std::string_view list[] = {"museum",   "extremely-fragile",   "very-delicate",
                                                "delicate", "moderately-delicate", "moderately-rugged",
                                                "rugged"};
};
/// What such a thing is taken to bear, in units of gravity: the low end of the band.
[[nodiscard]] double fragility_g(FragilityClass of);
/// Where the band is from.
[[nodiscard]] std::string_view source_of(FragilityClass of);

}  // namespace snug

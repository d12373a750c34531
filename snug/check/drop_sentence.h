#pragma once

#include <optional>

#include "snug/base/message.h"
#include "snug/base/names.h"
#include "snug/check/protection_report.h"

namespace snug {

/// What a drop of an item on a side comes to.
enum class DropVerdict {
    unknown,     ///< something is missing, or the computation did not end: NoShock says what
    meets_item,  ///< another one
    bottoms,
    thin,     ///< too much foam is thinner than its data
    over,     ///< more than was asked for, by the high end
    within,   ///< no more than that
    unasked,  ///< a shock that nothing was asked of
};
template <>
struct Names<DropVerdict> {
    static constexpr std::string_view list[] = {"unknown", "meets_item", "bottoms", "thin",
                                                "over",    "within",     "unasked"};
};
[[nodiscard]] DropVerdict verdict_on(const FaceShock& face, const ItemProtection& item);

/// Whether it is shown, or nothing was asked.
[[nodiscard]] bool is_enough(const FaceShock& face, const ItemProtection& item);

/// "34 to 49 G", or that there is no such figure.
[[nodiscard]] Message drop_range(const FaceShock& face);

/// "21 mm deep", of a drop that has a travel.
[[nodiscard]] Message drop_depth(const FaceShock& face);

/// "from 76 cm on its back: about 34 to 49 G; you asked for 40: not shown to be enough", or why there is no
/// such figure.
[[nodiscard]] Message drop_sentence(const FaceShock& face, const ItemProtection& item, const Protection& all);

/// What would do where that is not enough or no shock can be told; none where all is well or nothing is
/// known.
[[nodiscard]] std::optional<Message> drop_advice(const FaceShock& face, const ItemProtection& item,
                                                 const Protection& all);

/// Why nothing is known of what squeezes what in a drop of the item on `side`, or at rest where there is
/// none; none where it is known.
[[nodiscard]] std::optional<Message> no_contact_text(const ItemProtection& item, const Protection& all,
                                                     std::optional<Side> side);

/// Why a whole item has no figure; none for what is true of a side.
[[nodiscard]] std::optional<Message> no_shock_text(NoShock why);

}  // namespace snug

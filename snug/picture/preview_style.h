#pragma once

#include "snug/picture/canvas.h"

// The preview's look besides its foam colours.

namespace snug {

constexpr Color kPreviewInk{44, 54, 66}, kObjectInk{28, 37, 48}, kAxisInk{107, 118, 134};

inline const Stroke kDimensionStroke{{138, 148, 163}};
inline const Lettering kDimensionText{{75, 86, 101}, false, 0, 1, Stroke{kWhite, 4, {}, .8, true}};
inline const Stroke kAxisStroke{kAxisInk, 1.4, {}, 1, false, true};
inline const Lettering kAxisText{kAxisInk};
inline const Lettering kLegendText{kPreviewInk};
inline const Stroke kHingeStroke{kPreviewInk, 1.4, {14, 4, 2.5, 4}};
inline const Lettering kBackText{kPreviewInk, true, 1};
inline const Lettering kWallText{kWhite, true, 2, .92};
inline const Lettering kLowerTableText{{47, 107, 179}, true, 1};
inline const Lettering kLidTableText{{194, 106, 18}, true, 1};
constexpr Fill kTableFill{{244, 245, 247}};
inline const Stroke kTableStroke{{197, 203, 211}, 1, {5, 4}};
constexpr Fill kObjectFill{kWhite, .42};
constexpr Fill kObjectShade{{20, 32, 46}, .09};
inline const Stroke kObjectStroke{kObjectInk, 1.9, {}, 1, true};
inline const Stroke kObjectSwatchStroke{kObjectInk, 1.8};
inline const Stroke kObjectHiddenStroke{kObjectInk, 1.2, {5, 4}, .75, true};

/// The same, centred or ending where it stands.
[[nodiscard]] inline Lettering anchored(Lettering look, TextAnchor anchor) {
    look.anchor = anchor;
    return look;
}

}  // namespace snug

#pragma once

#include <span>
#include <string>

#include "snug/check/protection_report.h"
#include "snug/picture/canvas.h"
#include "snug/picture/fall_pictures.h"

namespace snug {

/// What a pack meets in a drop, for pictures of it.
struct PreviewFalls {
    const Protection& protection;
    std::string title;  ///< from which height, in which foam
};

/// The case as it falls on each of its sides, and what its worst item meets beneath, from `top` px downward;
/// gives the height that they take.
[[nodiscard]] double draw_falls(Canvas& canvas, std::span<const FallPicture> pictures,
                                const PreviewFalls& falls, double top, Language language);

}  // namespace snug

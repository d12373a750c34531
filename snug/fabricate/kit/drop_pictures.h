#pragma once

#include <span>

#include "snug/check/protection_report.h"
#include "snug/drawing/page_builder.h"
#include "snug/picture/fall_pictures.h"

namespace snug {

/// The case as it falls on each of its sides, and what its worst item meets beneath, over the page's width.
void draw_drop_pictures(PageFlow& flow, std::span<const FallPicture> pictures, const Protection& protection);

}  // namespace snug

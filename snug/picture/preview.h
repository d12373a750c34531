#pragma once

#include <span>
#include <string>

#include "snug/check/gap.h"
#include "snug/drawing/drawing.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"
#include "snug/words/words.h"

namespace snug {

/// An isometric drawing of the two halves opened like a book: the lower foam in front, seen into its
/// cavity, the lid turned over its BACK edge (-y) and lying behind it, cavity up as well; the object's
/// outline where it lies in the lower foam. Labelled LOWER, LID and BACK. The file's size follows what can be
/// seen, not nx ny nz. With a gap report, maps of the gap of each half stand below.
/// `numbered`: where items are numbered from 1, in design coordinates.
/// `language`: of its words, not of the caption. What is written on the foams is the same in all.
[[nodiscard]] Drawing preview_drawing(const Foams& foams, const DesignSpace& space, const Mesh& mesh,
                                      const Placement& placement, const std::string& caption,
                                      const GapReport* gap = nullptr, Language language = Language::english,
                                      std::span<const Vec3d> numbered = {});
/// The same as SVG.
[[nodiscard]] std::string preview_svg(const Foams& foams, const DesignSpace& space, const Mesh& mesh,
                                      const Placement& placement, const std::string& caption,
                                      const GapReport* gap = nullptr, Language language = Language::english,
                                      std::span<const Vec3d> numbered = {});

}  // namespace snug

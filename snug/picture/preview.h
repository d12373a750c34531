#pragma once

#include <span>
#include <string>
#include <vector>

#include "snug/check/gap.h"
#include "snug/drawing/drawing.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/picture/preview_falls.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"
#include "snug/space/placement.h"
#include "snug/words/words.h"

namespace snug {

/// What lies in a layer. References live as long as the packing.
struct PreviewLayer {
    const Mesh& mesh;
    const Placement& placement;
    const GapReport* gap = nullptr;
    std::vector<NumberedPlace> numbered{};
};

/// An isometric drawing of each layer between the two pieces around it, opened like a book: the piece below
/// in front, seen into its cavity, the one above turned over its BACK edge (-y) and lying behind it, cavity
/// up as well; the items' outlines where they lie in the piece below. So a piece between two layers is seen
/// from both sides. Labelled LOWER, MIDDLE 1, LID and BACK. The file's size follows what can be seen, not nx
/// ny nz. With gap reports, maps of the gap of each layer's halves stand below, and with `falls` how the case
/// falls on each side. `layers`: as many as the foams have, the lowest first. `language`: of its words, not
/// of the caption. What is written on the foams is the same in all.
[[nodiscard]] Drawing preview_drawing(const Foams& foams, const DesignSpace& space,
                                      std::span<const PreviewLayer> layers, const std::string& caption,
                                      Language language = Language::english,
                                      const PreviewFalls* falls = nullptr);
/// The same as SVG.
[[nodiscard]] std::string preview_svg(const Foams& foams, const DesignSpace& space,
                                      std::span<const PreviewLayer> layers, const std::string& caption,
                                      Language language = Language::english,
                                      const PreviewFalls* falls = nullptr);
/// Of one layer.
[[nodiscard]] std::string preview_svg(const Foams& foams, const DesignSpace& space, const Mesh& mesh,
                                      const Placement& placement, const std::string& caption,
                                      const GapReport* gap = nullptr, Language language = Language::english);

}  // namespace snug

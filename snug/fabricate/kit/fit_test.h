#pragma once

#include <optional>
#include <string>
#include <vector>

#include "snug/base/grid.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

constexpr double kLeastRing = 15;  ///< mm

/// The thinnest ring of foam that proves the object's outline before a whole block is spent: one layer of
/// blocks at the parting, where the cut is widest.
struct FitTest {
    int level = 0;       ///< the layer's number along x, from -x, 0 first
    Grid<char> opening;  ///< columns (j, k) that this layer loses; islands of foam within count as lost
    Grid<char> ring;     ///< columns that stay as foam around the opening
    int islands = 0;     ///< pieces of foam within the opening that the test leaves out
    int pieces = 0;      ///< of the ring that do not share a side
};

/// Of the two layers at the parting the one that loses more columns (the lower one among equals). The ring is
/// at least `least_ring_mm` wide where the foam is. None where neither layer loses any. `layer`: of items,
/// from 1.
[[nodiscard]] std::optional<FitTest> fit_test(const FoamDesign& design, double least_ring_mm = kLeastRing,
                                              int layer = 1);

/// One for each layer of items that has one, the lowest first.
struct LayerTest {
    int layer = 1;
    FitTest test;
};
[[nodiscard]] std::vector<LayerTest> fit_tests(const FoamDesign& design);

/// "fit-test", or of several layers "fit-test-2".
[[nodiscard]] std::string fit_test_stem(const FoamDesign& design, int layer);

}  // namespace snug

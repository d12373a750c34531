#include "snug/fabricate/print/print_labels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "snug/design/design.h"
#include "snug/fabricate/printing/print_solid.h"
#include "snug/polygon/lattice.h"

namespace snug {
namespace {

constexpr double kLetterDepth = 0.6;                  // mm: three layers of 0.2, or half of thinner foam
constexpr double kPenShare = 0.14;                    // of the letters' height
constexpr double kThinnestPen = 0.5, kWidestPen = 1;  // mm: a nozzle has 0.4
constexpr int kAroundLetters = kStepsPerMm / 2;       // of the rectangle that is left open
constexpr int kInsideTop = kStepsPerMm / 8;           // from there to the top's edge

double pen_of(const ItemLabel& label) {
    return std::clamp(kPenShare * label.height_mm, kThinnestPen, kWidestPen);
}

/// A flat top under a box.
struct FlatTop {
    int level = 0;     ///< in blocks from the part's floor
    int thinnest = 0;  ///< blocks of the part below it
};

/// None where the box leaves the part, or what lies under it is not flat or not what the piece keeps there.
std::optional<FlatTop> flat_top(const PrintPart& part, const Grid<Run>& kept, const PlanBox& box,
                                Vec3i steps) {
    const int last_j = box.greatest.y / steps.y, last_k = box.greatest.z / steps.z;
    if (box.least.y <= 0 || box.least.z <= 0 || last_j >= part.runs.ny() || last_k >= part.runs.nz())
        return {};
    FlatTop top{part.runs(box.least.y / steps.y, box.least.z / steps.z).end, kMostBlocks};
    for (int j = box.least.y / steps.y; j <= last_j; ++j)
        for (int k = box.least.z / steps.z; k <= last_k; ++k) {
            const Run run = part.runs(j, k);
            if (run.none() || run.end != top.level ||
                kept(part.first.y + j, part.first.z + k).end != part.first.x + top.level)
                return {};
            top.thinnest = std::min<int>(top.thinnest, run.end - run.first);
        }
    return top;
}

PlanRegion moved(const PlanRegion& region, PlanPoint by) {
    PlanRegion result = region;
    for (PlanBand& band : result.bands) {
        band.begin += by.y;
        band.end += by.y;
        for (PlanSpan& span : band.spans) span = {span.begin + by.z, span.end + by.z};
    }
    return result;
}

std::optional<SunkLetters> on_part(const PlanRegion& letters, const PrintPart& part, const Grid<Run>& kept,
                                   Vec3i steps, double level_mm) {
    SunkLetters sunk;
    sunk.letters = moved(letters, {-part.first.y * steps.y, -part.first.z * steps.z});
    const auto top = flat_top(part, kept, box_around(sunk.letters, kAroundLetters + kInsideTop), steps);
    if (!top) return {};
    sunk.level = top->level;
    sunk.box = box_around(sunk.letters, kAroundLetters);
    sunk.depth_mm = std::min(kLetterDepth, top->thinnest * level_mm / 2);
    return sunk;
}

}  // namespace

PrintLabels print_labels(std::span<const ItemLabel> labels, const PrintLayout& layout, const Grid<Run>& kept,
                         Vec3d block_mm) {
    PrintLabels made;
    made.of_part.resize(layout.parts.size());
    const Vec3i steps = block_steps(block_mm);
    for (const ItemLabel& label : labels) {
        const PlanRegion letters = inked(label_lines(label), pen_of(label));
        if (letters.empty()) continue;
        bool found = false;
        for (std::size_t i = 0; i < layout.parts.size() && !found; ++i)
            if (auto sunk = on_part(letters, layout.parts[i], kept, steps, block_mm.x)) {
                made.volume_mm3 +=
                    sunk->depth_mm * static_cast<double>(area_of(letters)) / kStepsPerMm / kStepsPerMm;
                made.of_part[i].push_back(std::move(*sunk));
                found = true;
            }
        if (!found) made.cut.push_back(label.words);
    }
    return made;
}

}  // namespace snug

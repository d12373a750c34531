#include "snug/fabricate/print/print_labels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "snug/fabricate/printing/print_solid.h"
#include "snug/polygon/lattice.h"

namespace snug {
namespace {

constexpr double kLetterDepth = 0.6;                  // mm: three layers of 0.2
constexpr double kPenShare = 0.14;                    // of the letters' height
constexpr double kThinnestPen = 0.5, kWidestPen = 1;  // mm: a nozzle has 0.4
constexpr int kAroundLetters = kStepsPerMm / 2;       // of the rectangle that is left open
constexpr int kInsideTop = kStepsPerMm / 8;           // from there to the top's edge

double pen_of(const ItemLabel& label) {
    return std::clamp(kPenShare * label.height_mm, kThinnestPen, kWidestPen);
}

/// The part's only level under a box, where that is what the piece keeps there; none where the box leaves
/// the part or the foam is not flat.
std::optional<int> flat_level(const PrintPart& part, const Grid<Run>& kept, const PlanBox& box, Vec3i steps) {
    const int last_j = box.greatest.y / steps.y, last_k = box.greatest.z / steps.z;
    if (box.least.y <= 0 || box.least.z <= 0 || last_j >= part.runs.ny() || last_k >= part.runs.nz())
        return {};
    const int level = part.runs(box.least.y / steps.y, box.least.z / steps.z).end;
    for (int j = box.least.y / steps.y; j <= last_j; ++j)
        for (int k = box.least.z / steps.z; k <= last_k; ++k) {
            const Run run = part.runs(j, k);
            if (run.none() || run.end != level ||
                kept(part.first.y + j, part.first.z + k).end != part.first.x + level)
                return {};
        }
    return level;
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
                                   Vec3i steps) {
    SunkLetters sunk;
    sunk.letters = moved(letters, {-part.first.y * steps.y, -part.first.z * steps.z});
    const auto level = flat_level(part, kept, box_around(sunk.letters, kAroundLetters + kInsideTop), steps);
    if (!level) return {};
    sunk.level = *level;
    sunk.box = box_around(sunk.letters, kAroundLetters);
    sunk.depth_mm = kLetterDepth;
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
            if (auto sunk = on_part(letters, layout.parts[i], kept, steps)) {
                made.of_part[i].push_back(std::move(*sunk));
                found = true;
            }
        if (found)
            made.volume_mm3 +=
                kLetterDepth * static_cast<double>(area_of(letters)) / kStepsPerMm / kStepsPerMm;
        else
            made.cut.push_back(label.words);
    }
    return made;
}

}  // namespace snug

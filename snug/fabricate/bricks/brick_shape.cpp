#include "snug/fabricate/bricks/brick_shape.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "snug/base/text.h"
#include "snug/design/brick_parts.h"

namespace snug {
namespace {

constexpr double kRounding = 1e-6;  // of a length, for sizes that were typed

/// How often `unit` goes into the length; 0 where it is no whole number of times.
int times(double length_mm, double unit_mm) {
    const double count = std::round(length_mm / unit_mm);
    return count >= 1 && count < 1e6 && std::abs(length_mm - count * unit_mm) <= kRounding * length_mm
               ? static_cast<int>(count)
               : 0;
}

double nearest(double length_mm, double unit_mm) {
    return std::max(1.0, std::round(length_mm / unit_mm)) * unit_mm;
}

}  // namespace

Result<BlockInStuds> block_in_studs(Vec3d block, BrickUnit unit) {
    const double height = unit == BrickUnit::brick ? kPlatesInBrick * kPlateHeight : kPlateHeight;
    const int layers = times(block.x, height);
    const BlockInStuds studs{times(block.y, kBrickPitch), times(block.z, kBrickPitch),
                             layers * (unit == BrickUnit::brick ? kPlatesInBrick : 1)};
    if (studs.plates > 0 && studs.rows > 0 && studs.columns > 0) return studs;
    const Message heights = say(unit == BrickUnit::brick   ? "bricks.high_bricks"
                                : unit == BrickUnit::plate ? "bricks.high_plates"
                                                           : "bricks.high_either");
    return fail(ErrorKind::usage,
                say("bricks.no_bricks",
                    {{"size", dimensions(block, 3)},
                     {"heights", heights},
                     {"nearest", dimensions({nearest(block.x, height), nearest(block.y, kBrickPitch),
                                             nearest(block.z, kBrickPitch)})}}));
}

int BrickShape::layers() const {
    return top.size() == 0 ? 0 : *std::max_element(top.begin(), top.end());
}

long long BrickShape::studs() const {
    long long count = 0;
    for (std::size_t i = 0; i < top.size(); ++i) count += std::max(0, top[i] - first[i]);
    return count;
}

BrickShape brick_shape(const FoamDesign& design, Half half, const BlockInStuds& block, int plates_a_layer) {
    const bool lower = half == Half::lower;
    const Grid<Run> kept = kept_runs(design.foams, half, design.space.blocks.x);
    const int layers = block.plates / plates_a_layer;
    const int rows = kept.ny() * block.rows, columns = kept.nz() * block.columns;
    BrickShape shape{half, plates_a_layer, Grid<int>(rows, columns), Grid<int>(rows, columns),
                     Grid<char>(rows, columns)};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int seen = row / block.rows, k = column / block.columns;
            const int j = lower ? seen : kept.ny() - 1 - seen;
            shape.top(row, column) = kept(j, k).end * layers;
            shape.first(row, column) = kept(j, k).first * layers;
            shape.rim(row, column) = !kept(j, k).none() && design.layers.front()(j, k).none();
        }
    return shape;
}

}  // namespace snug

#include "snug/search/shock_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "snug/check/pad_contacts.h"
#include "snug/foam/foams.h"

namespace snug {
namespace {

// That the surface would take, of which one seen from a side has up to half; more where blocks are small.
constexpr double kSquares = 1500, kMostSquares = 6000;
constexpr double kPointsAlong = 2;  // of a square
/// Squares at the rim count a little more foam than the object has below it: from the height itself what it
/// falls onto would bottom too late.
constexpr double kHigher = 1.15;

/// The ends of the object in one square of a lattice across an axis.
struct Cell {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    [[nodiscard]] bool any() const { return low <= high; }
};

/// Back from where it lies: by the transpose.
Vec3d turned_back(const Rotation& rotation, Vec3d v) {
    return rotation.row[0] * v.x + rotation.row[1] * v.y + rotation.row[2] * v.z;
}

std::vector<StressCurve> both_ends(const std::vector<StressCurve>& curves) {
    if (curves.size() <= 2) return curves;
    return {curves.front(), curves.back()};
}

/// Squares across an axis over the box of an object: several that tile each column of blocks, or each of
/// several columns where those are small.
class Lattice {
  public:
    Lattice(const Box3d& box, const DesignSpace& space, int axis, double square_mm)
        : axis_(axis), u_(box, space, (axis + 1) % 3, square_mm), v_(box, space, (axis + 2) % 3, square_mm) {
        cells_.resize(static_cast<std::size_t>(u_.count * v_.count));
    }

    void add(Vec3d p) {
        Cell& cell = cells_[static_cast<std::size_t>(u_.place(p) * v_.count + v_.place(p))];
        cell.low = std::min(cell.low, p[axis_]);
        cell.high = std::max(cell.high, p[axis_]);
    }

    /// A line of each square that the object meets.
    [[nodiscard]] std::vector<ItemLine> lines() const {
        std::vector<ItemLine> lines;
        for (int row = 0; row < u_.count; ++row)
            for (int column = 0; column < v_.count; ++column) {
                const Cell& cell = cells_[static_cast<std::size_t>(row * v_.count + column)];
                if (!cell.any()) continue;
                ItemLine line{row, column};
                line.low = cell.low;
                line.high = cell.high;
                line.u = u_.middle(row);
                line.v = v_.middle(column);
                line.area_mm2 = u_.length(row) * v_.length(column) * covered(row, column);
                line.b = u_.block(row);
                line.c = v_.block(column);
                lines.push_back(line);
            }
        return lines;
    }

  private:
    /// The squares along one axis.
    struct Side {
        Side(const Box3d& box, const DesignSpace& space, int own_axis, double square_mm)
            : axis(own_axis), low(box.min[own_axis]), high(box.max[own_axis]) {
            const double block_mm = space.block_mm[axis];
            if (block_mm < square_mm)
                blocks_each = static_cast<int>(std::ceil(square_mm / block_mm - 1e-9));
            else
                a_block = static_cast<int>(std::ceil(block_mm / square_mm - 1e-9));
            pitch = block_mm * blocks_each / a_block;
            first = static_cast<int>(std::floor((low - space.face(axis, 0)) / pitch));
            begin = space.face(axis, 0) + first * pitch;
            count = std::max(1, static_cast<int>(std::ceil((high - begin) / pitch)));
            blocks = space.blocks[axis];
        }
        [[nodiscard]] int place(Vec3d p) const {
            return std::clamp(static_cast<int>((p[axis] - begin) / pitch), 0, count - 1);
        }
        [[nodiscard]] std::int16_t block(int at) const {
            const int block = (first + at) * blocks_each / a_block + blocks_each / 2;
            return static_cast<std::int16_t>(std::clamp(block, 0, blocks - 1));
        }
        /// Of a square, within the box.
        [[nodiscard]] double from(int at) const { return std::max(low, begin + at * pitch); }
        [[nodiscard]] double to(int at) const { return std::min(high, begin + (at + 1) * pitch); }
        [[nodiscard]] double middle(int at) const { return (from(at) + to(at)) / 2; }
        [[nodiscard]] double length(int at) const { return std::max(0.0, to(at) - from(at)); }

        int axis, a_block = 1, blocks_each = 1;  ///< squares of a block, or blocks of a square
        int first = 0, count = 1, blocks = 1;
        double low, high, pitch = 1, begin = 0;
    };

    [[nodiscard]] bool bare(int row, int column) const {
        if (row < 0 || column < 0 || row >= u_.count || column >= v_.count) return false;
        return !cells_[static_cast<std::size_t>(row * v_.count + column)].any();
    }
    /// The share of a square that the object covers, on average: less at its rim, but for the rim of its box.
    [[nodiscard]] double covered(int row, int column) const {
        const int sides =
            bare(row - 1, column) + bare(row + 1, column) + bare(row, column - 1) + bare(row, column + 1);
        return sides == 0 ? 1 : sides < 3 ? 0.5 : 0.25;
    }

    int axis_;
    Side u_, v_;
    std::vector<Cell> cells_;
};

}  // namespace

ShockEstimate::ShockEstimate(const Mesh& mesh, const PackedShocks& start, const AxisLines& lines)
    : packing_(start.packing),
      known_(start.protection),
      curves_(*start.protection.foam),
      start_(start.packing.items.front().placement),
      spread_(lines.spreads.front()) {
    const double area = surface_area(mesh);
    const Vec3d block = packing_.space.block_mm;
    square_mm_ = std::clamp(std::min({block.x, block.y, block.z}), std::sqrt(area / kMostSquares),
                            std::sqrt(area / kSquares));
    points_ = surface_points(mesh, square_mm_ / kPointsAlong);
    curves_.possible = both_ends(curves_.possible);
    *known_.drop_mm *= kHigher;
    centre_ = turned_back(start_.rotation, known_.items.front().centre - start_.shift);
    packing_.items.front().zones.clear();
    packing_.pockets.clear();
    packing_.notches.clear();
    packing_.pads = {};  // they are of the place that it begins at
    packing_.relief.reset();
    packing_.findings.clear();
    known_.zones.clear();
    for (FaceShock& face : known_.items.front().faces) face.force.clear();
}

AxisLines ShockEstimate::lines(const std::vector<Vec3d>& placed, const Placement& placement, int axis) const {
    Lattice lattice(placement.bounds, packing_.space, axis, square_mm_);
    for (const Vec3d& p : placed) lattice.add(p);
    AxisLines all;
    all.axis = axis;
    all.lines = lattice.lines();
    all.spreads = {spread(placement)};
    // In the order in which RunsAlong visits them.
    std::sort(all.lines.begin(), all.lines.end(), [axis](const ItemLine& p, const ItemLine& q) {
        const auto key = [axis](const ItemLine& line) {
            return std::tuple(axis == 2 ? line.c : line.b, axis == 2 ? line.b : line.c, line.row,
                              line.column);
        };
        return key(p) < key(q);
    });
    return all;
}

/// That of the start, turned with the object.
MassSpread ShockEstimate::spread(const Placement& placement) const {
    const auto along = [&](Vec3d direction) {
        return spread_.along(start_.rotation(turned_back(placement.rotation, direction)));
    };
    const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    MassSpread turned{spread_.mm3, {}, along(x), along(y), along(z)};
    turned.centre =
        placement.rotation(turned_back(start_.rotation, spread_.centre - start_.shift)) + placement.shift;
    turned.xy = (along(x + y) - turned.xx - turned.yy) / 2;
    turned.yz = (along(y + z) - turned.yy - turned.zz) / 2;
    turned.zx = (along(z + x) - turned.zz - turned.xx) / 2;
    return turned;
}

std::array<double, 6> ShockEstimate::operator()(const ExactCut& exact) const {
    Packing packing = packing_;
    packing.items.front().placement = exact.placement;
    packing.layers = {exact.blocks};
    packing.foams = split(packing.layers, packing.foams->parting, packing.available);
    Protection all = known_;
    all.items.front().centre = exact.placement.rotation(centre_) + exact.placement.shift;
    std::vector<Vec3d> placed;
    for (std::size_t i = 0; i < points_.size(); ++i)
        placed.push_back(exact.placement(Vec3f{points_.x[i], points_.y[i], points_.z[i]}));
    for (int axis = 0; axis < 3; ++axis)
        add_face_shocks(pad_contacts(lines(placed, exact.placement, axis), packing, {}), packing, curves_,
                        all, FaceDetail::shock);
    return all.margins();
}

}  // namespace snug

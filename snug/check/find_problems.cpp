#include "snug/check/find_problems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "snug/base/text.h"
#include "snug/check/part_cut.h"
#include "snug/depth/cells.h"
#include "snug/mesh/cap.h"

namespace snug {
namespace {

constexpr double kLeastGoodWall = 25;  // mm; thinner pads do not follow cushion curves
constexpr double kSpeckShare = 0.02;   // of the object's diagonal
constexpr std::size_t kPartsNamed = 5;
// Corners often lie on blocks' faces, where alone they cut nothing. Points somewhere within a triangle, as
// shares of two of its sides, lie on faces only where it does.
constexpr std::array<std::array<double, 2>, 4> kAnywhere{
    {{0.618, 0.2361}, {0.2361, 0.1459}, {0.1459, 0.618}, {0.3819, 0.3823}}};

Vec3d column_centre(const DesignSpace& space, int j, int k, CutRun run) {
    return {(space.face(0, run.first) + space.face(0, run.end)) / 2,
            (space.face(1, j) + space.face(1, j + 1)) / 2, (space.face(2, k) + space.face(2, k + 1)) / 2};
}

double diagonal(const Box3d& box) {
    return std::sqrt(dot(box.size(), box.size()));
}

/// Whether a point alone cuts a block: it lies in a grown cell and not in a slot between two shrunk blocks.
class PointCut {
  public:
    PointCut(const DesignSpace& space, Reach reach)
        : layers_(space, 0, reach), rows_(space, 1, reach), columns_(space, 2, reach) {}

    bool operator()(Vec3d p) const {
        return holds(layers_, p.x) && holds(rows_, p.y) && holds(columns_, p.z);
    }

  private:
    static bool holds(const GrownCells& cells, double value) {
        const CellRange range = cells.holding(value);
        return range.first <= range.last;
    }
    GrownCells layers_, rows_, columns_;
};

/// The triangles of the parts that are not marked, part by part.
class TrianglesOfParts {
  public:
    TrianglesOfParts(const MeshMeasure& measure, const std::vector<bool>& marked)
        : begin_(marked.size() + 1) {
        for (const std::uint32_t part : measure.part_of_triangle)
            if (!marked[part]) ++begin_[part + 1];
        for (std::size_t part = 1; part < begin_.size(); ++part) begin_[part] += begin_[part - 1];
        triangles_.resize(begin_.back());
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::uint32_t t = 0; t < measure.part_of_triangle.size(); ++t)
            if (const std::uint32_t part = measure.part_of_triangle[t]; !marked[part])
                triangles_[next[part]++] = t;
    }

    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t part) const {
        return {triangles_.data() + begin_[part], triangles_.data() + begin_[part + 1]};
    }

  private:
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> triangles_;
};

/// A part of a mesh by itself, with what closes its own holes.
Mesh with_own_caps(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    Mesh part;
    part.origin = mesh.origin;
    for (const std::uint32_t t : triangles) {
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        for (const std::uint32_t v : mesh.triangles[t]) part.vertices.push_back(mesh.vertices[v]);
        part.triangles.push_back({first, first + 1, first + 2});
    }
    const MeshMeasure own = measure(part);
    return capped(part, own.holes);
}

struct UncutParts {
    std::vector<std::uint32_t> parts;  ///< the largest first
    std::size_t unknown = 0;           ///< parts that would have taken too long
};

/// Of the parts that are not marked. The small ones are looked at first, so that a few large ones do not use
/// up the work that is allowed.
UncutParts uncut_parts(const Mesh& mesh, const TrianglesOfParts& triangles, const std::vector<bool>& marked,
                       bool capped, PartCut alone) {
    UncutParts found;
    for (auto part = static_cast<std::uint32_t>(marked.size()); part-- > 0;) {
        if (marked[part]) continue;
        std::optional<bool> cuts = alone.cuts(mesh, triangles[part]);
        if (cuts == false && capped) cuts = alone.cuts(with_own_caps(mesh, triangles[part]));
        if (!cuts)
            ++found.unknown;
        else if (!*cuts)
            found.parts.push_back(part);
    }
    std::reverse(found.parts.begin(), found.parts.end());
    return found;
}

/// A column that leaves least foam on a side, to show where it is.
std::optional<Vec3d> thinnest_place(std::span<const BlockMap> layers, const DesignSpace& space, Side side) {
    std::optional<Vec3d> place;
    int thinnest = 0;
    for (const BlockMap& blocks : layers)
        for (int j = 0; j < blocks.ny(); ++j)
            for (int k = 0; k < blocks.nz(); ++k) {
                const CutRun run = blocks(j, k);
                if (run.none()) continue;
                const int left[6] = {run.first, space.blocks.x - run.end, j, space.blocks.y - 1 - j,
                                     k,         space.blocks.z - 1 - k};
                if (place && left[side] >= thinnest) continue;
                thinnest = left[side];
                place = column_centre(space, j, k, run);
            }
    return place;
}

struct SideWords {
    const char* place;
    const char* none;
    const char* thin;
};
constexpr SideWords kSides[6] = {
    {"side.floor", "no_floor", "thin_floor"},   {"side.roof", "no_roof", "thin_roof"},
    {"side.back", "touches_case", "thin_wall"}, {"side.front", "touches_case", "thin_wall"},
    {"side.left", "touches_case", "thin_wall"}, {"side.right", "touches_case", "thin_wall"}};

}  // namespace

void find_open_holes(const Mesh& hole_spans, const Placement& placement, const DesignSpace& space,
                     Reach reach, const DepthMap& depths, const BlockMap& blocks,
                     std::vector<Finding>& findings) {
    if (hole_spans.triangles.empty()) return;
    const BlockMap closed = block_map(depth_map(hole_spans, placement, space, reach, depths), space, reach);
    long long columns = 0, inside = 0;
    int most = 0;
    Vec3d where;
    for (int j = 0; j < blocks.ny(); ++j) {
        for (int k = 0; k < blocks.nz(); ++k) {
            const CutRun whole = closed(j, k);
            const int grown = whole.blocks() - blocks(j, k).blocks();
            if (grown <= 0) continue;
            ++columns;
            inside += grown;
            if (grown <= most) continue;
            most = grown;
            where = column_centre(space, j, k, whole);
        }
    }
    if (columns == 0) return;
    const double cm3 = static_cast<double>(inside) * space.block_volume() * 1e-3;
    findings.push_back(
        {Severity::danger,
         say("open", {{"blocks", inside}, {"cm3", number(cm3, cm3 < 10 ? 1 : 0)}, {"columns", columns}}),
         where});
}

void find_uncut_parts(const Mesh& mesh, const MeshMeasure& measure, bool capped, const Placement& placement,
                      const DesignSpace& space, Reach reach, const BlockMap& blocks,
                      std::vector<Finding>& findings) {
    if (blocks.size() == 0) return;
    const PointCut cuts(space, reach);
    const auto cuts_at_its_points = [&](const Triangle& t) {
        const Vec3d a = placement(mesh.vertices[t[0]]), b = placement(mesh.vertices[t[1]]),
                    c = placement(mesh.vertices[t[2]]);
        if (cuts(a) || cuts(b) || cuts(c)) return true;
        return std::any_of(kAnywhere.begin(), kAnywhere.end(), [&](const std::array<double, 2>& at) {
            return cuts(a + (b - a) * at[0] + (c - a) * at[1]);
        });
    };
    std::vector<bool> cut(measure.parts.size());
    std::size_t uncut = cut.size();
    for (std::size_t t = 0; t < measure.part_of_triangle.size() && uncut > 0; ++t) {
        const std::uint32_t part = measure.part_of_triangle[t];
        if (cut[part]) continue;
        if (!cuts_at_its_points(mesh.triangles[t])) continue;
        cut[part] = true;
        --uncut;
    }
    if (uncut == 0) return;
    const UncutParts found =
        uncut_parts(mesh, TrianglesOfParts(measure, cut), cut, capped, PartCut(placement, space, reach));
    for (std::size_t i = 0; i < std::min(found.parts.size(), kPartsNamed); ++i) {
        const MeshPart& part = measure.parts[found.parts[i]];
        findings.push_back({Severity::danger, say("uncut_part", {{"size", dimensions(part.bounds.size())}}),
                            placement(mesh.vertices[mesh.triangles[part.first_triangle][0]])});
    }
    if (found.unknown > 0)
        findings.push_back({Severity::warning, say("parts_not_checked", {{"parts", found.unknown}})});
}

void find_thin_walls(const FitReport& fit, std::span<const BlockMap> layers, const DesignSpace& space,
                     const Walls& wanted_mm, bool cushion, const SpaceChoice& choice,
                     std::vector<Finding>& findings) {
    if (fit.cut_blocks == 0) return;
    const double least_good = cushion ? kLeastGoodWall : 0;
    Walls least = wanted_mm;
    for (double& mm : least) mm = std::max(mm, least_good);
    const Message advice = wall_advice(fit.wall_mm, least, space, choice);
    for (int i = 0; i < 6; ++i) {
        const auto side = static_cast<Side>(i);
        if (fit.open && side == kRoof) continue;
        const double wall = fit.wall_mm[static_cast<std::size_t>(i)];
        const double wanted = wanted_mm[static_cast<std::size_t>(i)];
        if (wall >= std::max(least_good, wanted)) continue;
        const SideWords& words = kSides[i];
        const auto find = [&](Severity severity, Message message) {
            findings.push_back({severity, std::move(message), thinnest_place(layers, space, side)});
        };
        const Message place = say(words.place);
        if (wall <= 0)
            find(Severity::danger, say(words.none, {{"side", place}, {"advice", advice}}));
        else if (wall < least_good)
            find(Severity::warning,
                 say(words.thin, {{"side", place}, {"mm", number(wall, 1)}, {"advice", advice}}));
        else
            find(Severity::warning, say("wall_below_wanted", {{"side", place},
                                                              {"mm", number(wall, 1)},
                                                              {"wanted_mm", number(wanted, 1)},
                                                              {"advice", advice}}));
    }
}

void find_pieces(const FitReport& fit, const SpaceChoice& choice, std::vector<Finding>& findings) {
    const bool fixed = choice.is_case();
    const auto look = [&](Piece piece, const char* none, const char* several) {
        const int parts = fit.pieces[static_cast<std::size_t>(piece.index)].parts;
        std::vector<Value> values;
        if (piece.middle()) values.push_back({"number", std::to_string(piece.index)});
        if (parts == 0) {
            values.push_back({"instead", fixed ? say("pieces.higher_case") : say("pieces.more_blocks")});
            findings.push_back({Severity::danger, say(none, std::move(values))});
        } else if (parts > 1) {
            values.push_back({"pieces", std::to_string(parts)});
            values.push_back(
                {"instead", fixed ? say("pieces.take_higher_case") : say("pieces.more_blocks_up")});
            findings.push_back({Severity::warning, say(several, std::move(values))});
        }
    };
    const int count = static_cast<int>(fit.pieces.size());
    look({0, count}, "no_lower", "lower_pieces");
    for (int i = 1; i + 1 < count; ++i) look({i, count}, "no_middle", "middle_pieces");
    if (!fit.open) look({count - 1, count}, "no_upper", "upper_pieces");
}

void find_parts(const MeshMeasure& measure, const Placement& placement, std::vector<Finding>& findings) {
    const auto& parts = measure.parts;
    if (parts.size() < 2) return;
    const double whole = diagonal(measure.bounds);
    const auto apart = [](const Box3d& a, const Box3d& b) {
        return a.min.x > b.max.x || b.min.x > a.max.x || a.min.y > b.max.y || b.min.y > a.max.y ||
               a.min.z > b.max.z || b.min.z > a.max.z;
    };
    Box3d large;
    for (const MeshPart& part : parts)
        if (diagonal(part.bounds) >= kSpeckShare * whole) large.include(part.bounds);
    std::size_t specks = 0;
    std::optional<Vec3d> where;
    for (const MeshPart& part : parts) {
        if (diagonal(part.bounds) >= kSpeckShare * whole || !apart(part.bounds, large)) continue;
        ++specks;
        if (!where) where = placement(vec_cast<float>(part.bounds.centre()));
    }
    std::vector<Message> sizes;
    for (std::size_t i = 0; i < std::min(parts.size(), kPartsNamed); ++i)
        sizes.push_back(as_it_is(dimensions(parts[i].bounds.size())));
    if (parts.size() > kPartsNamed) sizes.push_back(as_it_is("..."));
    if (specks > 0)
        findings.push_back({Severity::warning,
                            say("specks", {{"parts", parts.size()}, {"sizes", sizes}, {"specks", specks}}),
                            where});
    else
        findings.push_back({Severity::note, say("parts", {{"parts", parts.size()}, {"sizes", sizes}})});
}

}  // namespace snug

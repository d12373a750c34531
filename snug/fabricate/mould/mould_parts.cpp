#include "snug/fabricate/mould/mould_parts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "snug/base/rotation.h"
#include "snug/base/text.h"
#include "snug/fabricate/mould/draft_slabs.h"
#include "snug/fabricate/mould/slab_solid.h"
#include "snug/fabricate/printing/print_joints.h"
#include "snug/fabricate/printing/print_things.h"
#include "snug/polygon/lattice.h"

namespace snug {
namespace {

constexpr double kCubicStep = 1.0 / kStepsPerMm / kStepsPerMm / kStepsPerMm;

/// Lines `first` to `last` in steps from line `origin`. Every line is rounded by itself, so parts meet.
std::vector<int> stepped(const std::vector<double>& lines, int first, int last, int origin) {
    const auto at = [&](int line) { return in_steps(lines[static_cast<std::size_t>(line)]); };
    std::vector<int> steps;
    for (int line = first; line <= last; ++line) steps.push_back(static_cast<int>(at(line) - at(origin)));
    return steps;
}

/// A piece between cuts along y and z, with its slabs in each piece of levels.
struct Tile {
    Vec3i first, end;  ///< lines; of levels from the first to the last
    std::vector<int> levels, y, z;
    PlanBox box;
    std::vector<std::vector<DraftSlab>> slabs;    ///< for each piece of levels, from below
    std::vector<std::vector<PlanRegion>> pieces;  ///< the parts at their floors
};

class MouldMaker {
  public:
    MouldMaker(const MouldForm& form, double draft_deg, const PrintOptions& print)
        : form_(form), print_(print), lean_(sine_cosine_degrees(draft_deg)) {}

    Result<MouldedHalf> make() {
        if (auto done = find_cuts(); !done) return tl::unexpected(done.error());
        draft_ = {lean_.sine / lean_.cosine, static_cast<int>(in_steps(form_.mm(0, form_.pour_level)))};
        add_tiles();
        const PrintLayout layout =
            print_layout(form_.heights, cuts_,
                         [&](int tile, const Grid<std::uint16_t>& piece) { return partition(tile, piece); });
        if (auto few = check_part_count(layout, print_.bed_mm); !few) return tl::unexpected(few.error());
        Joints joints;
        if (print_.dowels) joints = place_joints(layout, form_.lines, print_);
        half_.bores = static_cast<int>(joints.bores.size());
        half_.without_joint = joints.without;
        std::vector<int> piece(layout.part_at.size(), 0);
        for (std::size_t part = 0; part < layout.parts.size(); ++part) {
            const int tile = layout.parts[part].tile;
            add_part(tile, piece[static_cast<std::size_t>(tile)]++, static_cast<int>(part), joints.bores);
        }
        find_pour(joints.bores.size());
        for (const Tile& tile : tiles_) find_lost_blocks(tile);
        find_upright_faces();
        return std::move(half_);
    }

  private:
    Result<void> find_cuts() {
        const auto possible = cut_lines(form_);
        BlockLines lines;
        Vec3d longest;
        for (int axis = 0; axis < 3; ++axis) {
            const auto& numbers = possible[static_cast<std::size_t>(axis)];
            auto& places = lines[static_cast<std::size_t>(axis)];
            for (const int line : numbers) places.push_back(form_.mm(axis, line));
            for (std::size_t i = 0; i + 1 < places.size(); ++i)
                longest[axis] = std::max(longest[axis], places[i + 1] - places[i]);
        }
        if (!holds_block(print_.bed_mm, longest))
            return fail(ErrorKind::usage,
                        say("mould.small_bed", {{"bed", dimensions(print_.bed_mm)},
                                                {"needed", dimensions({longest.z, longest.y, longest.x})}}));
        cuts_ = print_cuts(lines, print_.bed_mm);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int& line : cuts_.lines[axis]) line = possible[axis][static_cast<std::size_t>(line)];
        return check_part_count(cuts_, print_.bed_mm);
    }

    [[nodiscard]] int cut(int axis, int i) const {
        return cuts_.lines[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
    }

    void add_tiles() {
        const int levels = cuts_.lines[0].back();
        for (int j = 0; j < cuts_.pieces(1); ++j)
            for (int k = 0; k < cuts_.pieces(2); ++k) {
                Tile tile;
                tile.first = {0, cut(1, j), cut(2, k)};
                tile.end = {levels, cut(1, j + 1), cut(2, k + 1)};
                tile.levels = stepped(form_.lines[0], 0, levels, 0);
                tile.y = stepped(form_.lines[1], tile.first.y, tile.end.y, tile.first.y);
                tile.z = stepped(form_.lines[2], tile.first.z, tile.end.z, tile.first.z);
                const Grid<std::uint16_t> heights = piece_of(form_.heights, tile.first, tile.end);
                const SteppedField field{heights, tile.levels, tile.y, tile.z};
                tile.box = field.box();
                tile.slabs.resize(static_cast<std::size_t>(cuts_.pieces(0)));
                tile.pieces.resize(tile.slabs.size());
                PlanRegion above;
                for (int level = cuts_.pieces(0) - 1; level >= 0; --level) {
                    auto& slabs = tile.slabs[static_cast<std::size_t>(level)];
                    slabs = draft_slabs(field, cut(0, level), cut(0, level + 1), draft_, above);
                    if (slabs.empty()) continue;
                    above = bottom_of(slabs.back(), tile.box);
                    tile.pieces[static_cast<std::size_t>(level)] = connected_components(above);
                }
                tiles_.push_back(std::move(tile));
            }
    }

    [[nodiscard]] const Tile& tile_of(int number) const {
        return tiles_[static_cast<std::size_t>(number) % tiles_.size()];
    }
    [[nodiscard]] std::size_t level_of(int number) const {
        return static_cast<std::size_t>(number) / tiles_.size();
    }

    /// Columns belong to the part that stands around their middle: faces that lean may have joined some.
    [[nodiscard]] Grid<int> partition(int number, const Grid<std::uint16_t>& piece) const {
        const Tile& tile = tile_of(number);
        const auto& parts = tile.pieces[level_of(number)];
        Grid<int> part_at(piece.ny(), piece.nz(), -1);
        for (int j = 0; j < piece.ny(); ++j)
            for (int k = 0; k < piece.nz(); ++k) {
                if (piece(j, k) == 0) continue;
                const auto part = std::find_if(parts.begin(), parts.end(), [&](const PlanRegion& region) {
                    return contains(region, {half_way(tile.y, j), half_way(tile.z, k)});
                });
                part_at(j, k) = static_cast<int>(part - parts.begin());
            }
        return part_at;
    }

    [[nodiscard]] static int half_way(const std::vector<int>& lines, int i) {
        const auto line = static_cast<std::size_t>(i);
        return lines[line] + (lines[line + 1] - lines[line]) / 2;
    }

    void add_part(int number, int piece, int part, const std::vector<Bore>& bores) {
        const Tile& tile = tile_of(number);
        const std::size_t level = level_of(number);
        std::vector<DraftSlab> own = tile.slabs[level];
        if (tile.pieces[level].size() > 1) {
            for (DraftSlab& slab : own)
                slab.region = intersection(slab.region, tile.pieces[level][static_cast<std::size_t>(piece)]);
            own.erase(std::remove_if(own.begin(), own.end(),
                                     [](const DraftSlab& slab) { return slab.region.empty(); }),
                      own.end());
        }
        std::vector<SlabBore> own_bores;
        for (const Bore& bore : bores) {
            if (bore.before == part) own_bores.push_back(own_bore(bore, tile, false));
            if (bore.after == part) own_bores.push_back(own_bore(bore, tile, true));
        }
        place(slab_solid(own, tile.box, own_bores), tile);
    }

    [[nodiscard]] SlabBore own_bore(const Bore& bore, const Tile& tile, bool after) const {
        Vec3d from;
        for (int axis = 0; axis < 3; ++axis) from[axis] = form_.mm(axis, tile.first[axis]);
        const PlanPoint side = after ? tile.box.least : tile.box.greatest;
        const int plane = bore.axis == 0   ? tile.levels[static_cast<std::size_t>(bore.plane)]
                          : bore.axis == 1 ? side.y
                                           : side.z;
        return slab_bore(bore, after, from, plane, print_);
    }

    /// Turns a part as it is printed, and tells where it stands in the assembled mould.
    void place(const StepSolid& solid, const Tile& tile) {
        const PrintPose printed = form_.pose(cuts_.turned);
        half_.plastic_mm3 += volume_of(solid) * kCubicStep;
        Vec3i least = solid.points.front(), greatest = least;
        for (const Vec3i p : solid.points)
            for (int axis = 0; axis < 3; ++axis) {
                least[axis] = std::min(least[axis], p[axis]);
                greatest[axis] = std::max(greatest[axis], p[axis]);
            }
        const Vec3i a = on_bed(least, printed), b = on_bed(greatest, printed);
        const Vec3i corner{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
        MouldPart part;
        part.turned = cuts_.turned;
        for (const Vec3i p : solid.points)
            part.solid.vertices.push_back(vec_cast<float>(on_bed(p, printed) - corner) *
                                          (1.0f / kStepsPerMm));
        part.solid.triangles = solid.triangles;
        if (printed.lid)
            for (Triangle& t : part.solid.triangles) std::swap(t[1], t[2]);
        const Vec3d size = vec_cast<double>(greatest - least) * (1.0 / kStepsPerMm);
        const Vec3d first = vec_cast<double>(least) * (1.0 / kStepsPerMm) +
                            Vec3d{0, form_.mm(1, tile.first.y), form_.mm(2, tile.first.z)};
        part.size_mm = {size.z, size.y, size.x};
        part.at_mm = {first.z, printed.lid ? first.y : form_.size().y - first.y - size.y, first.x};
        half_.parts.push_back(std::move(part));
    }

    /// All below the pour level that is no plastic.
    void find_pour(std::size_t bores) {
        double rim = 0;
        for (int j = 0; j < form_.heights.ny(); ++j)
            for (int k = 0; k < form_.heights.nz(); ++k)
                if (form_.heights(j, k) > form_.pour_level)
                    rim += (form_.mm(1, j + 1) - form_.mm(1, j)) * (form_.mm(2, k + 1) - form_.mm(2, k));
        rim *= form_.lines[0].back() - form_.mm(0, form_.pour_level);
        const Vec3d size = form_.size();
        const double bored = 2 * static_cast<double>(bores) * bore_volume_mm3(print_);
        half_.pour_mm3 = size.y * size.z * form_.mm(0, form_.pour_level) - (half_.plastic_mm3 + bored - rim);
    }

    /// At a height where faces have moved by so much at most, foam farther than that from what stays of it
    /// was too narrow and is gone.
    void find_lost_blocks(const Tile& tile) {
        for (const auto& slabs : tile.slabs)
            for (const DraftSlab& slab : slabs)
                for (int level = 1; level < form_.pour_level; ++level) {
                    const int height = half_way(tile.levels, level);
                    if (height < slab.bottom || height >= slab.top) continue;
                    const std::int64_t moved = draft_.moved_at(height);
                    const PlanRegion core =
                        dilated(slab.region, static_cast<int>(moved - draft_.moved_at(slab.top)));
                    count_lost(tile, dilated(difference(region_of(tile.box), core), static_cast<int>(moved)),
                               level);
                }
    }

    void count_lost(const Tile& tile, const PlanRegion& near_foam, int level) {
        for (int j = tile.first.y; j < tile.end.y; ++j) {
            const auto& spans = near_foam.spans_behind(half_way(tile.y, j - tile.first.y));
            auto span = spans.begin();
            for (int k = tile.first.z; k < tile.end.z; ++k) {
                const int z = half_way(tile.z, k - tile.first.z);
                while (span != spans.end() && span->end <= z) ++span;
                const bool near = span != spans.end() && span->begin <= z;
                if (form_.heights(j, k) <= level && !near) ++half_.lost_blocks;
            }
        }
    }

    void find_upright_faces() {
        for (int axis = 1; axis <= 2; ++axis)
            for (int piece = 1; piece < cuts_.pieces(axis); ++piece)
                for (int i = form_.margin;
                     i < (axis == 1 ? form_.heights.nz() : form_.heights.ny()) - form_.margin; ++i) {
                    const int line = cut(axis, piece);
                    const bool same = axis == 1 ? form_.heights(line - 1, i) == form_.heights(line, i)
                                                : form_.heights(i, line - 1) == form_.heights(i, line);
                    if (!same) half_.upright_at_cuts = true;
                }
    }

    const MouldForm& form_;
    const PrintOptions& print_;
    SineCosine lean_;
    Draft draft_;
    PrintCuts cuts_;
    std::vector<Tile> tiles_;  ///< j slowest
    MouldedHalf half_;
};

}  // namespace

Result<MouldedHalf> mould_parts(const MouldForm& form, double draft_deg, const PrintOptions& print) {
    return MouldMaker(form, draft_deg, print).make();
}

}  // namespace snug

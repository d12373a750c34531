#include "snug/picture/gap_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/svg.h"
#include "snug/drawing/text_lines.h"
#include "snug/picture/preview_marks.h"
#include "snug/picture/preview_style.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr double kSide = 60;     // px left of the first map and right of the second
constexpr double kBetween = 60;  // px
constexpr double kMapWidth = (kPageWidth - 2 * kSide - kBetween) / 2;
constexpr double kGreatestMapHeight = 300;  // px of a map
constexpr double kHeading = 74;             // px above the maps
constexpr double kLegend = 74;              // px below them
constexpr int kMostMapCells = 120;          // along an axis
constexpr int kShades = 24;                 // of a colour
constexpr double kCellSeam = 0.4;           // px, between cells
constexpr double kMapStep = 0.1;            // px
constexpr Color kFoam{232, 235, 239};
constexpr Color kPale{255, 250, 240};
constexpr Color kSteps{214, 140, 20};
constexpr Color kUndercuts{150, 40, 130};

/// Mean depths of one half over a cell of the map, mm.
struct Cell {
    double step = 0;
    double undercut = 0;
    [[nodiscard]] double sum() const { return step + undercut; }
};

Cell cell_of(const ColumnGap& column, bool lower) {
    if (lower) return {column.lower_step, column.lower_undercut};
    return {column.upper_step, column.upper_undercut};
}

/// The map with as many columns in a cell as keep it small.
Grid<Cell> cells(const Grid<ColumnGap>& columns, bool lower, int per_y, int per_z) {
    Grid<Cell> map((columns.ny() + per_y - 1) / per_y, (columns.nz() + per_z - 1) / per_z);
    for (int j = 0; j < map.ny(); ++j)
        for (int k = 0; k < map.nz(); ++k) {
            const int j_end = std::min((j + 1) * per_y, columns.ny());
            const int k_end = std::min((k + 1) * per_z, columns.nz());
            Cell& cell = map(j, k);
            for (int jj = j * per_y; jj < j_end; ++jj)
                for (int kk = k * per_z; kk < k_end; ++kk) {
                    const Cell one = cell_of(columns(jj, kk), lower);
                    cell.step += one.step;
                    cell.undercut += one.undercut;
                }
            const double count = (j_end - j * per_y) * (k_end - k * per_z);
            cell.step /= count;
            cell.undercut /= count;
        }
    return map;
}

Color color_of(const Cell& cell, double deepest) {
    if (cell.sum() < 1e-3 || deepest <= 0) return kFoam;
    const double share = std::ceil(cell.sum() / deepest * kShades) / kShades;
    const double undercut = std::floor(cell.undercut / cell.sum() * 6 + 0.5) / 6;
    return mixed(kPale, mixed(kSteps, kUndercuts, undercut), 0.12 + 0.88 * std::min(share, 1.0));
}

/// One half's map.
class HalfMap {
  public:
    HalfMap(const GapReport& gap, Piece piece, const DesignSpace& space, bool lower, Vec2d at, double scale,
            Language language)
        : half_(lower ? gap.lower : gap.upper),
          piece_(piece),
          space_(space),
          lower_(lower),
          at_(at),
          scale_(scale),
          language_(language) {
        const int per_y = (space.blocks.y + kMostMapCells - 1) / kMostMapCells;
        const int per_z = (space.blocks.z + kMostMapCells - 1) / kMostMapCells;
        cell_mm_ = {space.block_mm.z * per_z, space.block_mm.y * per_y};
        map_ = cells(gap.columns, lower, per_y, per_z);
    }

    [[nodiscard]] double deepest() const {
        double deepest = 0;
        for (const Cell& cell : map_) deepest = std::max(deepest, cell.sum());
        return deepest;
    }

    void draw_cells(Canvas& canvas, double deepest) const {
        for (int j = 0; j < map_.ny(); ++j)
            for (int k = 0; k < map_.nz();) {
                const Color color = color_of(map_(j, k), deepest);
                int end = k + 1;
                while (end < map_.nz() && color_of(map_(j, end), deepest) == color) ++end;
                const Vec2d a = corner(j, k), b = corner(j + 1, end);
                canvas.facet(color, {a, {b.x, a.y}, b, {a.x, b.y}}, kCellSeam);
                k = end;
            }
    }

    /// The frame, where the largest ball of the half is, and what is said beside it.
    void draw_marks(Canvas& canvas) const {
        const Vec2d size = Vec2d{space_.size().z, space_.size().y} * scale_;
        canvas.rectangle(at_, size, {}, kDimensionStroke);
        draw_ring(canvas);
        std::vector<Message> ring;
        if (half_.widest_mm > 0) ring.push_back(say("gap.ring", {{"mm", number(half_.widest_mm, 1)}}));
        draw_title(canvas, text(title(std::move(ring)), language_));
        canvas.text({at_.x + size.x / 2, lower_ ? at_.y - 8 : at_.y + size.y + 18}, 12,
                    anchored(kBackText, TextAnchor::middle), text(say("mark.back"), language_));
    }

  private:
    /// Up to where the next map's begins or the page ends, the last line right above the map.
    void draw_title(Canvas& canvas, const std::string& words) const {
        constexpr double kSize = 17, kLine = 22;
        const double width = lower_ ? kMapWidth + kBetween - kSide / 3 : kPageWidth - kSide / 3 - at_.x;
        // A screen's letters may be wider than those that lines_of() knows.
        const std::vector<std::string> lines = lines_of(words, 0.88 * width, kSize);
        for (std::size_t i = 0; i < lines.size(); ++i)
            canvas.text({at_.x, at_.y - 28 - kLine * static_cast<double>(lines.size() - 1 - i)}, kSize,
                        kLegendText, lines[i]);
    }
    [[nodiscard]] Message title(std::vector<Message> ring) const {
        if (piece_.middle())
            return say("gap.middle", {{"piece", marked_side(piece_, lower_ ? Half::lower : Half::lid)},
                                      {"ring", std::move(ring)}});
        return say(lower_ ? "gap.lower" : "gap.lid", {{"ring", std::move(ring)}});
    }
    /// j runs downward in the lower foam and upward in the lid.
    [[nodiscard]] Vec2d page(double y_mm, double z_mm) const {
        const double down = lower_ ? y_mm : space_.size().y - y_mm;
        return at_ + Vec2d{z_mm, down} * scale_;
    }
    [[nodiscard]] Vec2d corner(int j, int k) const {
        return page(std::min(j * cell_mm_.y, space_.size().y), std::min(k * cell_mm_.x, space_.size().z));
    }

    void draw_ring(Canvas& canvas) const {
        if (half_.widest_mm <= 0) return;
        const Vec3d half_size = space_.size() * 0.5;
        canvas.circle(page(half_.widest_at.y + half_size.y, half_.widest_at.z + half_size.z),
                      std::max(half_.widest_mm / 2 * scale_, 2.0), {kWhite, .35}, {kObjectInk, 1.6});
    }

    const HalfGap& half_;
    Piece piece_;
    const DesignSpace& space_;
    bool lower_;
    Vec2d at_;
    double scale_;
    Language language_;
    Vec2d cell_mm_;  ///< to the right, downward
    Grid<Cell> map_;
};

/// A ramp from nothing to the deepest, and what it means.
void draw_ramp(Canvas& canvas, Vec2d at, Color color, const std::string& words) {
    constexpr double kStep = 7;
    for (int i = 1; i <= kShades; i += 2)
        canvas.rectangle({at.x + kStep * (i - 1) / 2, at.y}, {kStep + 0.3, 12},
                         Fill{mixed(kPale, color, 0.12 + 0.88 * i / kShades)});
    canvas.text(at + Vec2d{kStep * kShades / 2 + 8, 11}, 14, kLegendText, words);
}

}  // namespace

double draw_gap_maps(Canvas& canvas, const GapReport& gap, const LayerPieces& pieces,
                     const DesignSpace& space, double top, Language language) {
    const Vec3d size = space.size();
    const double scale = std::min(kMapWidth / size.z, kGreatestMapHeight / size.y);
    const double left = kSide + (kMapWidth - size.z * scale) / 2;
    const HalfMap lower(gap, pieces.below, space, true, {left, top + kHeading}, scale, language);
    const HalfMap lid(gap, pieces.above, space, false, {left + kMapWidth + kBetween, top + kHeading}, scale,
                      language);
    const double deepest = std::max(lower.deepest(), pieces.covered ? lid.deepest() : 0);
    for (const HalfMap* map : {&lower, &lid}) {
        if (map == &lid && !pieces.covered) continue;
        canvas.layer(map == &lower ? "gap-lower" : "gap-lid", kMapStep);
        map->draw_cells(canvas, deepest);
    }
    canvas.layer("gap");
    lower.draw_marks(canvas);
    if (pieces.covered) lid.draw_marks(canvas);
    const Vec2d legend{kSide, top + kHeading + size.y * scale + 36};
    const Vec2d second{kPageWidth / 2 + kBetween / 2, legend.y};
    const std::string mm = number(deepest, 1);
    draw_ramp(canvas, legend, kSteps, text(say("gap.steps", {{"mm", mm}}), language));
    if (gap.undercut_mm3)
        draw_ramp(canvas, second, kUndercuts, text(say("gap.undercut", {{"mm", mm}}), language));
    else
        canvas.text(second + Vec2d{0, 11}, 14, kLegendText, text(say("gap.undercut_unknown"), language));
    return kHeading + size.y * scale + kLegend;
}

}  // namespace snug

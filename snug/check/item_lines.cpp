#include "snug/check/item_lines.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <unordered_map>

#include "snug/base/axes.h"
#include "snug/check/line_budget.h"
#include "snug/check/line_hits.h"
#include "snug/object/zone_surface.h"

namespace snug {
namespace {

constexpr LineBudget kBudget{1 << 16, 1 << 22};

/// As lines along an axis see a mesh. `lattice`: any of the space by that axis.
std::vector<SnappedVertex> snapped_along(const Mesh& mesh, const Placement& placement,
                                         const LineLattice& lattice, int axis) {
    std::vector<SnappedVertex> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const Vec3f& vertex : mesh.vertices)
        vertices.push_back(lattice.snap(with_first(placement(vertex), axis)));
    return vertices;
}

/// Sums of length, place and squares over the parts of lines that lie in a solid.
class SpreadSums {
  public:
    explicit SpreadSums(Vec3d about) : about_(about) {}

    void add(double low, double high, double u, double v, double area) {
        const double length = (high - low) * area, middle = (low + high) / 2 - about_.x;
        const double du = u - about_.y, dv = v - about_.z;
        volume_ += length;
        first_ = first_ + Vec3d{middle, du, dv} * length;
        aa_ += length * (middle * middle + (high - low) * (high - low) / 12);
        uu_ += length * du * du;
        vv_ += length * dv * dv;
        au_ += length * middle * du;
        uv_ += length * du * dv;
        va_ += length * dv * middle;
    }

    [[nodiscard]] MassSpread spread(int axis) const {
        if (!(volume_ > 0)) return {0, with_own_axes(about_, axis)};
        const Vec3d mean = first_ * (1 / volume_);
        const auto about_centre = [&](double sum, double p, double q) { return sum / volume_ - p * q; };
        // Along the axis and the two behind it, then crosswise: axis with first, first with second, second
        // with axis.
        const Vec3d squares{about_centre(aa_, mean.x, mean.x), about_centre(uu_, mean.y, mean.y),
                            about_centre(vv_, mean.z, mean.z)};
        const Vec3d products{about_centre(au_, mean.x, mean.y), about_centre(uv_, mean.y, mean.z),
                             about_centre(va_, mean.z, mean.x)};
        const Vec3d own = with_own_axes(squares, axis), cross = with_own_axes(products, axis);
        return {volume_, with_own_axes(about_ + mean, axis), own.x, own.y, own.z, cross.x, cross.y, cross.z};
    }

  private:
    Vec3d about_;  ///< near the item, so that little is lost in differences
    double volume_ = 0, aa_ = 0, uu_ = 0, vv_ = 0, au_ = 0, uv_ = 0, va_ = 0;
    Vec3d first_;
};

/// The parts of a line inside a closed surface, or all between its ends where winding does not tell.
template <class Visit>
void for_each_inside(std::span<const Crossing> line, bool closed, Visit visit) {
    if (!closed) return visit(line.front().x, line.back().x);
    int winding = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        winding += line[i].turn;
        if (winding != 0) visit(line[i].x, line[i + 1].x);
    }
}

/// The items as lines along an axis see them; that of an only one is kept.
class SnappedItems {
  public:
    SnappedItems(std::span<const Object> objects, const std::vector<Item>& items, const DesignSpace& along,
                 int axis)
        : objects_(objects), items_(items), lattice_(along), axis_(axis) {}

    [[nodiscard]] const Mesh& mesh(std::size_t item) const { return objects_[items_[item].object].mesh; }
    [[nodiscard]] std::span<const SnappedVertex> vertices(std::size_t item) {
        if (items_.size() > 1 || kept_.empty())
            kept_ = snapped_along(mesh(item), items_[item].placement, lattice_, axis_);
        return kept_;
    }
    /// Of the finest lattice that is not too much work for any of them.
    [[nodiscard]] int cell_bits(const DesignSpace& along) {
        int bits = LineLattice::kFinest + 1;
        for (std::size_t i = 0; i < items_.size(); ++i)
            bits = std::max(bits, lattice_within(kBudget, along, vertices(i), mesh(i).triangles).cell_bits());
        return bits;
    }

  private:
    std::span<const Object> objects_;
    const std::vector<Item>& items_;
    LineLattice lattice_;
    int axis_;
    std::vector<SnappedVertex> kept_;
};

/// Finds an item's line where the lattice has it.
class LinesByPlace {
  public:
    LinesByPlace(std::vector<ItemLine>& lines, const std::vector<Item>& items) {
        for (ItemLine& line : lines)
            if (!items[line.item].zones.empty()) lines_.emplace(key(line.row, line.column, line.item), &line);
    }
    [[nodiscard]] ItemLine* find(int row, int column, std::size_t item) const {
        const auto found = lines_.find(key(row, column, static_cast<std::uint32_t>(item)));
        return found == lines_.end() ? nullptr : found->second;
    }

  private:
    /// A lattice has less than 2^20 rows or columns.
    static std::uint64_t key(int row, int column, std::uint32_t item) {
        return (std::uint64_t{item} << 40U) | (static_cast<std::uint64_t>(row) << 20U) |
               static_cast<std::uint64_t>(column);
    }
    std::unordered_map<std::uint64_t, ItemLine*> lines_;
};

/// Tells the item's lines which of their ends lie in a zone.
Result<void> mark_zone(const LineLattice& lattice, const Mesh& zone, const Placement& placement, int axis,
                       std::size_t item, std::int16_t number, const LinesByPlace& lines,
                       const Progress& progress) {
    constexpr double kSame = 0.01;  // mm: pieces of triangles are rounded anew
    const auto visit = [&](const LineBand& band) {
        for (int row = band.first_row; row < band.end_row(); ++row)
            for (int column = band.first_column; column < band.end_column(); ++column) {
                const auto met = band.line(row, column);
                ItemLine* const line = met.empty() ? nullptr : lines.find(row, column, item);
                if (!line) continue;
                if (met.front().x <= line->low + kSame) line->low_zone = number;
                if (met.back().x >= line->high - kSame) line->high_zone = number;
            }
    };
    return sweep_lines(lattice, snapped_along(zone, placement, lattice, axis), zone.triangles, visit,
                       progress);
}

Result<void> mark_zones(std::span<const Object> objects, const std::vector<Item>& items,
                        const LineLattice& lattice, AxisLines& all, const Progress& progress) {
    const bool any =
        std::any_of(items.begin(), items.end(), [](const Item& item) { return !item.zones.empty(); });
    if (!any) return {};
    const LinesByPlace lines(all.lines, items);
    for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t zone = 0; zone < items[i].zones.size(); ++zone) {
            const ItemZone& each = items[i].zones[zone];
            const Object& object = objects[items[i].object];
            const Mesh stand_in = object.whole() ? Mesh() : zone_of_mesh(object, each.asked);
            const Mesh& mesh = object.whole() ? each.surface->mesh : stand_in;
            if (mesh.triangles.empty()) continue;
            if (auto done = mark_zone(lattice, mesh, items[i].placement, all.axis, i,
                                      static_cast<std::int16_t>(zone), lines, progress);
                !done)
                return done;
        }
    return {};
}

}  // namespace

Result<AxisLines> axis_lines(std::span<const Object> objects, const std::vector<Item>& items,
                             const DesignSpace& space, int axis, const Progress& progress) {
    const DesignSpace along{with_first(space.blocks, axis), with_first(space.block_mm, axis)};
    SnappedItems snapped_items(objects, items, along, axis);
    const LineLattice lattice(along, snapped_items.cell_bits(along));
    const double whole_area = along.block_mm.y * along.block_mm.z / lattice.lines_per_column();
    AxisLines all;
    all.axis = axis;
    all.rows = lattice.rows();
    all.columns = lattice.columns();
    all.cell_mm = Vec2d{lattice.mm_per_unit_y(), lattice.mm_per_unit_z()} * (1 << lattice.cell_bits());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Object& object = objects[items[i].object];
        const bool closed = object.measure.watertight || !object.whole();
        SpreadSums sums(with_first(items[i].placement.bounds.centre(), axis));
        const auto visit = [&](const LineBand& band) {
            for (int row = band.first_row; row < band.end_row(); ++row) {
                if (!band.any(row, band.first_column, band.end_column())) continue;
                for (int column = band.first_column; column < band.end_column(); ++column) {
                    const auto line = band.line(row, column);
                    if (line.empty()) continue;
                    const double u = along.face(1, 0) + lattice.u(row, column) * lattice.mm_per_unit_y();
                    const double v = along.face(2, 0) + lattice.v(row, column) * lattice.mm_per_unit_z();
                    const double area = whole_area * lattice.share(row, column);
                    all.lines.push_back({row, column, static_cast<std::uint32_t>(i),
                                         static_cast<std::int16_t>(lattice.j(row, column)),
                                         static_cast<std::int16_t>(lattice.k(row, column)), line.front().x,
                                         line.back().x, u, v, area});
                    for_each_inside(line, closed,
                                    [&](double low, double high) { sums.add(low, high, u, v, area); });
                }
            }
        };
        const auto done =
            sweep_lines(lattice, snapped_items.vertices(i), object.mesh.triangles, visit,
                        part_of(progress, static_cast<double>(i) / static_cast<double>(items.size()),
                                static_cast<double>(i + 1) / static_cast<double>(items.size())));
        if (!done) return tl::unexpected(done.error());
        all.spreads.push_back(sums.spread(axis));
    }
    if (auto done = mark_zones(objects, items, lattice, all, progress); !done)
        return tl::unexpected(done.error());
    std::sort(all.lines.begin(), all.lines.end(), [axis](const ItemLine& p, const ItemLine& q) {
        const auto key = [axis](const ItemLine& line) {
            return std::make_tuple(axis == 2 ? line.c : line.b, axis == 2 ? line.b : line.c, line.row,
                                   line.column, line.low, line.item);
        };
        return key(p) < key(q);
    });
    return all;
}

}  // namespace snug

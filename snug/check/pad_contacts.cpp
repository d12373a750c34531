#include "snug/check/pad_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "snug/check/runs_along.h"
#include "snug/polygon/convex_hull.h"
#include "snug/space/case_space.h"

namespace snug {
namespace {

constexpr double kTouching = 1e-6;  // mm

using Ends = std::pair<int, int>;  // low, high

/// Foam between two places of a line.
struct Way {
    double thickness_mm = 0, gap_mm = 0;
};

/// The line of the space that is looked at: what lies on it, by blocks.
class Line {
  public:
    Line(const Packing& packing, std::span<const BlockMap> pockets, int axis)
        : space_(packing.space),
          axis_(axis),
          foam_(grids_of(*packing.foams), space_.blocks, axis),
          available_({&packing.available}, space_.blocks, axis) {
        if (pockets.size() < 2) return;
        pockets_.reserve(pockets.size());
        for (const BlockMap& pocket : pockets)
            pockets_.emplace_back(std::vector<const Grid<Run>*>{&pocket}, space_.blocks, axis);
    }

    void go_to(int b, int c) {
        foam_.go_to(b, c);
        available_.go_to(b, c);
        for (RunsAlong& pocket : pockets_) pocket.go_to(b, c);
    }

    /// Where the case begins and ends.
    [[nodiscard]] double low() const { return face(available_.first()); }
    [[nodiscard]] double high() const { return face(available_.end()); }
    [[nodiscard]] bool any() const { return available_.first() < available_.end(); }

    [[nodiscard]] Way between(double from, double to) const {
        // Blocks that one of the ends stands in are squeezed.
        int first = block_at(from), end = block_at(to);
        if (from - face(first) > kTouching && !foam_.has(first)) ++first;
        if (to - face(end) > kTouching && foam_.has(end)) ++end;
        const double thickness = std::max(0, foam_.count(first, end)) * space_.block_mm[axis_];
        return {thickness, to - from - thickness};
    }

    /// Whether the way crosses the pocket of an item other than these.
    [[nodiscard]] bool crosses_pocket(double from, double to, Ends but) const {
        const int first = block_at(from + kTouching), end = block_at(to - kTouching) + 1;
        for (std::size_t i = 0; i < pockets_.size(); ++i) {
            const int item = static_cast<int>(i);
            if (item != but.first && item != but.second && pockets_[i].count(first, end) > 0) return true;
        }
        return false;
    }

  private:
    static std::vector<const Grid<Run>*> grids_of(const Foams& foams) {
        std::vector<const Grid<Run>*> grids;
        for (const Piece piece : foams.all()) grids.push_back(&foams.piece(piece));
        return grids;
    }
    [[nodiscard]] double face(int block) const { return space_.face(axis_, block); }
    /// The block whose lower face lies at the place or below it.
    [[nodiscard]] int block_at(double mm) const {
        const double blocks = (mm - face(0) + kTouching) / space_.block_mm[axis_];
        return static_cast<int>(std::clamp(std::floor(blocks), 0.0, 1.0 * space_.blocks[axis_]));
    }

    const DesignSpace& space_;
    int axis_;
    RunsAlong foam_, available_;
    std::vector<RunsAlong> pockets_;  ///< of each item where there are several
};

/// What the strips that fill a case add to the foam at its low and at its high side.
std::array<double, 2> filler_mm(const Packing& packing, int axis) {
    std::array<double, 2> mm{};
    if (!packing.fitted_case) return mm;
    for (const Filler& filler :
         fillers(*packing.fitted_case, packing.foams->parting.back(), packing.foams->open()))
        if (filler.side / 2 == axis) mm[static_cast<std::size_t>(filler.side % 2)] = filler.size_mm[axis];
    return mm;
}

/// How thick the pads below and above each item are in every column; nothing where there are none.
class PadThickness {
  public:
    PadThickness(const Packing& packing, int axis) {
        if (axis != 0 || packing.pads.pads.empty()) return;
        const Grid<float> none(packing.space.blocks.y, packing.space.blocks.z, 0);
        for (auto& side : mm_) side.assign(packing.items.size(), none);
        for (const FillPad& pad : packing.pads.pads)
            for (int j = pad.first_j; j < pad.end_j; ++j)
                for (int k = pad.first_k; k < pad.end_k; ++k)
                    mm_[pad.above ? 1 : 0][pad.item](j, k) = static_cast<float>(pad.thickness_mm);
    }
    [[nodiscard]] double below(std::size_t item, const ItemLine& line) const { return of(0, item, line); }
    [[nodiscard]] double above(std::size_t item, const ItemLine& line) const { return of(1, item, line); }

  private:
    [[nodiscard]] double of(std::size_t side, std::size_t item, const ItemLine& line) const {
        return mm_[side].empty() ? 0.0 : static_cast<double>(mm_[side][item](line.b, line.c));
    }
    std::array<std::vector<Grid<float>>, 2> mm_;
};

class Contacts {
  public:
    /// `one_by_one`: takes the columns in place of the sums.
    Contacts(const AxisLines& lines, const Packing& packing, std::span<const BlockMap> pockets,
             std::vector<ContactColumn>* one_by_one = nullptr)
        : packing_(packing),
          one_by_one_(one_by_one),
          line_(packing, pockets, lines.axis),
          filler_(filler_mm(packing, lines.axis)),
          pads_(packing, lines.axis),
          open_above_(lines.axis == 0 && packing.foams->open()),
          relieved_(lines.axis == 0 && packing.relief) {
        const auto& all = lines.lines;
        for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
            while (end < all.size() && all[end].row == all[i].row && all[end].column == all[i].column) ++end;
            line_.go_to(all[i].b, all[i].c);
            if (line_.any()) add_line({all.data() + i, all.data() + end});
        }
    }

    std::vector<ZonePads> take_zones() {
        std::vector<ZonePads> zones;
        for (auto& [end, columns] : zones_)
            zones.push_back({end.item, end.zone, end.high, std::move(columns)});
        return zones;
    }

    std::vector<PadContact> take() {
        std::vector<PadContact> contacts;
        for (auto& [ends, found] : found_)
            contacts.push_back({ends.first, ends.second, Pads(std::move(found.columns)), found.bare_mm,
                                found.on_stiff_base.empty()
                                    ? std::nullopt
                                    : std::optional(Pads(std::move(found.on_stiff_base)))});
        return contacts;
    }

  private:
    /// A zone at an end of a line.
    struct ZoneEnd {
        std::size_t item = 0, zone = 0;
        bool high = false;
        friend auto operator<=>(const ZoneEnd&, const ZoneEnd&) = default;
    };
    struct Found {
        std::vector<PadColumn> columns, on_stiff_base;
        double bare_mm = std::numeric_limits<double>::infinity();
    };

    void add_line(std::span<const ItemLine> items) {
        for (const ItemLine& item : items) {
            const ItemLine *below = nullptr, *above = nullptr;
            for (const ItemLine& other : items) {
                if (&other == &item) continue;
                if (other.high <= item.low + kTouching && (!below || other.high > below->high))
                    below = &other;
                if (other.low >= item.high - kTouching && (!above || other.low < above->low)) above = &other;
            }
            const int own = static_cast<int>(item.item);
            const double pad_below = pads_.below(item.item, item);
            if (below)
                add(item, {static_cast<int>(below->item), own}, below->high, item.low,
                    {0, pad_below + pads_.above(below->item, item)},
                    {zone_of(item, false), zone_of(*below, true)});
            else
                add(item, {PadContact::kCase, own}, line_.low(), item.low, {filler_[0], pad_below},
                    {zone_of(item, false), {}});
            if (!above && !open_above_)
                add(item, {own, PadContact::kCase}, item.high, line_.high(),
                    {filler_[1], pads_.above(item.item, item)}, {zone_of(item, true), {}});
        }
    }

    static std::optional<ZoneEnd> zone_of(const ItemLine& line, bool high) {
        const std::int16_t zone = high ? line.high_zone : line.low_zone;
        if (zone < 0) return {};
        return ZoneEnd{line.item, static_cast<std::size_t>(zone), high};
    }
    [[nodiscard]] const Zone& asked(const ZoneEnd& end) const {
        return packing_.items[end.item].zones[end.zone].asked;
    }

    using ZoneEnds = std::array<std::optional<ZoneEnd>, 2>;
    /// Foam beside that of the pieces: outside the space, and inside the way.
    struct More {
        double filler_mm = 0, pad_mm = 0;
    };
    void add(const ItemLine& item, Ends ends, double from, double to, More more, const ZoneEnds& zones) {
        if (line_.crosses_pocket(from, to, ends)) return;
        Way way = line_.between(from, to);
        way.thickness_mm += more.filler_mm + more.pad_mm;
        way.gap_mm -= more.pad_mm;
        Found& found = found_[ends];
        if (!(way.thickness_mm > 0)) {
            found.bare_mm = std::min(found.bare_mm, std::max(0.0, way.gap_mm));
            return;
        }
        const PadColumn column{way.thickness_mm, way.gap_mm, item.area_mm2, item.u, item.v};
        for (const auto& zone : zones)
            if (zone && asked(*zone).press_kpa) zones_[*zone].push_back(column);
        const bool kept_off = std::any_of(zones.begin(), zones.end(), [&](const auto& zone) {
            return zone && asked(*zone).keep_off_mm > 0;
        });
        if (kept_off) return;
        if (one_by_one_) {
            one_by_one_->push_back({ends.first, ends.second, item.row, item.column, from, to, column});
            return;
        }
        found.columns.push_back(column);
        if (relieved_ && ends.first == PadContact::kCase)
            found.on_stiff_base.push_back(on_stiff_base(column, item));
    }

    /// Of an island only what stands free gives way.
    [[nodiscard]] PadColumn on_stiff_base(PadColumn column, const ItemLine& line) const {
        const auto& islands = packing_.relief->islands;
        const bool stands = std::any_of(islands.begin(), islands.end(), [&](const ReliefIsland& island) {
            return island.has(line.b, line.c);
        });
        const double free =
            packing_.relief->blocks * packing_.space.block_mm.x + pads_.below(line.item, line);
        if (stands) column.thickness_mm = std::min(column.thickness_mm, free);
        return column;
    }

    const Packing& packing_;
    std::vector<ContactColumn>* one_by_one_;
    Line line_;
    std::array<double, 2> filler_;
    PadThickness pads_;
    bool open_above_;
    bool relieved_;  ///< an item stands on islands of the foam below it
    std::map<Ends, Found> found_;
    std::map<ZoneEnd, std::vector<PadColumn>> zones_;
};

}  // namespace

AxisContacts pad_contacts(const AxisLines& lines, const Packing& packing, std::span<const BlockMap> pockets) {
    Contacts contacts(lines, packing, pockets);
    AxisContacts all{lines.axis, contacts.take(), {}, lines.spreads, contacts.take_zones()};
    std::vector<std::vector<Vec2d>> points(packing.items.size());
    for (const ItemLine& line : lines.lines) points[line.item].push_back({line.u, line.v});
    for (std::vector<Vec2d>& each : points) all.outlines.push_back(convex_hull(std::move(each)));
    return all;
}

std::vector<ContactColumn> contact_columns(const AxisLines& lines, const Packing& packing,
                                           std::span<const BlockMap> pockets) {
    std::vector<ContactColumn> columns;
    const Contacts all(lines, packing, pockets, &columns);
    return columns;
}

}  // namespace snug

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

class Contacts {
  public:
    /// `one_by_one`: takes the columns in place of the sums.
    Contacts(const AxisLines& lines, const Packing& packing, std::span<const BlockMap> pockets,
             std::vector<ContactColumn>* one_by_one = nullptr)
        : packing_(packing),
          one_by_one_(one_by_one),
          line_(packing, pockets, lines.axis),
          filler_(filler_mm(packing, lines.axis)),
          open_above_(lines.axis == 0 && packing.foams->open()) {
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
            contacts.push_back({ends.first, ends.second, Pads(std::move(found.columns)), found.bare_mm});
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
        std::vector<PadColumn> columns;
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
            if (below)
                add(item, {static_cast<int>(below->item), own}, below->high, item.low, 0,
                    {zone_of(item, false), zone_of(*below, true)});
            else
                add(item, {PadContact::kCase, own}, line_.low(), item.low, filler_[0],
                    {zone_of(item, false), {}});
            if (!above && !open_above_)
                add(item, {own, PadContact::kCase}, item.high, line_.high(), filler_[1],
                    {zone_of(item, true), {}});
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
    void add(const ItemLine& item, Ends ends, double from, double to, double filler, const ZoneEnds& zones) {
        if (line_.crosses_pocket(from, to, ends)) return;
        const Way way = line_.between(from, to);
        Found& found = found_[ends];
        if (!(way.thickness_mm + filler > 0)) {
            found.bare_mm = std::min(found.bare_mm, std::max(0.0, way.gap_mm));
            return;
        }
        const PadColumn column{way.thickness_mm + filler, way.gap_mm, item.area_mm2, item.u, item.v};
        for (const auto& zone : zones)
            if (zone && asked(*zone).press_kpa) zones_[*zone].push_back(column);
        const bool kept_off = std::any_of(zones.begin(), zones.end(), [&](const auto& zone) {
            return zone && asked(*zone).keep_off_mm > 0;
        });
        if (kept_off) return;
        if (one_by_one_)
            one_by_one_->push_back({ends.first, ends.second, item.row, item.column, from, to, column});
        else
            found.columns.push_back(column);
    }

    const Packing& packing_;
    std::vector<ContactColumn>* one_by_one_;
    Line line_;
    std::array<double, 2> filler_;
    bool open_above_;
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

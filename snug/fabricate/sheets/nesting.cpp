#include "snug/fabricate/sheets/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "snug/base/text.h"
#include "snug/fabricate/sheets/close_nesting.h"
#include "snug/fabricate/sheets/offcuts.h"

namespace snug {
namespace {

constexpr long long kMostOffcutWork = 30'000'000;  // words; bounds the search among thousands of islands
constexpr double kRounding = 1e-6;                 // mm: lengths that differ by less are the same

/// The upper border of what is packed on one stock sheet, from the left to the right; y grows away from the
/// edge where packing began.
class Skyline {
  public:
    explicit Skyline(Vec2d stock_mm) : stock_(stock_mm), parts_{{0, 0, stock_mm.x}} {}

    /// The place whose far edge lies nearest, the leftmost among equals.
    [[nodiscard]] std::optional<Vec2d> room_for(Vec2d box) const {
        std::optional<Vec2d> found;
        if (box.x * box.y > stock_.x * stock_.y - taken_ + kRounding * (stock_.x + stock_.y)) return found;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const std::optional<double> y = floor_at(i, box);
            if (y && (!found || *y < found->y - kRounding)) found = Vec2d{parts_[i].x, *y};
        }
        return found;
    }

    void take(Vec2d spot, Vec2d box) {
        taken_ += box.x * box.y;
        highest_ = std::max(highest_, spot.y + box.y);
        std::vector<Part> next;
        const double end = spot.x + box.x;
        for (const Part& part : parts_) {
            if (part.x < spot.x) next.push_back({part.x, part.y, std::min(part.end, spot.x)});
            if (part.x == spot.x) next.push_back({spot.x, spot.y + box.y, end});
            const double from = std::max(part.x, end);
            if (part.end > from + kRounding) next.push_back({from, part.y, part.end});
        }
        parts_.clear();
        for (const Part& part : next) {
            if (!parts_.empty() && std::fabs(parts_.back().y - part.y) < kRounding)
                parts_.back().end = part.end;
            else
                parts_.push_back(part);
        }
    }

    [[nodiscard]] double highest() const { return highest_; }

  private:
    struct Part {
        double x, y, end;
    };

    [[nodiscard]] std::optional<double> floor_at(std::size_t first, Vec2d box) const {
        const double end = parts_[first].x + box.x;
        if (end > stock_.x + kRounding) return {};
        double y = 0;
        for (std::size_t i = first; i < parts_.size() && parts_[i].x < end - kRounding; ++i)
            y = std::max(y, parts_[i].y);
        if (y + box.y > stock_.y + kRounding) return {};
        return y;
    }

    Vec2d stock_;
    std::vector<Part> parts_;
    double taken_ = 0, highest_ = 0;
};

class Nester {
  public:
    Nester(std::span<const PieceToNest> pieces, Vec2d cell, const SheetOptions& options)
        : pieces_(pieces),
          cell_(cell),
          options_(options),
          gap_(options.spacing_mm + options.kerf_mm),
          border_(options.margin_mm + options.kerf_mm) {}

    Result<Nesting> nest(bool in_offcuts) {
        find_hosts(in_offcuts);
        std::optional<Nesting> upright = packed(options_.stock_mm);
        std::optional<Nesting> turned = packed({options_.stock_mm.y, options_.stock_mm.x});
        if (!upright && !turned) return fail(ErrorKind::usage, too_large());
        if (!upright || (turned && less_stock(*turned, *upright))) upright = std::move(turned);
        follow_hosts(*upright);
        return std::move(*upright);
    }

  private:
    static bool less_stock(const Nesting& a, const Nesting& b) {
        return a.stocks != b.stocks ? a.stocks < b.stocks : a.used_mm2 < b.used_mm2 - 1e-6;
    }

    [[nodiscard]] Vec2d size(std::size_t piece) const {
        return {pieces_[piece].mask->width * cell_.x, pieces_[piece].mask->height * cell_.y};
    }

    void find_hosts(bool in_offcuts) {
        order_.resize(pieces_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
            const Vec2d sa = size(a), sb = size(b);
            return sa.x * sa.y > sb.x * sb.y;
        });
        const int gap_columns = static_cast<int>(std::ceil(gap_ / cell_.x - 1e-9));
        const int gap_rows = static_cast<int>(std::ceil(gap_ / cell_.y - 1e-9));
        places_.assign(pieces_.size(), {});
        in_host_.assign(pieces_.size(), {});
        std::vector<std::pair<std::size_t, Offcuts>> hosts;
        long long work = 0;
        for (const std::size_t piece : order_) {
            if (in_offcuts && find_host(piece, hosts, work)) continue;
            boxes_.push_back(piece);
            if (in_offcuts && work < kMostOffcutWork)
                hosts.emplace_back(piece, Offcuts(*pieces_[piece].mask, gap_columns, gap_rows));
        }
    }

    bool find_host(std::size_t piece, std::vector<std::pair<std::size_t, Offcuts>>& hosts, long long& work) {
        for (auto& host : hosts) {
            if (work >= kMostOffcutWork) return false;
            if (pieces_[host.first].color != pieces_[piece].color) continue;
            const auto room = host.second.room_for(*pieces_[piece].mask, pieces_[piece].cells, work);
            if (!room) continue;
            host.second.take(*pieces_[piece].mask, *room);
            in_host_[piece] = *room;
            places_[piece].host = static_cast<int>(host.first);
            return true;
        }
        return false;
    }

    /// None where a piece is larger than the stock lying this way.
    [[nodiscard]] std::optional<Nesting> packed(Vec2d stock) const {
        const Vec2d area{stock.x - 2 * border_ + gap_, stock.y - 2 * border_ + gap_};
        std::array<std::vector<Skyline>, 2> of_color;
        Nesting nesting{stock, 0, places_, 0, 0};
        for (const std::size_t piece : boxes_) {
            const Vec2d box = size(piece) + Vec2d{gap_, gap_};
            if (box.x > area.x + kRounding || box.y > area.y + kRounding) return {};
            std::vector<Skyline>& stocks = of_color[static_cast<std::size_t>(pieces_[piece].color)];
            std::optional<Vec2d> spot;
            std::size_t on = 0;
            for (; on < stocks.size() && !spot; ++on) spot = stocks[on].room_for(box);
            if (spot) {
                --on;
            } else {
                stocks.emplace_back(area);
                spot = Vec2d{};
            }
            stocks[on].take(*spot, box);
            nesting.places[piece].stock = static_cast<int>(on);
            nesting.places[piece].corner = Vec2d{border_, border_} + *spot;
        }
        nesting.first_color_stocks = static_cast<int>(of_color[0].size());
        nesting.stocks = nesting.first_color_stocks + static_cast<int>(of_color[1].size());
        for (const std::size_t piece : boxes_)
            if (pieces_[piece].color == 1) nesting.places[piece].stock += nesting.first_color_stocks;
        for (const std::vector<Skyline>& stocks : of_color)
            for (const Skyline& sheet : stocks)
                nesting.used_mm2 += stock.x * (sheet.highest() - gap_ + 2 * border_);
        return nesting;
    }

    void follow_hosts(Nesting& nesting) const {
        for (const std::size_t piece : order_) {
            PiecePlace& place = nesting.places[piece];
            if (place.host < 0) continue;
            const PiecePlace& host = nesting.places[static_cast<std::size_t>(place.host)];
            place.stock = host.stock;
            place.corner = host.corner + Vec2d{in_host_[piece].x * cell_.x, in_host_[piece].y * cell_.y};
        }
    }

    [[nodiscard]] Message too_large() const {
        Vec2d most;
        std::string name;
        for (const std::size_t piece : boxes_) {
            const Vec2d mm = size(piece);
            if (most.x < mm.x || most.y < mm.y) name = pieces_[piece].name;
            most = {std::max(most.x, mm.x), std::max(most.y, mm.y)};
        }
        const auto shown = [](Vec2d mm) { return number(mm.x) + " x " + number(mm.y); };
        return say("sheets.too_large", {{"sheet", name},
                                        {"stock_mm", shown(options_.stock_mm)},
                                        {"least_mm", shown({most.x + 2 * border_, most.y + 2 * border_})}});
    }

    std::span<const PieceToNest> pieces_;
    Vec2d cell_;
    const SheetOptions& options_;
    double gap_, border_;
    std::vector<std::size_t> order_, boxes_;
    std::vector<PiecePlace> places_;
    std::vector<CellPoint> in_host_;
};

}  // namespace

Result<Nesting> nest(std::span<const PieceToNest> pieces, Vec2d cell_mm, const SheetOptions& options,
                     bool in_offcuts) {
    auto nesting = Nester(pieces, cell_mm, options).nest(in_offcuts);
    if (!nesting || !in_offcuts) return nesting;
    if (auto closer = closer_nesting(pieces, cell_mm, options, *nesting)) return std::move(*closer);
    return nesting;
}

}  // namespace snug

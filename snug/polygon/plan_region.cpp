#include "snug/polygon/plan_region.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace snug {
namespace {

using Spans = std::vector<PlanSpan>;

const Spans kNoSpans;

/// The ends of spans in order, one after another.
class Ends {
  public:
    explicit Ends(const Spans& spans) : spans_(spans) {}
    [[nodiscard]] bool done() const { return at_ == 2 * spans_.size(); }
    [[nodiscard]] int position() const {
        const PlanSpan& span = spans_[at_ / 2];
        return at_ % 2 == 0 ? span.begin : span.end;
    }
    [[nodiscard]] bool inside() const { return at_ % 2 == 1; }
    void pass(int position) {
        if (!done() && this->position() == position) ++at_;
    }

  private:
    const Spans& spans_;
    std::size_t at_ = 0;
};

template <class Rule>
Spans boolean_operation(const Spans& a, const Spans& b, Rule rule) {
    Spans result;
    Ends ends_a(a), ends_b(b);
    bool inside = false;
    int begin = 0;
    while (!ends_a.done() || !ends_b.done()) {
        const int at = ends_a.done()   ? ends_b.position()
                       : ends_b.done() ? ends_a.position()
                                       : std::min(ends_a.position(), ends_b.position());
        ends_a.pass(at);
        ends_b.pass(at);
        const bool now = rule(ends_a.inside(), ends_b.inside());
        if (now && !inside) begin = at;
        if (!now && inside) result.push_back({begin, at});
        inside = now;
    }
    return result;
}

Spans union_of(const Spans& a, const Spans& b) {
    return boolean_operation(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
}

Spans widened(const Spans& spans, int by) {
    Spans wide;
    for (const PlanSpan& span : spans) {
        if (!wide.empty() && wide.back().end >= span.begin - by)
            wide.back().end = span.end + by;
        else
            wide.push_back({span.begin - by, span.end + by});
    }
    return wide;
}

/// Where bands of either begin or end, each place once.
std::vector<int> breaks(const PlanRegion& a, const PlanRegion& b) {
    std::vector<int> lines;
    for (const PlanRegion* region : {&a, &b})
        for (const PlanBand& band : region->bands) lines.insert(lines.end(), {band.begin, band.end});
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

/// Follows a region's bands through ascending places.
class BandCursor {
  public:
    explicit BandCursor(const PlanRegion& region) : bands_(region.bands) {}
    /// Just behind `y`.
    const Spans& at(int y) {
        while (next_ < bands_.size() && bands_[next_].end <= y) ++next_;
        return next_ < bands_.size() && bands_[next_].begin <= y ? bands_[next_].spans : kNoSpans;
    }

  private:
    const std::vector<PlanBand>& bands_;
    std::size_t next_ = 0;
};

/// All spans of the bands in a window that moves on, each band united with others a few times only.
class BandWindow {
  public:
    void add(const Spans& spans) {
        added_.push_back(&spans);
        all_added_ = union_of(all_added_, spans);
    }
    void drop_first() {
        if (first_.empty()) {
            for (; !added_.empty(); added_.pop_back())
                first_.push_back(first_.empty() ? *added_.back() : union_of(*added_.back(), first_.back()));
            all_added_.clear();
        }
        first_.pop_back();
    }
    [[nodiscard]] Spans all() const {
        return first_.empty() ? all_added_ : union_of(first_.back(), all_added_);
    }

  private:
    std::vector<const Spans*> added_;
    Spans all_added_;
    std::vector<Spans>
        first_;  ///< of each of the older bands, with all between it and `added_`; the oldest last
};

template <class Rule>
PlanRegion boolean_operation(const PlanRegion& a, const PlanRegion& b, Rule rule) {
    const std::vector<int> lines = breaks(a, b);
    BandCursor cursor_a(a), cursor_b(b);
    PlanRegion result;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
        result.append(lines[i], lines[i + 1],
                      boolean_operation(cursor_a.at(lines[i]), cursor_b.at(lines[i]), rule));
    return result;
}

}  // namespace

const Spans& PlanRegion::spans_behind(int y) const {
    const auto band =
        std::upper_bound(bands.begin(), bands.end(), y, [](int at, const PlanBand& b) { return at < b.end; });
    return band != bands.end() && band->begin <= y ? band->spans : kNoSpans;
}

const Spans& PlanRegion::spans_before(int y) const {
    return spans_behind(y - 1);
}

void PlanRegion::append(int begin, int end, Spans spans) {
    if (spans.empty() || begin == end) return;
    if (!bands.empty() && bands.back().end == begin && bands.back().spans == spans)
        bands.back().end = end;
    else
        bands.push_back({begin, end, std::move(spans)});
}

PlanRegion region_of(const PlanBox& box) {
    PlanRegion region;
    region.append(box.least.y, box.greatest.y, {{box.least.z, box.greatest.z}});
    return region;
}

PlanRegion union_of(const PlanRegion& a, const PlanRegion& b) {
    return boolean_operation(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
}

PlanRegion intersection(const PlanRegion& a, const PlanRegion& b) {
    return boolean_operation(a, b, [](bool in_a, bool in_b) { return in_a && in_b; });
}

PlanRegion difference(const PlanRegion& a, const PlanRegion& b) {
    return boolean_operation(a, b, [](bool in_a, bool in_b) { return in_a && !in_b; });
}

Spans symmetric_difference(const Spans& a, const Spans& b) {
    return boolean_operation(a, b, [](bool in_a, bool in_b) { return in_a != in_b; });
}

PlanRegion dilated(const PlanRegion& region, int by) {
    if (by == 0) return region;
    std::vector<PlanBand> wide = region.bands;
    std::vector<int> lines;
    for (PlanBand& band : wide) {
        band = {band.begin - by, band.end + by, widened(band.spans, by)};
        lines.insert(lines.end(), {band.begin, band.end});
    }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    PlanRegion result;
    BandWindow window;
    std::size_t first = 0, end = 0;  // bands that reach the line
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        for (; end < wide.size() && wide[end].begin <= lines[i]; ++end) window.add(wide[end].spans);
        for (; first < end && wide[first].end <= lines[i]; ++first) window.drop_first();
        result.append(lines[i], lines[i + 1], window.all());
    }
    return result;
}

PlanRegion eroded(const PlanRegion& region, int by) {
    if (by == 0 || region.empty()) return region;
    PlanBox around{{region.bands.front().begin, region.bands.front().spans.front().begin},
                   {region.bands.back().end, region.bands.front().spans.back().end}};
    for (const PlanBand& band : region.bands) {
        around.least.z = std::min(around.least.z, band.spans.front().begin);
        around.greatest.z = std::max(around.greatest.z, band.spans.back().end);
    }
    // The complement, a step of it around the region.
    around = {{around.least.y - 1, around.least.z - 1}, {around.greatest.y + 1, around.greatest.z + 1}};
    return difference(region, dilated(difference(region_of(around), region), by));
}

std::int64_t area_of(const PlanRegion& region) {
    std::int64_t area = 0;
    for (const PlanBand& band : region.bands)
        for (const PlanSpan& span : band.spans)
            area += std::int64_t{band.end - band.begin} * (span.end - span.begin);
    return area;
}

std::vector<PlanRegion> connected_components(const PlanRegion& region) {
    // Every span is joined with those of the next band that it shares a length with.
    std::vector<std::size_t> first_span{0};
    for (const PlanBand& band : region.bands) first_span.push_back(first_span.back() + band.spans.size());
    std::vector<std::size_t> parent(first_span.back());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t span) {
        while (parent[span] != span) span = parent[span] = parent[parent[span]];
        return span;
    };
    for (std::size_t i = 0; i + 1 < region.bands.size(); ++i) {
        const PlanBand &band = region.bands[i], &next = region.bands[i + 1];
        if (band.end != next.begin) continue;
        for (std::size_t a = 0, b = 0; a < band.spans.size() && b < next.spans.size();) {
            const PlanSpan &one = band.spans[a], &other = next.spans[b];
            if (std::max(one.begin, other.begin) < std::min(one.end, other.end)) {
                const std::size_t x = root(first_span[i] + a), y = root(first_span[i + 1] + b);
                parent[std::max(x, y)] = std::min(x, y);
            }
            ++(one.end < other.end ? a : b);
        }
    }
    std::vector<std::size_t> roots;
    for (std::size_t span = 0; span < parent.size(); ++span)
        if (root(span) == span) roots.push_back(span);
    std::vector<PlanRegion> pieces(roots.size());
    for (std::size_t i = 0; i < region.bands.size(); ++i) {
        const PlanBand& band = region.bands[i];
        std::vector<std::pair<std::size_t, Spans>> here;  // pieces that this band has spans of
        for (std::size_t s = 0; s < band.spans.size(); ++s) {
            const auto piece = static_cast<std::size_t>(
                std::lower_bound(roots.begin(), roots.end(), root(first_span[i] + s)) - roots.begin());
            auto found =
                std::find_if(here.begin(), here.end(), [&](const auto& h) { return h.first == piece; });
            if (found == here.end()) found = here.insert(here.end(), {piece, {}});
            found->second.push_back(band.spans[s]);
        }
        for (auto& [piece, spans] : here) pieces[piece].append(band.begin, band.end, std::move(spans));
    }
    return pieces;
}

bool contains(const PlanRegion& region, PlanPoint point) {
    for (const Spans* spans : {&region.spans_behind(point.y), &region.spans_before(point.y)})
        for (const PlanSpan& span : *spans)
            if (span.begin <= point.z && point.z <= span.end) return true;
    return false;
}

}  // namespace snug

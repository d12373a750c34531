#include "snug/check/prism_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace snug {
namespace {

/// How far to go along an axis from `value` to the interval, with its sign.
double offset_to(double value, double low, double high) {
    return value < low ? low - value : value > high ? high - value : 0;
}

/// A path down the quadtree keeps at most three siblings a level; 2^20 cells along each axis are plenty.
constexpr std::size_t kStackSize = 4 * 21;

}  // namespace

PrismField::PrismField(Grid<PrismSpan> spans, double y_begin, double y_size, double z_begin, double z_size)
    : spans_(std::move(spans)), y_begin_(y_begin), y_size_(y_size), z_begin_(z_begin), z_size_(z_size) {
    while (levels_.empty() ? spans_.size() > 1 : levels_.back().size() > 1) build_level_above();
}

PrismField::Bounds PrismField::bounds_of(int level, int j, int k) const {
    if (level > 0) return levels_[static_cast<std::size_t>(level) - 1](j, k);
    const PrismSpan& span = spans_(j, k);
    return {span.low, span.high, span.low, span.high};
}

void PrismField::build_level_above() {
    const int below = static_cast<int>(levels_.size());
    const int ny = levels_.empty() ? spans_.ny() : levels_.back().ny();
    const int nz = levels_.empty() ? spans_.nz() : levels_.back().nz();
    Grid<Bounds> level((ny + 1) / 2, (nz + 1) / 2);
    for (int j = 0; j < level.ny(); ++j) {
        for (int k = 0; k < level.nz(); ++k) {
            Bounds all = bounds_of(below, 2 * j, 2 * k);
            for (int child = 1; child < 4; ++child) {
                const int cj = 2 * j + child / 2;
                const int ck = 2 * k + child % 2;
                if (cj >= ny || ck >= nz) continue;
                const Bounds b = bounds_of(below, cj, ck);
                all = {std::min(all.lowest_low, b.lowest_low), std::max(all.highest_high, b.highest_high),
                       std::max(all.highest_low, b.highest_low), std::min(all.lowest_high, b.lowest_high)};
            }
            level(j, k) = all;
        }
    }
    levels_.push_back(std::move(level));
}

Box3d PrismField::bounds() const {
    if (spans_.size() == 0) return {};
    const Bounds all = bounds_of(static_cast<int>(levels_.size()), 0, 0);
    if (all.lowest_low > all.highest_high) return {};
    return {{all.lowest_low, y_begin_, z_begin_},
            {all.highest_high, y_begin_ + spans_.ny() * y_size_, z_begin_ + spans_.nz() * z_size_}};
}

PrismSpan PrismField::span_at(Vec3d p) const {
    const double j = std::floor((p.y - y_begin_) / y_size_);
    const double k = std::floor((p.z - z_begin_) / z_size_);
    if (!(j >= 0 && j < spans_.ny() && k >= 0 && k < spans_.nz())) return {};
    return spans_(static_cast<int>(j), static_cast<int>(k));
}

bool PrismField::contains(Vec3d p) const {
    const PrismSpan span = span_at(p);
    return span.low <= p.x && p.x <= span.high;
}

/// `offset` tells how far to go along x from p to what is sought below a node (infinite: it is not there);
/// for a single span it must be exact, else it may be nearer than the truth.
template <class OffsetAlongX>
NearestPoint PrismField::nearest(Vec3d p, double at_most, OffsetAlongX offset) const {
    NearestPoint best{{}, at_most, 0};
    std::uint32_t looked_at = 0;
    double best2 = at_most * at_most;
    struct Branch {
        double distance2;
        Vec3d point;
        int level, j, k;
    };
    const auto branch = [&](int level, int j, int k) {
        const int cells = 1 << level;
        const double y = y_begin_ + j * cells * y_size_;
        const double z = z_begin_ + k * cells * z_size_;
        const double y_end = y_begin_ + std::min((j + 1) * cells, spans_.ny()) * y_size_;
        const double z_end = z_begin_ + std::min((k + 1) * cells, spans_.nz()) * z_size_;
        const Vec3d way{offset(bounds_of(level, j, k)), offset_to(p.y, y, y_end), offset_to(p.z, z, z_end)};
        return Branch{dot(way, way), p + way, level, j, k};
    };
    if (spans_.size() == 0) return best;
    std::array<Branch, kStackSize> stack;
    std::size_t waiting = 0;
    stack[waiting++] = branch(static_cast<int>(levels_.size()), 0, 0);
    while (waiting > 0) {
        const Branch next = stack[--waiting];
        ++looked_at;
        if (next.distance2 >= best2) continue;
        if (next.level == 0) {
            best2 = next.distance2;
            best = {next.point, std::sqrt(next.distance2), 0};
            continue;
        }
        const int level = next.level - 1;
        const int ny = level == 0 ? spans_.ny() : levels_[static_cast<std::size_t>(level) - 1].ny();
        const int nz = level == 0 ? spans_.nz() : levels_[static_cast<std::size_t>(level) - 1].nz();
        // The nearest child comes last, so that it is taken first.
        const std::size_t bottom = waiting;
        for (int child = 0; child < 4; ++child) {
            const int j = 2 * next.j + child / 2;
            const int k = 2 * next.k + child % 2;
            if (j >= ny || k >= nz) continue;
            const Branch below = branch(level, j, k);
            if (!(below.distance2 < best2)) continue;
            std::size_t place = waiting++;
            for (; place > bottom && stack[place - 1].distance2 < below.distance2; --place)
                stack[place] = stack[place - 1];
            stack[place] = below;
        }
    }
    best.looked_at = looked_at;
    return best;
}

NearestPoint PrismField::nearest_inside(Vec3d p, double at_most) const {
    return nearest(p, at_most, [&](const Bounds& b) {
        if (b.lowest_low > b.highest_high) return std::numeric_limits<double>::infinity();
        return offset_to(p.x, b.lowest_low, b.highest_high);
    });
}

NearestPoint PrismField::nearest_outside(Vec3d p, double at_most) const {
    NearestPoint best = nearest(p, at_most, [&](const Bounds& b) {
        const double down = p.x - b.highest_low;
        const double up = b.lowest_high - p.x;
        if (!(down > 0 && up > 0)) return 0.0;
        return up < down ? up : -down;
    });
    const double y_end = y_begin_ + spans_.ny() * y_size_;
    const double z_end = z_begin_ + spans_.nz() * z_size_;
    const auto beyond_grid = [&](double distance, Vec3d point) {
        if (distance < best.distance)
            best = {distance > 0 ? point : p, std::max(distance, 0.0), best.looked_at};
    };
    beyond_grid(p.y - y_begin_, {p.x, y_begin_, p.z});
    beyond_grid(y_end - p.y, {p.x, y_end, p.z});
    beyond_grid(p.z - z_begin_, {p.x, p.y, z_begin_});
    beyond_grid(z_end - p.z, {p.x, p.y, z_end});
    return best;
}

}  // namespace snug

#include "snug/search/quick_cut.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "snug/depth/depth_map.h"

namespace snug {
namespace {

/// Beyond every depth, with room for what is added to them.
constexpr std::int16_t kNoCut = 16000;
constexpr double kInset = 0.01;  // mm: a face on a face cuts nothing
/// Blocks that an object may be long in the lattice: more change the counts little and cost much.
constexpr double kMostBlocksLong = 64;

int log2_of(int power) {
    int result = 0;
    while ((1 << result) < power) ++result;
    return result;
}

template <class T>
T least_of(T a, T b) {
    return a < b ? a : b;
}

template <class T>
T most_of(T a, T b) {
    return a > b ? a : b;
}

}  // namespace

QuickCut::QuickCut(const DesignSpace& space, const CutOptions& cut, const std::array<double, 6>& least_wall,
                   double longest, int fine_y_z, int fine_x)
    : space_(space), least_wall_(least_wall) {
    const Clearance clearance = cut.whole_clearance_mm();
    const Box3d growth = grown({Vec3d{}, Vec3d{}}, clearance);
    grown_below_ = growth.min * -1.0;
    grown_above_ = growth.max;
    inset_ = clearance.lower - reach(clearance.lower, cut.cut_on_touch).mm;
    for (int axis = 0; axis < 3; ++axis) {
        Axis& a = axes_[static_cast<std::size_t>(axis)];
        const double block = space.block_mm[axis];
        a.block = block * std::max(1.0, std::ceil(longest / kMostBlocksLong / block));
        a.fine = axis == 0 ? fine_x : fine_y_z;
        a.pitch = a.block / a.fine;
        // Across x a mean of the halves: the method itself decides among what is promising here.
        const double both = clearance.lower[axis] + clearance.upper[axis];
        a.reach = static_cast<int>(std::floor(std::min(both / a.pitch, 1e3) + 0.5));
        a.window = std::max(1, a.fine + a.reach);
    }
    counts_.resize(static_cast<std::size_t>(fine_x * fine_y_z * fine_y_z));
}

void QuickCut::size_grid(Vec3d extent) {
    for (int axis = 0; axis < 3; ++axis) {
        Axis& a = axes_[static_cast<std::size_t>(axis)];
        a.cells = std::max(1, static_cast<int>(std::ceil((extent[axis] - kInset) / a.pitch)));
    }
    // Windows begin up to their width before the first cell.
    rows_ = axes_[1].cells + 2 * (axes_[1].window - 1);
    vectors_ = (axes_[2].cells + 2 * (axes_[2].window - 1) + kLanes - 1) / kLanes;
    const std::size_t size = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(vectors_ + 1);
    low_.assign(size, Lanes{} + kNoCut);
    high_.assign(size, Lanes{} - kNoCut);
    low_slid_.resize(size);
    high_slid_.resize(size);
}

void QuickCut::bin(const SurfacePoints& points, const Rotation& rotation, Vec3d low) {
    constexpr std::size_t kChunk = 256;
    std::array<std::array<float, 3>, 3> row{};
    std::array<float, 3> shift{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        for (int c = 0; c < 3; ++c)
            row[i][static_cast<std::size_t>(c)] = static_cast<float>(rotation.row[i][c] / axes_[i].pitch);
        shift[i] = static_cast<float>((-low[axis] - kInset) / axes_[i].pitch);
    }
    const auto [cx, cy, cz] = std::array<int, 3>{axes_[0].cells - 1, axes_[1].cells - 1, axes_[2].cells - 1};
    const int first_row = axes_[1].window - 1, first_cell = axes_[2].window - 1;
    const int stride = (vectors_ + 1) * kLanes;
    // Vectors and their lanes are the same memory: the type may alias its elements.
    auto* const lows = reinterpret_cast<std::int16_t*>(low_.data());
    auto* const highs = reinterpret_cast<std::int16_t*>(high_.data());
    std::array<std::int32_t, kChunk> column{}, depth{};
    for (std::size_t first = 0; first < points.size(); first += kChunk) {
        const std::size_t count = std::min(kChunk, points.size() - first);
        const float* const x = points.x.data() + first;
        const float* const y = points.y.data() + first;
        const float* const z = points.z.data() + first;
        for (std::size_t i = 0; i < count; ++i) {
            const auto at = [&](std::size_t axis, int last) {
                const float value =
                    row[axis][0] * x[i] + row[axis][1] * y[i] + row[axis][2] * z[i] + shift[axis];
                const auto cell = static_cast<std::int32_t>(value);
                return cell < 0 ? 0 : cell > last ? last : cell;
            };
            depth[i] = at(0, cx);
            column[i] = (at(1, cy) + first_row) * stride + at(2, cz) + first_cell;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto d = static_cast<std::int16_t>(depth[i]);
            std::int16_t& lowest = lows[column[i]];
            std::int16_t& highest = highs[column[i]];
            lowest = std::min(lowest, d);
            highest = std::max(highest, d);
        }
    }
}

/// Windows of any width from windows of powers of two: two of them, overlapping, cover it.
void QuickCut::slide_along_z() {
    const int window = axes_[2].window;
    const std::size_t bytes = low_.size() * sizeof(Lanes);
    const auto merge = [&](int by) {
        const std::size_t shift = static_cast<std::size_t>(by) * sizeof(std::int16_t);
        const auto* const lows = reinterpret_cast<const char*>(low_.data());
        const auto* const highs = reinterpret_cast<const char*>(high_.data());
        const std::size_t whole = shift + sizeof(Lanes) > bytes ? 0 : (bytes - shift) / sizeof(Lanes);
        for (std::size_t i = 0; i < whole; ++i) {
            Lanes next_low, next_high;
            std::memcpy(&next_low, lows + i * sizeof(Lanes) + shift, sizeof(Lanes));
            std::memcpy(&next_high, highs + i * sizeof(Lanes) + shift, sizeof(Lanes));
            low_slid_[i] = least_of(low_[i], next_low);
            high_slid_[i] = most_of(high_[i], next_high);
        }
        for (std::size_t i = whole; i < low_.size(); ++i) {
            low_slid_[i] = low_[i];
            high_slid_[i] = high_[i];
        }
        low_.swap(low_slid_);
        high_.swap(high_slid_);
    };
    int width = 1;
    for (; 2 * width <= window; width *= 2) merge(width);
    if (width < window) merge(window - width);
}

void QuickCut::slide_along_y() {
    const int window = axes_[1].window;
    const auto row = static_cast<std::size_t>(vectors_ + 1);
    const auto merge = [&](int by) {
        const std::size_t shift = row * static_cast<std::size_t>(by);
        for (std::size_t i = 0; i + shift < low_.size(); ++i) {
            low_[i] = least_of(low_[i], low_[i + shift]);
            high_[i] = most_of(high_[i], high_[i + shift]);
        }
    };
    int width = 1;
    for (; 2 * width <= window; width *= 2) merge(width);
    if (width < window) merge(window - width);
}

void QuickCut::count() {
    std::fill(counts_.begin(), counts_.end(), 0);
    const Axis &x = axes_[0], &y = axes_[1], &z = axes_[2];
    const int bits = log2_of(x.fine);
    for (int j = 0; j < rows_ - y.window + 1; ++j) {
        // The window of row j begins window - 1 cells further down, and 2 c / pitch below a block's face.
        const int start = j - (y.window - 1) + y.reach;
        const int py = ((-start) % y.fine + y.fine) % y.fine;
        const Lanes* const lows = low_.data() + static_cast<std::size_t>(j) * (vectors_ + 1);
        const Lanes* const highs = high_.data() + static_cast<std::size_t>(j) * (vectors_ + 1);
        for (int px = 0; px < x.fine; ++px) {
            const Lanes below = Lanes{} + static_cast<std::int16_t>(px);
            const Lanes above = Lanes{} + static_cast<std::int16_t>(px + x.reach);
            Lanes sum{};
            for (int v = 0; v < vectors_; ++v) {
                const Lanes blocks = ((highs[v] + above) >> bits) - ((lows[v] + below) >> bits) + 1;
                sum += most_of(blocks, Lanes{});
            }
            for (int lane = 0; lane < kLanes; ++lane) {
                const int begin = lane - (z.window - 1) + z.reach;
                counts_[slot(px, py, ((-begin) % z.fine + z.fine) % z.fine)] += sum[lane];
            }
        }
    }
}

double QuickCut::offset(int axis, int phase, double extent) const {
    const Axis& a = axes_[static_cast<std::size_t>(axis)];
    const double block = space_.block_mm[axis];
    // The lower end of the grown object lies `phase` pitches above a face.
    const double shift = space_.face(axis, 0) + phase * a.pitch + extent / 2 + grown_below_[axis];
    const double within = shift - block * std::floor(shift / block + 0.5);
    const double rounded = std::floor(within * 1e6 + 0.5) / 1e6;
    return rounded == 0 ? 0 : rounded;
}

/// `room`: what is kept free, from the middle of the object.
bool QuickCut::keeps_walls(int axis, double offset, const Box3d& room) const {
    const double block = space_.block_mm[axis], rounding = inset_[axis] + 1e-6;
    const double first = std::ceil((offset + room.min[axis] + rounding - space_.face(axis, 0)) / block) - 1;
    const double end = std::floor((offset + room.max[axis] - rounding - space_.face(axis, 0)) / block) + 1;
    const auto side = static_cast<std::size_t>(2 * axis);
    return first >= 0 && end <= space_.blocks[axis] && first * block >= least_wall_[side] &&
           (space_.blocks[axis] - end) * block >= least_wall_[side + 1];
}

std::vector<OffsetCut> QuickCut::least(const SurfacePoints& points, const Rotation& rotation,
                                       const Box3d& turned, std::size_t most, const Box3d& kept_free) {
    const Vec3d extent = turned.size(), middle = turned.centre();
    Box3d room{extent * -0.5 - grown_below_, extent * 0.5 + grown_above_};
    if (!kept_free.empty()) room.include(Box3d{kept_free.min - middle, kept_free.max - middle});
    std::array<std::vector<int>, 3> phases;
    for (int axis = 0; axis < 3; ++axis) {
        for (int phase = 0; phase < axes_[static_cast<std::size_t>(axis)].fine; ++phase)
            if (keeps_walls(axis, offset(axis, phase, extent[axis]), room))
                phases[static_cast<std::size_t>(axis)].push_back(phase);
        if (phases[static_cast<std::size_t>(axis)].empty()) return {};
    }
    size_grid(extent);
    bin(points, rotation, turned.min);
    slide_along_z();
    slide_along_y();
    count();

    struct Slot {
        long long blocks;
        int px, py, pz;
    };
    std::vector<Slot> slots;
    for (const int py : phases[1])
        for (const int px : phases[0])
            for (const int pz : phases[2]) slots.push_back({counts_[slot(px, py, pz)], px, py, pz});
    const auto better = [](const Slot& a, const Slot& b) {
        if (a.blocks != b.blocks) return a.blocks < b.blocks;
        if (a.px != b.px) return a.px < b.px;
        return a.py != b.py ? a.py < b.py : a.pz < b.pz;
    };
    const auto kept = static_cast<std::ptrdiff_t>(std::min(most, slots.size()));
    std::partial_sort(slots.begin(), slots.begin() + kept, slots.end(), better);
    std::vector<OffsetCut> result;
    for (auto s = slots.begin(); s != slots.begin() + kept; ++s)
        result.push_back(
            {s->blocks,
             {offset(0, s->px, extent.x), offset(1, s->py, extent.y), offset(2, s->pz, extent.z)}});
    return result;
}

}  // namespace snug

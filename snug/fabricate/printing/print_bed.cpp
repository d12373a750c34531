#include "snug/fabricate/printing/print_bed.h"

#include <algorithm>

namespace snug {
namespace {

constexpr double kBedRounding = 1e-6;  // mm: what fits but for rounding

struct BedRow {
    int bed;
    double y, depth;  ///< of its first and deepest thing
    double used;      ///< along x
};

}  // namespace

std::vector<BedPlace> places_on_beds(std::span<const Vec3d> sizes, Vec3d bed, double gap) {
    std::vector<std::size_t> order(sizes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sizes[a].y > sizes[b].y; });
    std::vector<BedPlace> places(sizes.size());
    std::vector<BedRow> rows;
    std::vector<double> filled;  // of each bed, along y
    for (const std::size_t i : order) {
        const Vec3d size = sizes[i];
        auto row = std::find_if(rows.begin(), rows.end(), [&](const BedRow& r) {
            return size.y <= r.depth + kBedRounding && r.used + gap + size.x <= bed.x + kBedRounding;
        });
        if (row == rows.end()) {
            const auto free = std::find_if(filled.begin(), filled.end(), [&](double used) {
                return used + gap + size.y <= bed.y + kBedRounding;
            });
            const double y = free == filled.end() ? 0 : *free + gap;
            const auto on = static_cast<std::size_t>(free - filled.begin());
            if (free == filled.end()) filled.push_back(0);
            filled[on] = y + size.y;
            row = rows.insert(rows.end(), {static_cast<int>(on), y, size.y, -gap});
        }
        places[i] = {row->bed, row->used + gap, row->y};
        row->used += gap + size.x;
    }
    return places;
}

}  // namespace snug

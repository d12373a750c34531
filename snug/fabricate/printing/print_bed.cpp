#include "snug/fabricate/printing/print_bed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "snug/search/mask_sheets.h"

namespace snug {
namespace {

constexpr double kBedRounding = 1e-6;     // mm: what fits but for rounding
constexpr std::size_t kMostThings = 400;  // every two are looked at
constexpr double kWidestBed = 1000;       // mm
constexpr long long kBedWork = 6'000'000;

struct BedRow {
    int bed;
    double y, depth;  ///< of its first and deepest thing
    double used;      ///< along x
};

std::vector<BedPlace> places_in_rows(std::span<const Vec3d> sizes, Vec3d bed, double gap) {
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

BitMask full_mask(int rows, int columns) {
    BitMask mask(rows, columns);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) mask.set(row, column);
    return mask;
}

/// On fewer beds than so many, where that is found to go: on a lattice of a millimetre.
std::optional<std::vector<BedPlace>> on_fewer_beds(std::span<const Vec3d> sizes, Vec3d bed, double gap,
                                                   int beds) {
    if (beds < 2 || sizes.size() > kMostThings || std::max(bed.x, bed.y) > kWidestBed) return {};
    MaskProblem problem;
    problem.gap = {static_cast<int>(std::ceil(gap)), static_cast<int>(std::ceil(gap))};
    std::map<std::pair<int, int>, int> shapes;
    for (const Vec3d size : sizes) {
        const auto steps = [](double mm) { return static_cast<int>(std::ceil(mm - kBedRounding)); };
        const int rows = std::max(1, steps(size.y)), columns = std::max(1, steps(size.x));
        const auto [shape, fresh] =
            shapes.try_emplace({rows, columns}, static_cast<int>(problem.shapes.size()));
        if (fresh) problem.shapes.push_back({full_mask(rows, columns)});
        problem.pieces.push_back({{shape->second}, {}, -1, -1});
    }
    SheetTask task;
    task.rows = static_cast<int>(bed.y + kBedRounding);
    task.columns = static_cast<int>(bed.x + kBedRounding);
    task.most_sheets = beds - 1;
    task.work = kBedWork;
    const auto packed = fewest_sheets(problem, task);
    if (!packed) return {};
    std::vector<BedPlace> places;
    for (const LaidMask& at : packed->layout)
        places.push_back({at.bin, static_cast<double>(at.column), static_cast<double>(at.row)});
    return places;
}

}  // namespace

std::vector<BedPlace> places_on_beds(std::span<const Vec3d> sizes, Vec3d bed, double gap) {
    std::vector<BedPlace> places = places_in_rows(sizes, bed, gap);
    int beds = 0;
    for (const BedPlace& place : places) beds = std::max(beds, place.bed + 1);
    if (auto fewer = on_fewer_beds(sizes, bed, gap, beds)) return std::move(*fewer);
    return places;
}

}  // namespace snug

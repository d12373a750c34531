#include "bench/nesting_instances.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>

#include "snug/polygon/polygon.h"

#include "bench/shared_folder.h"

namespace snug::bench {
namespace {

NestingInstance read(const nlohmann::json& json) {
    NestingInstance instance{json["name"], json["strip_height"], false, {}};
    for (const auto& item : json["items"]) {
        NestingInstance::Piece piece;
        piece.demand = item["demand"];
        for (const auto& point : item["shape"]["data"]) piece.polygon.push_back({point[0], point[1]});
        if (piece.polygon.front() == piece.polygon.back()) piece.polygon.pop_back();
        instance.half_turns = instance.half_turns || item["allowed_orientations"].size() > 1;
        instance.pieces.push_back(std::move(piece));
    }
    return instance;
}

std::vector<Vec2d> from_corner(std::vector<Vec2d> polygon) {
    Vec2d low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const Vec2d p : polygon) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    for (Vec2d& p : polygon) p = {p.x - low.x, p.y - low.y};
    return polygon;
}

/// A cell is taken where an edge goes through its inside, or its middle lies in the polygon. x runs along
/// rows.
BitMask raster(const std::vector<Vec2d>& polygon, double cell) {
    constexpr double kTouch = 1e-9;
    Vec2d most{0, 0};
    for (const Vec2d p : polygon) most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    const auto cells = [&](double length) {
        return std::max(1, static_cast<int>(std::ceil(length / cell - kTouch)));
    };
    BitMask mask(cells(most.x), cells(most.y));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Vec2d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if (a.x > b.x) std::swap(a, b);
        for (int row = 0; row < mask.rows(); ++row) {
            const double low = row * cell + kTouch * cell, high = (row + 1) * cell - kTouch * cell;
            if (b.x <= low || a.x >= high) continue;
            const auto y_at = [&](double x) {
                return b.x > a.x ? a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) : a.y;
            };
            double y0 = a.x < low ? y_at(low) : a.y, y1 = b.x > high ? y_at(high) : b.y;
            if (y0 > y1) std::swap(y0, y1);
            const int first = static_cast<int>(std::floor(y0 / cell + kTouch));
            const int end = static_cast<int>(std::ceil(y1 / cell - kTouch));
            for (int k = std::max(0, first); k < std::min(end, mask.columns()); ++k) mask.set(row, k);
        }
    }
    for (int j = 0; j < mask.rows(); ++j)
        for (int k = 0; k < mask.columns(); ++k)
            if (contains(polygon, {(j + 0.5) * cell, (k + 0.5) * cell})) mask.set(j, k);
    return mask;
}

}  // namespace

std::vector<NestingInstance> nesting_instances() {
    std::vector<NestingInstance> instances;
    for (const auto& path : shared_files("SNUG_NESTING", "nesting", ".json")) {
        std::ifstream file(path);
        instances.push_back(read(nlohmann::json::parse(file)));
    }
    return instances;
}

double area_of(const NestingInstance& instance) {
    double sum = 0;
    for (const auto& piece : instance.pieces) sum += piece.demand * std::fabs(signed_area(piece.polygon));
    return sum;
}

std::vector<std::vector<Vec2d>> all_polygons(const NestingInstance& instance) {
    std::vector<std::vector<Vec2d>> all;
    for (const auto& piece : instance.pieces)
        all.insert(all.end(), static_cast<std::size_t>(piece.demand), from_corner(piece.polygon));
    return all;
}

MaskProblem masks_of(const NestingInstance& instance, double cell) {
    MaskProblem problem;
    for (const auto& piece : instance.pieces) {
        MaskPiece laid;
        for (const bool turned : {false, true}) {
            if (turned && !instance.half_turns) continue;
            std::vector<Vec2d> polygon = piece.polygon;
            if (turned)
                for (Vec2d& p : polygon) p = {-p.x, -p.y};
            laid.shapes.push_back(static_cast<int>(problem.shapes.size()));
            problem.shapes.push_back({raster(from_corner(polygon), cell), 0, 0});
        }
        problem.pieces.insert(problem.pieces.end(), static_cast<std::size_t>(piece.demand), laid);
    }
    return problem;
}

}  // namespace snug::bench

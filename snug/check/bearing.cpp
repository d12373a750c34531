#include "snug/check/bearing.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/check/gravity.h"
#include "snug/check/line_budget.h"
#include "snug/check/line_hits.h"
#include "snug/check/line_lattice.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

/// Where each half ends in a column; where it has no foam the object presses on nothing.
struct Ends {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};

Ends ends_of(const Foams& foams, const DesignSpace& space, int layer, int j, int k) {
    Ends ends;
    for (const Piece piece : foams.all()) {
        const Run kept = foams.piece(piece)(j, k);
        if (kept.none()) continue;
        if (piece.index < layer) {
            ends.lower = space.face(0, kept.end);
        } else {
            ends.upper = space.face(0, kept.first);
            break;
        }
    }
    return ends;
}

/// The areas of the lines' cells, in square units of the lattice.
struct LineAreas {
    std::array<std::uint64_t, kSinking.size()> lower{};
    std::array<std::uint64_t, kSinking.size()> upper{};

    void add(std::span<const Crossing> line, std::uint64_t area, Ends ends) {
        for (std::size_t i = 0; i < kSinking.size(); ++i) {
            if (line.front().x - ends.lower < kSinking[i]) lower[i] += area;
            if (ends.upper - line.back().x < kSinking[i]) upper[i] += area;
        }
    }
};

}  // namespace

Result<BearingReport> bearing_report(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                                     const Foams& foams, int layer, const Progress& progress) {
    std::vector<Vec3d> placed;
    placed.reserve(mesh.vertices.size());
    for (const Vec3f& vertex : mesh.vertices) placed.push_back(placement(vertex));
    const LineLattice lattice = lattice_within({}, space, placed, mesh.triangles);
    const auto units_of_cell = static_cast<double>(std::uint64_t{1} << 2 * lattice.cell_bits());
    LineAreas areas;
    const auto done = sweep_lines(
        lattice, placed, mesh.triangles,
        [&](const LineBand& band) {
            for (int row = band.first_row; row < band.end_row(); ++row) {
                if (!band.any(row, band.first_column, band.end_column())) continue;
                for (int column = band.first_column; column < band.end_column(); ++column) {
                    const auto line = band.line(row, column);
                    if (line.empty()) continue;
                    const auto area = static_cast<std::uint64_t>(lattice.share(row, column) * units_of_cell);
                    const Ends ends =
                        ends_of(foams, space, layer, lattice.j(row, column), lattice.k(row, column));
                    areas.add(line, area, ends);
                }
            }
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    const double area = space.block_mm.y * space.block_mm.z / lattice.lines_per_column();
    const auto mm2 = [&](std::uint64_t units) { return static_cast<double>(units) / units_of_cell * area; };
    BearingReport report;
    for (std::size_t i = 0; i < kSinking.size(); ++i) {
        report.lower_mm2[i] = mm2(areas.lower[i]);
        report.upper_mm2[i] = mm2(areas.upper[i]);
    }
    return report;
}

std::optional<double> static_pressure_kpa(double mass_kg, double area_mm2) {
    if (area_mm2 <= 0) return {};
    return mass_kg * kStandardGravity / area_mm2 * 1e3;
}

void find_bearing_problems(const BearingReport& bearing, const Foams& foams, int layer,
                           std::optional<double> mass_kg, const FitOptions& fit,
                           std::vector<Finding>& findings) {
    const auto look = [&](const Message& foam, double area_mm2) {
        const auto warn = [&](Message message) {
            findings.push_back({Severity::warning, std::move(message)});
        };
        if (area_mm2 <= 0 && fit.pads) {
            findings.push_back({Severity::note, say("no_bearing/pads", {{"foam", foam}})});
            return;
        }
        std::vector<Message> fills{as_it_is("--pads 2")};
        if (!fit.settle) fills.insert(fills.begin(), as_it_is("--settle"));
        if (area_mm2 <= 0) return warn(say("no_bearing", {{"foam", foam}, {"fills", fills}}));
        const std::optional<double>& creep_kpa = fit.creep_kpa;
        if (!mass_kg || !creep_kpa) return;
        const double pressure = *static_pressure_kpa(*mass_kg, area_mm2);
        if (pressure <= *creep_kpa) return;
        warn(say("creep",
                 {{"foam", foam}, {"kpa", number(pressure, 1)}, {"creep_kpa", number(*creep_kpa, 1)}}));
    };
    const auto name = [](Piece piece) {
        return piece_text(piece, "foam.lower", "foam.middle", "foam.upper");
    };
    look(name(foams.at(layer - 1)), bearing.lower_mm2.back());
    if (foams.has(foams.at(layer))) look(name(foams.at(layer)), bearing.upper_mm2.back());
    sort_by_severity(findings);
}

}  // namespace snug

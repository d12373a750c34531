#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/fabricate/mill/mill_plan.h"

#include "tests/support/cases.h"
#include "tests/support/labelled_tray.h"
#include "tests/support/milled.h"

namespace snug {
namespace {

using test::Random;

/// The ways of the tool below the stock's top, as lines.
std::vector<std::vector<Vec3d>> engraved_lines(const test::GcodeProgram& program) {
    std::vector<std::vector<Vec3d>> lines;
    for (const test::GcodeMove& move : program.moves) {
        if (move.rapid) continue;
        if (move.from.x == move.to.x && move.from.y == move.to.y)
            lines.push_back({move.to});
        else
            lines.back().push_back(move.to);
    }
    return lines;
}

TEST(MillLabels, AreTheirStrokesIntoTheFoamThatStandsThere) {
    int labels = 0, seeds = 0;
    for (int seed = 0; seed < test::cases(30, 8); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 81000);
        const test::LabelledTray tray = test::labelled_tray(random, seed % 3 == 0);
        MillOptions options;
        options.cutter_mm = 2;
        options.flute_mm = 200;
        const FoamDesign foams = tray.foams();
        const auto plans = mill_plans(foams, {}, options);
        if (!plans) continue;  // pockets narrower than the cutter
        ++seeds;
        const auto pack = mill_pack(foams, {}, options);
        ASSERT_TRUE(pack);
        for (const Piece piece : foams.foams.all()) {
            std::vector<std::vector<Vec2d>> wanted;
            for (const ItemLabel& label : foams.labels)
                if (label.layer == piece.index + 1)
                    for (auto& line : label_lines(label)) wanted.push_back(std::move(line));
            const std::string stem = piece.index == 0 ? "lower" : "middle-" + std::to_string(piece.index);
            const std::string text = test::text_of(*pack, "mill/" + stem + "-labels.nc");
            ASSERT_EQ(text.empty(), wanted.empty());
            if (wanted.empty()) continue;
            const test::GcodeProgram program = test::read_gcode(text);
            EXPECT_TRUE(program.problems.empty() && program.ended);
            const auto lines = engraved_lines(program);
            ASSERT_EQ(lines.size(), wanted.size());
            const MillField& field = plans->plans[static_cast<std::size_t>(piece.index)].field;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                ASSERT_EQ(lines[i].size(), wanted[i].size());
                for (std::size_t p = 0; p < lines[i].size(); ++p) {
                    const Vec2d at{wanted[i][p].x, field.size_mm().y - wanted[i][p].y};
                    EXPECT_NEAR(lines[i][p].x, at.x, 6e-4);
                    EXPECT_NEAR(lines[i][p].y, at.y, 6e-4);
                    EXPECT_NEAR(lines[i][p].z, test::height_of(field, at) - field.top_mm() - 1, 1e-3);
                }
            }
            ++labels;
        }
    }
    EXPECT_GT(labels, seeds / 2);
}

TEST(MillLabels, GoHalfIntoThinFoam) {
    const test::ThinTray tray = test::thin_tray();
    MillOptions options;
    options.cutter_mm = 2;
    const auto pack = mill_pack(tray.foams(), {}, options);
    ASSERT_TRUE(pack);
    const auto lines = engraved_lines(test::read_gcode(test::text_of(*pack, "mill/lower-labels.nc")));
    ASSERT_FALSE(lines.empty());
    for (const auto& line : lines)
        for (const Vec3d p : line) EXPECT_NEAR(p.z, -0.25, 1e-3);
}

}  // namespace
}  // namespace snug

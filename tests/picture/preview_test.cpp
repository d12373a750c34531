#include "snug/picture/preview.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "snug/depth/depth_map.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/foam/block_map.h"
#include "snug/picture/gap_maps.h"
#include "snug/space/available.h"

#include "tests/support/heights.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

/// Why the text is not well-formed XML; empty where it is.
std::string xml_fault(std::string_view text) {
    std::vector<std::string> open;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '&') {
            const std::size_t end = text.find(';', at);
            if (end == std::string_view::npos || end - at > 6) return "a bare &";
            at = end + 1;
            continue;
        }
        if (text[at] != '<') {
            if (open.empty() && text[at] != '\n') return "text outside the root";
            ++at;
            continue;
        }
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos) return "a tag that does not end";
        const std::string tag(text.substr(at + 1, end - at - 1));
        at = end + 1;
        const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
        if (tag.find('<') != std::string::npos) return "< in " + tag;
        if (tag.front() == '/') {
            if (open.empty() || "/" + open.back() != tag) return "unexpected <" + tag + ">";
            open.pop_back();
            continue;
        }
        std::size_t quotes = 0;
        for (const char c : tag) quotes += c == '"' ? 1u : 0u;
        if (quotes % 2 != 0) return "an open quote in " + tag;
        if (tag.back() != '/') open.push_back(name);
    }
    return open.empty() ? "" : "<" + open.back() + "> stays open";
}

bool holds(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// Ellipsoid with the given half axes, rings x segments quads.
Mesh ellipsoid(Vec3f half, int rings, int segments) {
    Mesh mesh;
    const double pi = std::acos(-1.0);
    for (int i = 0; i <= rings; ++i)
        for (int s = 0; s < segments; ++s) {
            const double a = pi * i / rings, b = 2 * pi * s / segments;
            mesh.vertices.push_back({half.x * static_cast<float>(std::cos(a)),
                                     half.y * static_cast<float>(std::sin(a) * std::cos(b)),
                                     half.z * static_cast<float>(std::sin(a) * std::sin(b))});
        }
    const auto at = [&](int i, int s) { return static_cast<std::uint32_t>(i * segments + s % segments); };
    for (int i = 0; i < rings; ++i)
        for (int s = 0; s < segments; ++s) {
            mesh.triangles.push_back({at(i, s), at(i + 1, s), at(i + 1, s + 1)});
            mesh.triangles.push_back({at(i, s), at(i + 1, s + 1), at(i, s + 1)});
        }
    return mesh;
}

Foams foams_of(const Mesh& mesh, const Placement& placement, const DesignSpace& space) {
    const Reach grown = reach(0, false);
    return split(block_map(depth_map(mesh, placement, space, grown), space, grown), space,
                 space.blocks.x / 2);
}

std::string preview_of(const Mesh& mesh, const DesignSpace& space, Vec3d rotation_deg = {20, 30, 40}) {
    const Placement placement = place(mesh, rotation_deg, {});
    return preview_svg(foams_of(mesh, placement, space), space, mesh, placement, "an object");
}

/// Foams of one height each, without an object.
Foams flat(const DesignSpace& space, int lower, int upper) {
    return test::foams_of_heights(test::filled(space.blocks.y, space.blocks.z, lower),
                                  test::filled(space.blocks.y, space.blocks.z, upper), lower, space.blocks.x);
}

TEST(Preview, SaysWhatIsWhat) {
    const std::string svg = preview_of(ellipsoid({100, 60, 120}, 24, 40), {});
    EXPECT_EQ(xml_fault(svg), "");
    for (const char* label :
         {">LOWER<", ">LID<", ">BACK<", ">OBJECT<", ">x<", ">y<", ">z<", ">396 mm<", ">270 mm<", ">225 mm<",
          "450 x 270 x 396 mm", "<title>an object</title>", ">an object<"})
        EXPECT_TRUE(holds(svg, label)) << label;
    EXPECT_TRUE(holds(svg, "viewBox=\"0 0 317.5 "));
    EXPECT_FALSE(holds(svg, "nan") || holds(svg, "inf"));
}

TEST(Preview, IsTheSameTextEachTime) {
    const Mesh mesh = ellipsoid({100, 60, 120}, 24, 40);
    EXPECT_EQ(preview_of(mesh, {}), preview_of(mesh, {}));
}

TEST(Preview, DoesNotDependOnTheOrderOfTheTriangles) {
    Mesh mesh = ellipsoid({100, 60, 120}, 24, 40);
    const std::string svg = preview_of(mesh, {});
    std::vector<Triangle> reversed(mesh.triangles.rbegin(), mesh.triangles.rend());
    mesh.triangles = reversed;
    EXPECT_EQ(preview_of(mesh, {}), svg);
}

TEST(Preview, FilesStaySmall) {
    EXPECT_LT(preview_of(ellipsoid({150, 110, 170}, 100, 200), {}).size(), 300'000u);
    EXPECT_LT(preview_of(ellipsoid({150, 110, 170}, 100, 200), {{300, 180, 180}, {1.5, 1.5, 2.2}}).size(),
              1'500'000u);
}

TEST(Preview, TheRoughestFoamOfThePapersSizeStaysSmall) {
    const DesignSpace space;
    Random random(1);
    test::Heights lower = test::filled(space.blocks.y, space.blocks.z, 15), upper = lower;
    for (std::size_t i = 0; i < lower.size(); ++i) {
        lower[i] = static_cast<std::uint16_t>(random.integer(0, 15));
        upper[i] = static_cast<std::uint16_t>(random.integer(0, 15));
    }
    const Foams foams = test::foams_of_heights(lower, upper, 15, space.blocks.x);
    const std::string svg = preview_svg(foams, space, {}, {}, "");
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_LT(svg.size(), 300'000u);
}

TEST(Preview, CaptionsAreEscapedAndMayHoldAnything) {
    const DesignSpace space{{2, 2, 2}, {10, 10, 10}};
    const std::string svg = preview_svg(flat(space, 1, 1), space, {}, {}, "a<b>&\"c\" \xFF\x01 \xC3\xB6");
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_TRUE(holds(svg, "a&lt;b&gt;&amp;&quot;c&quot; \xEF\xBF\xBD\xEF\xBF\xBD \xC3\xB6"));
    EXPECT_EQ(xml_fault(preview_svg(flat(space, 1, 1), space, {}, {}, std::string(5000, '<'))), "");
    EXPECT_EQ(xml_fault(preview_svg(flat(space, 1, 1), space, {}, {}, "")), "");
}

TEST(Preview, ExtremeSpacesAndEmptyHalvesAreDrawn) {
    for (const Vec3i blocks : {Vec3i{1, 1, 1}, Vec3i{4096, 1, 1}, Vec3i{1, 4096, 1}, Vec3i{1, 1, 4096},
                               Vec3i{1, 600, 4096}, Vec3i{3, 2, 2}})
        for (const double side : {0.1, 10000.0})
            for (const int lower : {0, blocks.x / 2, blocks.x}) {
                SCOPED_TRACE(testing::Message()
                             << blocks.x << " " << blocks.y << " " << blocks.z << " " << lower);
                const DesignSpace space{blocks, {side, side, side}};
                const std::string svg = preview_svg(flat(space, lower, blocks.x - lower), space, {}, {}, "x");
                EXPECT_EQ(xml_fault(svg), "");
                EXPECT_FALSE(holds(svg, "nan") || holds(svg, "inf"));
                EXPECT_TRUE(holds(svg, ">LOWER<") && holds(svg, ">LID<") && holds(svg, ">BACK<"));
                EXPECT_LT(svg.size(), 60'000u);
            }
}

TEST(Preview, NothingAtAllIsStillADrawing) {
    const DesignSpace space{{4, 4, 4}, {10, 10, 10}};
    const std::string svg = preview_svg(flat(space, 0, 0), space, {}, {}, "x");
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_TRUE(holds(svg, ">LOWER<") && holds(svg, ">LID<"));
}

TEST(Preview, FlatObjectsAreOutlined) {
    for (const Vec3f half :
         {Vec3f{0, 60, 60}, Vec3f{60, 0, 60}, Vec3f{60, 60, 0}, Vec3f{0, 0, 60}, Vec3f{0, 0, 0}}) {
        const std::string svg = preview_of(ellipsoid(half, 6, 8), {}, {0, 0, 0});
        EXPECT_EQ(xml_fault(svg), "");
        EXPECT_TRUE(holds(svg, ">OBJECT<"));
        EXPECT_FALSE(holds(svg, "nan") || holds(svg, "inf"));
    }
}

/// Where the first polygon of a half (0: the lid, 1: the lower foam) is drawn, in tenths of a px.
struct Spot {
    double x = 0, y = 0;
};
Spot first_polygon(const std::string& svg, int group) {
    std::size_t at = svg.find(group == 0 ? "<g id=\"lid\"" : "<g id=\"lower\"");
    at = svg.find("d=\"M", at) + 4;
    std::size_t used = 0;
    const double x = std::stod(svg.substr(at, 12), &used);
    return {x, std::stod(svg.substr(at + used, 12))};
}

TEST(Preview, LowerShowsYTowardsTheViewerAndTheLidAwayFromHim) {
    const DesignSpace space{{4, 5, 6}, {10, 10, 10}};
    const auto pillar = [&](bool lower, int j, int k) {
        const test::Heights whole = test::filled(5, 6, 2);
        test::Heights half = test::filled(5, 6, 0);
        half(j, k) = 2;
        const Foams foams = test::foams_of_heights(lower ? half : whole, lower ? whole : half, 2, 4);
        return first_polygon(preview_svg(foams, space, {}, {}, "x"),
                             lower ? 1 : 0);  // the lid is drawn first
    };
    for (const bool lower : {true, false}) {
        const Spot corner = pillar(lower, 0, 0), along_k = pillar(lower, 0, 5), along_j = pillar(lower, 4, 0);
        EXPECT_GT(along_k.x, corner.x);
        if (lower) {
            EXPECT_GT(along_j.y, corner.y);
        } else {
            EXPECT_LT(along_j.y, corner.y);
        }
    }
    EXPECT_GT(pillar(true, 0, 0).y, pillar(false, 0, 0).y);  // the lid lies behind
    EXPECT_LT(pillar(true, 0, 0).x, pillar(false, 0, 0).x);
}

// ---- maps of the gap

/// One column of the lower half and the same of the lid have a gap.
GapReport gap_in_column(const DesignSpace& space, int j, int k, float undercut) {
    GapReport gap;
    gap.columns = Grid<ColumnGap>(space.blocks.y, space.blocks.z);
    gap.columns(j, k) = {10 - undercut, undercut, 10 - undercut, undercut};
    gap.undercut_mm3 = gap.lower.undercut_mm3 = gap.upper.undercut_mm3 = 0;
    return gap;
}

std::string maps_svg(const GapReport& gap, const DesignSpace& space) {
    Canvas canvas("maps", Language::english);
    const double height = draw_gap_maps(canvas, gap, {}, space, 0);
    return drawing_svg(canvas.finish({1200, height}));
}

/// Where the only coloured cell of a map (0: lower, 1: lid) begins, in tenths of a px.
Spot colored_cell(const std::string& svg, int map) {
    std::size_t at = svg.find(map == 0 ? "<g id=\"gap-lower\"" : "<g id=\"gap-lid\"");
    const std::size_t end = svg.find("</g>", at);
    while ((at = svg.find("<path fill=\"", at)) < end) {
        at += 12;
        if (svg.compare(at, 7, "#e8ebef") == 0) continue;
        at = svg.find("d=\"M", at) + 4;
        std::size_t used = 0;
        const double x = std::stod(svg.substr(at, 12), &used);
        return {x, std::stod(svg.substr(at + used, 12))};
    }
    return {-1, -1};
}

TEST(PreviewOfGaps, ShowsTheLowerFoamFromAboveAndTheLidIntoItsCavity) {
    const DesignSpace space{{4, 6, 8}, {10, 10, 10}};
    const auto cell = [&](int map, int j, int k) {
        const std::string svg = maps_svg(gap_in_column(space, j, k, 0), space);
        EXPECT_EQ(xml_fault(svg), "");
        return colored_cell(svg, map);
    };
    for (const int map : {0, 1}) {
        EXPECT_GT(cell(map, 1, 5).x, cell(map, 1, 2).x) << "k to the right";
        EXPECT_EQ(cell(map, 1, 5).y, cell(map, 1, 2).y);
    }
    EXPECT_GT(cell(0, 4, 2).y, cell(0, 1, 2).y) << "j downward";
    EXPECT_LT(cell(1, 4, 2).y, cell(1, 1, 2).y) << "j upward";
}

TEST(PreviewOfGaps, TellsStepsFromUndercutsAndSaysWhereTheBallIs) {
    const DesignSpace space{{4, 6, 8}, {10, 10, 10}};
    GapReport gap = gap_in_column(space, 2, 2, 0);
    const std::string steps = maps_svg(gap, space);
    EXPECT_NE(maps_svg(gap_in_column(space, 2, 2, 10), space), steps);
    EXPECT_FALSE(holds(steps, "<circle"));
    gap.lower.widest_mm = 12;
    EXPECT_TRUE(holds(maps_svg(gap, space), "a ball of 12 mm"));
    gap.undercut_mm3.reset();
    EXPECT_TRUE(holds(maps_svg(gap, space), "unknown: the object is open"));
}

TEST(Preview, SpeaksJapaneseWhereItIsAskedTo) {
    const DesignSpace space{{4, 6, 8}, {10, 10, 10}};
    const GapReport gap = gap_in_column(space, 2, 2, 0);
    const Foams foams = flat(space, 2, 2);
    const std::string svg = preview_svg(foams, space, {}, {}, "", &gap, Language::japanese);
    EXPECT_EQ(xml_fault(svg), "");
    for (const char* words : {"下（LOWER）", "ふた（LID）", "奥（BACK）", ">BACK<", "のすきま", "IPAGothic"})
        EXPECT_TRUE(holds(svg, words)) << words;
    for (const char* words : {"foam", "cavity", "Gap of", "closed"}) EXPECT_FALSE(holds(svg, words)) << words;
    EXPECT_FALSE(holds(preview_svg(foams, space, {}, {}, "", &gap), "\xE3")) << "nor English any Japanese";
}

TEST(PreviewOfGaps, StaysSmallHoweverManyColumns) {
    const DesignSpace space{{10, 900, 700}, {5, 1, 1}};
    GapReport gap = gap_in_column(space, 3, 3, 0);
    Random random(1);
    for (ColumnGap& column : gap.columns) column.lower_step = static_cast<float>(random.between(0, 20));
    EXPECT_LT(maps_svg(gap, space).size(), 900'000u);
}

}  // namespace
}  // namespace snug

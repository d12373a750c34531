#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "snug/mesh/samples.h"
#include "snug/search/direction_map.h"
#include "snug/search/exact_cut.h"
#include "snug/search/placement_search.h"

#include "tests/support/search_designs.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::roomy_design;
using test::space_of;

struct Searched {
    Mesh mesh;
    Design design;
    PreparedSurface surface;
    std::optional<PlacementSearch> search;

    explicit Searched(const Mesh& of) : mesh(of), design(roomy_design(mesh, {15, 15, 22})) {
        surface = prepare_surface(mesh);
        auto started = PlacementSearch::start(mesh, surface, design, space_of(design), 1);
        EXPECT_TRUE(started);
        search.emplace(std::move(*started));
    }
};

TEST(DirectionMap, EachPlacementPointsItsDirectionUp) {
    const Searched camera(*sample("camera"));
    const auto map = direction_map(*camera.search, 60);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->size(), 60);
    for (const MappedDirection& at : *map) {
        const Vec3d up = rotation_from_euler(at.placement.rotation_deg)(at.direction);
        EXPECT_NEAR(up.x, 1, 1e-9);
        EXPECT_GE(at.direction.z, 0);
    }
}

TEST(DirectionMap, IsNearWhatTheMethodCutsThere) {
    const Searched vase(*sample("vase"));
    const auto map = direction_map(*vase.search, 24);
    ASSERT_TRUE(map);
    for (const MappedDirection& at : *map) {
        const auto exact = exact_cut(vase.surface, space_of(vase.design), vase.design.cut,
                                     at.placement.rotation_deg, at.placement.offset_mm);
        ASSERT_TRUE(exact);
        const auto glance = static_cast<double>(at.placement.cut_blocks);
        EXPECT_NEAR(glance, static_cast<double>(exact->cut_blocks), 0.25 * glance);
    }
}

TEST(DirectionMap, OfAPlateIsLeastAcrossIt) {
    const Searched plate(test::box_mesh({0, 0, 0}, {150, 110, 6}));
    const auto map = direction_map(*plate.search, 200);
    ASSERT_TRUE(map);
    const auto least = std::min_element(map->begin(), map->end(), [](const auto& a, const auto& b) {
        return a.placement.cut_blocks < b.placement.cut_blocks;
    });
    // Flat or on an edge, where it is one block thick, but not askew.
    const Vec3d d = least->direction;
    EXPECT_GT(std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}), 0.97);
}

TEST(DirectionMap, CanBeCancelled) {
    const Searched camera(*sample("camera"));
    const auto map = direction_map(*camera.search, 60, [](double fraction) { return fraction < 0.5; });
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().kind, ErrorKind::cancelled);
}

TEST(DistinctPlacements, AreExactAndFarFromEachOther) {
    Searched camera(*sample("camera"));
    run(*camera.search, 1500);
    const auto found = camera.search->distinct(6, 20);
    ASSERT_GE(found.size(), 2);
    EXPECT_EQ(found.front().cut_blocks, camera.search->best().cut_blocks);
    const BlockSymmetry symmetry(space_of(camera.design), true);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto exact = exact_cut(camera.surface, space_of(camera.design), camera.design.cut,
                                     found[i].rotation_deg, found[i].offset_mm);
        ASSERT_TRUE(exact);
        EXPECT_EQ(exact->cut_blocks, found[i].cut_blocks);
        const Turn turn = turn_of(rotation_from_euler(found[i].rotation_deg));
        for (std::size_t other = 0; other < i; ++other) {
            const Turn there = turn_of(rotation_from_euler(found[other].rotation_deg));
            EXPECT_LE(symmetry.closest(turn, there), turn_about({1, 0, 0}, 20).w + 1e-9);
        }
    }
}

}  // namespace
}  // namespace snug

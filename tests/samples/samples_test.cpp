#include "snug/samples/samples.h"

#include <cmath>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include "snug/mesh/measure.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Made once for all tests: the figurine takes a while.
const Mesh& made(std::string_view name) {
    static std::map<std::string_view, Mesh> known;
    const auto [place, is_new] = known.try_emplace(name);
    if (is_new) place->second = sample(name).value();
    return place->second;
}

class Samples : public testing::TestWithParam<std::string_view> {
  protected:
    const Mesh& mesh_ = made(GetParam());
};

std::string name_of(const testing::TestParamInfo<std::string_view>& info) {
    return std::string(info.param);
}

double signed_volume(const Mesh& mesh, const MeshMeasure& measured, std::uint32_t part) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (measured.part_of_triangle[t] != part) continue;
        const Triangle& c = mesh.triangles[t];
        sum += dot(vec_cast<double>(mesh.vertices[c[0]]),
                   cross(vec_cast<double>(mesh.vertices[c[1]]), vec_cast<double>(mesh.vertices[c[2]])));
    }
    return sum / 6;
}

Mesh part_alone(const Mesh& mesh, const MeshMeasure& measured, std::uint32_t part) {
    Mesh alone = mesh;
    alone.triangles.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (measured.part_of_triangle[t] == part) alone.triangles.push_back(mesh.triangles[t]);
    return alone;
}

TEST_P(Samples, ConsistOfClosedOutwardParts) {
    const MeshMeasure m = measure(mesh_);
    EXPECT_TRUE(m.watertight);
    EXPECT_TRUE(m.holes.empty());
    for (std::uint32_t part = 0; part < m.parts.size(); ++part) {
        SCOPED_TRACE(part);
        EXPECT_TRUE(measure(part_alone(mesh_, m, part)).watertight);
        const Vec3d size = m.parts[part].bounds.size();
        EXPECT_GT(signed_volume(mesh_, m, part), 0.05 * size.x * size.y * size.z);
    }
}

TEST_P(Samples, HaveNoVertexTwiceOrInVainAndNoTriangleWithoutArea) {
    const std::vector<std::uint32_t> weld = welded(mesh_);
    std::vector<bool> used(weld.size());
    for (const Triangle& t : mesh_.triangles) {
        for (const std::uint32_t v : t) used[v] = true;
        const Vec3d a = vec_cast<double>(mesh_.vertices[t[0]]), b = vec_cast<double>(mesh_.vertices[t[1]]),
                    c = vec_cast<double>(mesh_.vertices[t[2]]);
        const Vec3d area = cross(b - a, c - a);
        EXPECT_GT(dot(area, area), 0);
    }
    for (std::uint32_t v = 0; v < weld.size(); ++v) {
        EXPECT_EQ(weld[v], v);
        EXPECT_TRUE(used[v]);
    }
}

TEST_P(Samples, LieInTheMiddleOfTheDefaultSpaceWithinItsWalls) {
    const Box3d box = bounds(mesh_);
    const Vec3d centre = box.centre(), room = DesignSpace{}.size() - Vec3d{100, 100, 100};
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(centre[axis], 0, 1e-4);
        EXPECT_LE(box.size()[axis], room[axis]);
    }
    EXPECT_LT(box.size().x, box.size().z);  // packed lying, not standing on its edge
}

TEST_P(Samples, HaveTheSameBytesEveryTime) {
    const Mesh again = sample(GetParam()).value();
    ASSERT_EQ(again.vertices.size(), mesh_.vertices.size());
    EXPECT_EQ(
        std::memcmp(again.vertices.data(), mesh_.vertices.data(), mesh_.vertices.size() * sizeof(Vec3f)), 0);
    EXPECT_EQ(again.triangles, mesh_.triangles);
}

INSTANTIATE_TEST_SUITE_P(, Samples, testing::Values("torus", "vase", "camera", "figurine"), name_of);

TEST(SampleNames, AreThoseThatCanBeMade) {
    EXPECT_EQ(sample_names(), (std::vector<std::string_view>{"torus", "vase", "camera", "figurine"}));
    const auto unknown = sample("teapot");
    ASSERT_FALSE(unknown.has_value());
    EXPECT_EQ(unknown.error().kind, ErrorKind::usage);
    for (const std::string_view name : sample_names())
        EXPECT_NE(text(unknown.error().message).find(name), std::string::npos);
}

TEST(Torus, Has7200VerticesAndTheVolumeOfItsPolygons) {
    const Mesh& mesh = made("torus");
    EXPECT_EQ(mesh.vertices.size(), 7200u);
    EXPECT_EQ(mesh.triangles.size(), 14400u);
    const MeshMeasure m = measure(mesh);
    EXPECT_EQ(m.parts.size(), 1u);
    EXPECT_NEAR(m.bounds.size().y, 160, 1e-3);
    EXPECT_NEAR(m.bounds.size().x, 50, 0.1);
    // A 60-gon has sin(6 deg) / rad(6 deg) of its circle's area, and the 120-gon around loses as much of its
    // turn.
    const double round = 2 * kPi * kPi * 55 * 25 * 25;
    const double polygons = std::sin(kPi / 30) / (kPi / 30) * (std::sin(kPi / 60) / (kPi / 60));
    EXPECT_NEAR(m.volume.value(), round * polygons, 0.001 * round);
    EXPECT_LT(m.volume.value(), round);
}

TEST(Vase, HoldsWaterBehindAWallOfEvenThickness) {
    const Mesh& mesh = made("vase");
    const MeshMeasure m = measure(mesh);
    EXPECT_EQ(m.parts.size(), 1u);
    EXPECT_GT(m.bounds.size().z, m.bounds.size().x);
    // Half-way up, seen from the axis, the wall has an inside and an outside.
    double inner = 1e9, outer = 0;
    for (const Vec3f& v : mesh.vertices) {
        if (std::fabs(v.z) > 15) continue;
        const double radius = std::sqrt(static_cast<double>(v.x) * v.x + static_cast<double>(v.y) * v.y);
        inner = std::min(inner, radius);
        outer = std::max(outer, radius);
    }
    EXPECT_GT(inner, 50);
    EXPECT_GT(outer - inner, 4);
    const Vec3d size = m.bounds.size();
    EXPECT_LT(m.volume.value(), 0.2 * size.x * size.y * size.z);
}

TEST(Camera, IsManyPartsEachOverlappingAnother) {
    const Mesh& mesh = made("camera");
    const MeshMeasure m = measure(mesh);
    EXPECT_GE(m.parts.size(), 8u);
    const auto overlap = [](const Box3d& a, const Box3d& b) {
        return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y &&
               a.min.z < b.max.z && b.min.z < a.max.z;
    };
    for (std::size_t a = 0; a < m.parts.size(); ++a) {
        bool held = false;
        for (std::size_t b = 0; b < m.parts.size(); ++b)
            held = held || (a != b && overlap(m.parts[a].bounds, m.parts[b].bounds));
        EXPECT_TRUE(held) << "part " << a;
    }
}

TEST(Figurine, HasArmsThatOneCanReachThrough) {
    const Mesh& mesh = made("figurine");
    const MeshMeasure m = measure(mesh);
    EXPECT_EQ(m.parts.size(), 1u);
    EXPECT_GT(mesh.triangles.size(), 20000u);
    EXPECT_LT(mesh.triangles.size(), 40000u);
    // A closed surface with two handles: V - E + F = 2 - 2 * 2, E = 3/2 F.
    const auto v = static_cast<long long>(mesh.vertices.size()),
               f = static_cast<long long>(mesh.triangles.size());
    EXPECT_EQ(v - f / 2, -2);
}

TEST(Figurine, IsSymmetric) {
    const Mesh& mesh = made("figurine");
    double moment = 0;
    for (const Vec3f& v : mesh.vertices) moment += v.y;
    EXPECT_NEAR(moment / static_cast<double>(mesh.vertices.size()), 0, 0.05);
}

}  // namespace
}  // namespace snug

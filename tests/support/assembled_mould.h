#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/box.h"
#include "snug/fabricate/kit/workshop_pack.h"

#include "tests/support/printed_files.h"

namespace snug::test {

/// A binary STL, its equal corners made one; without any of the writer's code.
[[nodiscard]] inline PrintedItem read_stl_part(const std::string& name, const FileBytes& bytes) {
    PrintedItem item{name, {}, {}};
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    EXPECT_EQ(bytes.size(), 84 + 50 * static_cast<std::size_t>(count)) << name;
    std::map<std::array<float, 3>, std::uint32_t> known;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 12> numbers{};
        std::memcpy(numbers.data(), bytes.data() + 84 + 50 * i, 48);
        Triangle triangle{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::array<float, 3> at{numbers[3 + 3 * corner], numbers[4 + 3 * corner],
                                          numbers[5 + 3 * corner]};
            const auto [place, added] = known.emplace(at, static_cast<std::uint32_t>(item.vertices.size()));
            if (added) item.vertices.push_back({at[0], at[1], at[2]});
            triangle[corner] = place->second;
        }
        item.triangles.push_back(triangle);
    }
    return item;
}

/// A mould put together from its STL files as mould/parts.csv says: x to the right, y to the back, z up.
struct AssembledMould {
    std::vector<PrintedItem> parts;
    Box3d box;

    /// Where an upright line goes into plastic (+1) or out of it, from below; parts that touch cancel out.
    [[nodiscard]] std::vector<std::pair<double, int>> crossings(double x, double y) const {
        std::vector<std::pair<double, int>> all;
        for (const PrintedItem& part : parts)
            for (const Triangle& t : part.triangles) {
                const auto corner = [&](std::size_t i) {
                    return vec_cast<double>(part.vertices[t[i]]) - Vec3d{x, y, 0};
                };
                const Vec3d a = corner(0), b = corner(1), c = corner(2);
                const auto side = [](Vec3d u, Vec3d v) { return u.x * v.y - u.y * v.x; };
                const double ab = side(a, b), bc = side(b, c), ca = side(c, a), area = ab + bc + ca;
                if (!((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) continue;
                all.push_back({(a.z * bc + b.z * ca + c.z * ab) / area, area > 0 ? -1 : 1});
            }
        std::sort(all.begin(), all.end());
        return all;
    }
    [[nodiscard]] int winding(Vec3d p) const {
        int turns = 0;
        for (const auto& [z, way] : crossings(p.x, p.y))
            if (z < p.z) turns += way;
        return turns;
    }
};

[[nodiscard]] inline AssembledMould assembled_mould(const WorkshopPack& pack, const std::string& half) {
    std::map<std::string, const FileBytes*> files;
    for (const PackFile& file : pack.files) files[file.name] = &file.bytes;
    AssembledMould mould;
    std::istringstream text(text_of(*files.at("mould/parts.csv")));
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "part,left_mm,front_mm,up_mm,width_mm,depth_mm,height_mm,turned_deg");
    while (std::getline(text, line)) {
        std::istringstream cells(line);
        std::string name;
        std::getline(cells, name, ',');
        if (name.rfind(half, 0) != 0) continue;
        std::array<double, 7> n{};
        char comma = 0;
        for (double& value : n) cells >> value >> comma;
        PrintedItem part = read_stl_part(name, *files.at("mould/" + name + ".stl"));
        for (Vec3f& v : part.vertices) {
            // A quarter turn counter-clockwise on the bed is undone.
            if (n[6] == 90) v = {v.y, static_cast<float>(n[4]) - v.x, v.z};
            v = v + Vec3f{static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])};
        }
        const Box3d box = bounds_of(part);
        EXPECT_NEAR(box.max.x - n[0], n[3], 1e-3);
        EXPECT_NEAR(box.max.y - n[1], n[4], 1e-3);
        EXPECT_NEAR(box.max.z - n[2], n[5], 1e-3);
        mould.box.include(box);
        mould.parts.push_back(std::move(part));
    }
    return mould;
}

}  // namespace snug::test

#pragma once

#include <functional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "snug/fabricate/kit/output_files.h"
#include "snug/formats/read.h"
#include "snug/make.h"

#include "tests/support/solid_lines.h"

namespace snug::test {

[[nodiscard]] inline std::vector<Corners> corners_of(const Mesh& mesh,
                                                     const std::function<Vec3d(Vec3f)>& place) {
    std::vector<Corners> triangles;
    for (const Triangle& t : mesh.triangles)
        triangles.push_back(
            {place(mesh.vertices[t[0]]), place(mesh.vertices[t[1]]), place(mesh.vertices[t[2]])});
    return triangles;
}

/// Every foam that is written as STL, in design coordinates.
[[nodiscard]] inline std::vector<std::vector<Corners>> foams_of_files(std::span<const Object> objects,
                                                                      const Project& project, Made& made) {
    std::vector<std::vector<Corners>> foams;
    const auto done = make_output_files(objects, project, made, [&](const PackFile& file) {
        if (file.name.ends_with(".stl")) {
            const auto mesh = read_stl(file.bytes);
            EXPECT_TRUE(mesh) << file.name;
            foams.push_back(corners_of(*mesh, [&](Vec3f v) { return vec_cast<double>(v) + mesh->origin; }));
        }
        return Result<void>();
    });
    EXPECT_TRUE(done);
    return foams;
}

/// A column of foam, mm and mm2.
struct Spring {
    double gap, thickness, area;
};

}  // namespace snug::test

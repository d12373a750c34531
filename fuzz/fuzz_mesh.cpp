#include "snug/formats/read.h"
#include "snug/mesh/measure.h"

#include "fuzz/check_mesh.h"

// Any format, and what is measured of the mesh.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto mesh = snug::read_mesh(snug::fuzz::bytes(data, size), "object");
    snug::fuzz::check(mesh);
    if (mesh) snug::fuzz::require(snug::measure(*mesh).part_of_triangle.size() == mesh->triangles.size());
    return 0;
}

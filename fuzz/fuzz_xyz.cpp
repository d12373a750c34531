#include "snug/formats/read_cloud.h"
#include "snug/words/words.h"

#include "fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto cloud = snug::read_xyz(snug::fuzz::bytes(data, size));
    if (!cloud) {
        snug::fuzz::require(!text(cloud.error().message).empty());
        return 0;
    }
    snug::fuzz::require(cloud->is_cloud());
    snug::fuzz::check_vertices(*cloud);
    return 0;
}

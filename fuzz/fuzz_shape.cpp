#include "snug/formats/read.h"

#include "fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    snug::fuzz::check(snug::read_shape(snug::fuzz::bytes(data, size)));
    return 0;
}

#include "snug/base/utf16.h"

#include <algorithm>
#include <cstddef>

#include "snug/base/utf8.h"

namespace snug {
namespace {

enum class Order { little_endian, big_endian };

bool is_latin(std::byte b) {
    return (b >= std::byte{0x20} && b < std::byte{0x7f}) || b >= std::byte{0xa0} || b == std::byte{'\t'} ||
           b == std::byte{'\n'} || b == std::byte{'\r'};
}

/// Of texts that begin with some Latin letters, one byte in two is 0.
bool begins_plainly(Bytes file, Order order) {
    constexpr std::size_t kLeast = 4, kLooked = 16;  // letters
    if (file.size() < 2 * kLeast) return false;
    const std::size_t low = order == Order::little_endian ? 0 : 1;
    for (std::size_t i = 0; i + 1 < std::min(file.size(), 2 * kLooked); i += 2)
        if (!is_latin(file[i + low]) || file[i + 1 - low] != std::byte{0}) return false;
    return true;
}

bool is_marked(Bytes file) {
    if (file.size() < 2) return false;
    return (file[0] == std::byte{0xff} && file[1] == std::byte{0xfe}) ||
           (file[0] == std::byte{0xfe} && file[1] == std::byte{0xff});
}

}  // namespace

std::optional<std::string> utf8_of_utf16(Bytes file) {
    if (!is_marked(file) && !begins_plainly(file, Order::little_endian) &&
        !begins_plainly(file, Order::big_endian))
        return {};
    return from_utf16(file);
}

}  // namespace snug

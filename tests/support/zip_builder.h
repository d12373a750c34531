#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/bytes.h"

namespace snug::test {

/// A member of a zip that a test makes. Everything that an archive says of it can be said wrongly.
struct ZipPart {
    std::string name, text;
    bool deflated = false;               ///< as one block that is stored: DEFLATE without packing
    bool descriptor = false;             ///< sizes and checksum behind the data instead of before it
    bool zip64 = false;                  ///< sizes and offset in the directory's zip64 field
    bool utf8 = false;                   ///< the flag that says so
    std::uint16_t method = 0xffff;       ///< instead of the true one
    std::uint16_t flags = 0;             ///< besides those above
    std::uint32_t wrong_checksum = 0;    ///< to be added
    std::uint64_t claimed_size = ~0ull;  ///< unpacked, instead of the true one
};

struct ZipShape {
    std::string junk;     ///< before the archive; offsets count from behind it
    std::string comment;  ///< at its end
    bool zip64 = false;   ///< an end record of zip64, too
    bool shares = false;  ///< every entry of the directory is the first member
};

/// By the format's description (APPNOTE 6.3), with nothing of the reader's.
std::string zip_of(const std::vector<ZipPart>& parts, const ZipShape& shape = {});

/// The CRC-32 of a text, bit by bit.
std::uint32_t crc_of(std::string_view text);

}  // namespace snug::test

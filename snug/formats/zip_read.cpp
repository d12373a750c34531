#include "snug/formats/zip_read.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/little_endian.h"
#include "snug/formats/zip_directory.h"

namespace snug {
namespace {

// DEFLATE packs up to 1032 times; meshes as text, which repeat much, come to 30.
constexpr std::uint64_t kMostTimes = 100;
constexpr std::uint64_t kAlwaysBytes = std::uint64_t{64} << 20;
constexpr std::uint64_t kMostBytes = std::uint64_t{3} << 30;  // of what a browser can hold at all

constexpr std::uint16_t kStored = 0, kDeflated = 8;

constexpr std::array<std::uint32_t, 256> kCrcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
        table[byte] = crc;
    }
    return table;
}();

std::uint32_t checksum(Bytes bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const std::byte b : bytes)
        crc = kCrcTable[(crc ^ std::to_integer<std::uint32_t>(b)) & 0xff] ^ (crc >> 8);
    return ~crc;
}

std::uint64_t most_unpacked(std::size_t file) {
    return std::min(kMostBytes, std::max(kAlwaysBytes, kMostTimes * file));
}

std::string megabytes(std::uint64_t bytes) {
    return grouped((bytes + 999'999) / 1'000'000) + " MB";
}

}  // namespace

bool is_zip(Bytes file) {
    if (file.size() < 4) return false;
    const std::uint64_t signature = little_endian(file, 0, 4);
    return signature == 0x04034b50 || signature == 0x06054b50;
}

ZipReader::ZipReader(Bytes file, Inflate inflate, std::vector<ZipMember> members)
    : file_(file),
      inflate_(std::move(inflate)),
      members_(std::move(members)),
      left_(most_unpacked(file.size())) {}

Result<ZipReader> ZipReader::open(Bytes file, Inflate inflate) {
    auto members = zip_directory(file);
    if (!members) return tl::unexpected(members.error());
    return ZipReader(file, std::move(inflate), std::move(*members));
}

Result<FileBytes> ZipReader::unpack(const ZipMember& member) {
    const std::string name = quoted(member.name, 80);
    if (member.encrypted) return fail(ErrorKind::input, say("zip.encrypted", {{"name", name}}));
    if (member.method != kStored && member.method != kDeflated)
        return fail(ErrorKind::input,
                    say("zip.method", {{"name", name}, {"method", std::to_string(member.method)}}));
    if (member.size > left_)
        return fail(ErrorKind::input,
                    say("zip.too_large", {{"name", name},
                                          {"size", megabytes(member.size)},
                                          {"most", megabytes(most_unpacked(file_.size()))}}));
    left_ -= member.size;
    const auto wrong = [&] { return fail(ErrorKind::input, say("zip.damaged_member", {{"name", name}})); };
    const Bytes packed = part_of(file_, member.begin, member.packed);
    if (member.method == kStored && packed.size() != member.size) return wrong();
    if (member.method == kDeflated && !inflate_)
        return fail(ErrorKind::input, say("zip.not_here", {{"name", name}}));
    auto bytes = member.method == kStored ? Result<FileBytes>(FileBytes(packed.begin(), packed.end()))
                                          : inflate_(packed, static_cast<std::size_t>(member.size));
    if (!bytes || bytes->size() != member.size || checksum(*bytes) != member.checksum) return wrong();
    return bytes;
}

}  // namespace snug

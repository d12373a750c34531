#include "tests/support/zip_builder.h"

namespace snug::test {
namespace {

void put(std::string& file, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) file.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

/// Blocks of DEFLATE that are stored, each of at most 65,535 bytes.
std::string stored_blocks(std::string_view text) {
    constexpr std::size_t kMost = 65535;
    std::string packed;
    for (std::size_t at = 0; at == 0 || at < text.size(); at += kMost) {
        const std::string_view piece = text.substr(at, kMost);
        packed.push_back(at + kMost >= text.size() ? 1 : 0);
        put(packed, piece.size(), 2);
        put(packed, ~piece.size(), 2);
        packed += piece;
    }
    return packed;
}

struct Written {
    std::uint64_t offset = 0, packed = 0, size = 0;
    std::uint32_t checksum = 0;
    std::uint16_t method = 0, flags = 0;
};

Written write_member(const ZipPart& part, std::uint64_t junk, std::string& file) {
    const std::string data = part.deflated ? stored_blocks(part.text) : part.text;
    Written done;
    done.offset = file.size() - junk;
    done.packed = data.size();
    done.size = part.claimed_size == ~0ull ? part.text.size() : part.claimed_size;
    done.checksum = crc_of(part.text) + part.wrong_checksum;
    done.method = part.method != 0xffff ? part.method : part.deflated ? 8 : 0;
    done.flags = static_cast<std::uint16_t>(part.flags | (part.descriptor ? 8 : 0) | (part.utf8 ? 0x800 : 0));
    put(file, 0x04034b50, 4);
    put(file, 20, 2);
    put(file, done.flags, 2);
    put(file, done.method, 2);
    put(file, 0, 4);
    put(file, part.descriptor ? 0 : done.checksum, 4);
    put(file, part.descriptor ? 0 : done.packed, 4);
    put(file, part.descriptor ? 0 : done.size, 4);
    put(file, part.name.size(), 2);
    put(file, 0, 2);
    file += part.name + data;
    if (part.descriptor) {
        put(file, 0x08074b50, 4);
        put(file, done.checksum, 4);
        put(file, done.packed, 4);
        put(file, done.size, 4);
    }
    return done;
}

void write_entry(const ZipPart& part, const Written& done, std::string& file) {
    constexpr std::uint32_t kBeyond = 0xffffffff;
    put(file, 0x02014b50, 4);
    put(file, 20, 2);
    put(file, part.zip64 ? 45 : 20, 2);
    put(file, done.flags, 2);
    put(file, done.method, 2);
    put(file, 0, 4);
    put(file, done.checksum, 4);
    put(file, part.zip64 ? kBeyond : done.packed, 4);
    put(file, part.zip64 ? kBeyond : done.size, 4);
    put(file, part.name.size(), 2);
    put(file, part.zip64 ? 33 : 0, 2);
    file.append(10, '\0');  // no comment, the first disk, no attributes
    put(file, part.zip64 ? kBeyond : done.offset, 4);
    file += part.name;
    if (!part.zip64) return;
    put(file, 0x5455, 2);  // a time, which is passed over
    put(file, 1, 2);
    put(file, 0, 1);
    put(file, 1, 2);
    put(file, 24, 2);
    put(file, done.size, 8);
    put(file, done.packed, 8);
    put(file, done.offset, 8);
}

}  // namespace

std::uint32_t crc_of(std::string_view text) {
    std::uint32_t crc = 0xffffffff;
    for (const char c : text) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
    }
    return ~crc;
}

std::string zip_of(const std::vector<ZipPart>& parts, const ZipShape& shape) {
    std::string file = shape.junk;
    std::vector<Written> written;
    for (const ZipPart& part : parts) written.push_back(write_member(part, shape.junk.size(), file));
    const std::uint64_t begin = file.size() - shape.junk.size();
    for (std::size_t i = 0; i < parts.size(); ++i) write_entry(parts[i], written[shape.shares ? 0 : i], file);
    const std::uint64_t size = file.size() - shape.junk.size() - begin;
    if (shape.zip64) {
        const std::uint64_t end = file.size() - shape.junk.size();
        put(file, 0x06064b50, 4);
        put(file, 44, 8);
        put(file, 45, 2);
        put(file, 45, 2);
        put(file, 0, 8);
        put(file, parts.size(), 8);
        put(file, parts.size(), 8);
        put(file, size, 8);
        put(file, begin, 8);
        put(file, 0x07064b50, 4);
        put(file, 0, 4);
        put(file, end, 8);
        put(file, 1, 4);
    }
    put(file, 0x06054b50, 4);
    put(file, 0, 4);
    put(file, shape.zip64 ? 0xffff : parts.size(), 2);
    put(file, shape.zip64 ? 0xffff : parts.size(), 2);
    put(file, shape.zip64 ? 0xffffffff : size, 4);
    put(file, shape.zip64 ? 0xffffffff : begin, 4);
    put(file, shape.comment.size(), 2);
    return file + shape.comment;
}

}  // namespace snug::test

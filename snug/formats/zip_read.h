#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/result.h"

namespace snug {

/// A file within a zip, as the archive's directory tells of it.
struct ZipMember {
    std::string name;            ///< UTF-8, folders parted by slashes; ends with one where it is a folder
    std::uint64_t begin = 0;     ///< of its data, bytes from the beginning of the archive
    std::uint64_t packed = 0;    ///< bytes in the archive
    std::uint64_t size = 0;      ///< bytes once unpacked
    std::uint32_t checksum = 0;  ///< CRC-32 of what is unpacked
    std::uint16_t method = 0;    ///< 0: stored, 8: DEFLATE
    bool encrypted = false;

    [[nodiscard]] bool is_folder() const { return !name.empty() && name.back() == '/'; }
};

/// Unpacks raw DEFLATE, at most so many bytes (SceneTools::inflate).
using Inflate = std::function<Result<FileBytes>(Bytes packed, std::size_t most)>;

/// Whether the bytes begin as a zip does, or as one that is empty.
[[nodiscard]] bool is_zip(Bytes file);

/// A zip archive (PKWARE APPNOTE 6.3), with or without zip64, data descriptors, bytes before the archive and
/// comments behind it. Names that are no UTF-8 are taken for code page 437. Nothing is unpacked before it is
/// asked for, and all that is unpacked together is at most a hundred times the archive or 64 MiB. Errors are
/// of kind `input`, without the archive's name.
class ZipReader {
  public:
    /// The bytes must outlive the reader. Fails where the directory is missing or wrong, or where members
    /// share bytes: then a few bytes could claim to be any amount.
    [[nodiscard]] static Result<ZipReader> open(Bytes file, Inflate inflate);

    /// In the directory's order. Of equal names the last is the valid one.
    [[nodiscard]] const std::vector<ZipMember>& members() const { return members_; }

    /// A member's bytes, with its checksum proven. Fails also for a member that is encrypted, packed by
    /// another method, or more than the archive may still hold.
    [[nodiscard]] Result<FileBytes> unpack(const ZipMember& member);

  private:
    ZipReader(Bytes file, Inflate inflate, std::vector<ZipMember> members);

    Bytes file_;
    Inflate inflate_;
    std::vector<ZipMember> members_;
    std::uint64_t left_;  // bytes that may still be unpacked
};

}  // namespace snug

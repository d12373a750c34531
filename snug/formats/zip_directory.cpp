#include "snug/formats/zip_directory.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/little_endian.h"
#include "snug/formats/zip_names.h"

namespace snug {
namespace {

constexpr std::uint64_t kInZip64 = 0xffffffff;  // stands where the field is too small
constexpr std::uint64_t kCountInZip64 = 0xffff;

// The records' signatures and the bytes of their fixed parts.
constexpr std::uint64_t kMember = 0x04034b50, kEntry = 0x02014b50, kEnd = 0x06054b50, kEnd64 = 0x06064b50,
                        kLocator64 = 0x07064b50;
constexpr std::size_t kMemberBytes = 30, kEntryBytes = 46, kEndBytes = 22, kEnd64Bytes = 56,
                      kLocatorBytes = 20;

tl::unexpected<Error> damaged(Message what) {
    return fail(ErrorKind::input, say("zip.damaged", {{"what", std::move(what)}}));
}

bool has(Bytes file, std::uint64_t at, std::size_t bytes, std::uint64_t signature) {
    return at <= file.size() && file.size() - at >= bytes && little_endian(file, at, 4) == signature;
}

/// Where the record lies that ends the archive: the last whose comment reaches the end of the file, or else
/// the last whose comment lies within it.
std::optional<std::size_t> find_end(Bytes file) {
    constexpr std::size_t kFarthest = 1 << 17;  // a comment of 64 KiB, and as much behind the archive
    std::optional<std::size_t> loose;
    for (std::size_t back = kEndBytes; back <= file.size() && back <= kFarthest; ++back) {
        const std::size_t at = file.size() - back;
        if (!has(file, at, kEndBytes, kEnd)) continue;
        const std::uint64_t comment = little_endian(file, at + 20, 2);
        if (comment + kEndBytes == back) return at;
        if (!loose && comment + kEndBytes < back) loose = at;
    }
    return loose;
}

/// The directory's place and size as the archive's end tells them.
struct Directory {
    std::uint64_t begin = 0;  // as written: from the beginning of the archive, not of the file
    std::uint64_t size = 0;
    std::uint64_t end = 0;  // in the file: where the records of the end begin
};

/// Where the zip64 record lies, if the archive has one.
std::optional<std::uint64_t> find_end64(Bytes file, std::size_t end) {
    if (end < kLocatorBytes || !has(file, end - kLocatorBytes, kLocatorBytes, kLocator64)) return {};
    const std::uint64_t named = little_endian(file, end - kLocatorBytes + 8, 8);
    if (has(file, named, kEnd64Bytes, kEnd64)) return named;
    // Bytes before the archive move it; then it lies right before what names it.
    const std::uint64_t before =
        end - kLocatorBytes - std::min<std::uint64_t>(kEnd64Bytes, end - kLocatorBytes);
    if (has(file, before, kEnd64Bytes, kEnd64)) return before;
    return {};
}

Result<Directory> find_directory(Bytes file) {
    const auto end = find_end(file);
    if (!end) return fail(ErrorKind::input, say("zip.no_directory"));
    Directory found{little_endian(file, *end + 16, 4), little_endian(file, *end + 12, 4), *end};
    std::uint64_t disk = little_endian(file, *end + 4, 2);
    const bool wants64 = found.begin == kInZip64 || found.size == kInZip64 ||
                         little_endian(file, *end + 10, 2) == kCountInZip64 || disk == kCountInZip64;
    const auto end64 = find_end64(file, *end);
    if (wants64 && end64) {
        found = {little_endian(file, *end64 + 48, 8), little_endian(file, *end64 + 40, 8), *end64};
        disk = little_endian(file, *end64 + 16, 4);
    } else if (end64) {
        found.end = *end64;
    }
    if (disk != 0) return fail(ErrorKind::input, say("zip.several_parts"));
    if (found.size > found.end) return damaged(say("zip.long_directory"));
    return found;
}

/// Reads the directory's entries one after the other.
class Entries {
  public:
    Entries(Bytes file, const Directory& directory) : file_(file) {
        const std::uint64_t last = directory.end - directory.size;
        // Where the directory does not lie where it is said to, bytes stand before the archive.
        at_ = directory.size == 0 || has(file, directory.begin, kEntryBytes, kEntry) ? directory.begin : last;
        if (directory.begin > last) at_ = last;
        shift_ = at_ > directory.begin ? at_ - directory.begin : 0;
        end_ = at_ + directory.size;
    }

    [[nodiscard]] bool done() const { return at_ >= end_; }
    [[nodiscard]] std::uint64_t begin() const { return at_; }
    [[nodiscard]] std::uint64_t end() const { return end_; }

    Result<ZipMember> next() {
        if (!has(file_, at_, kEntryBytes, kEntry)) return damaged(say("zip.no_entry"));
        const std::uint64_t name = field(28, 2), extra = field(30, 2), comment = field(32, 2);
        const std::uint64_t bytes = kEntryBytes + name + extra + comment;
        if (end_ - at_ < bytes) return damaged(say("zip.cut_entry"));
        ZipMember member;
        const Bytes text = part_of(file_, at_ + kEntryBytes, name);
        member.name = zip_name({reinterpret_cast<const char*>(text.data()), text.size()});
        const std::uint64_t flags = field(8, 2);
        member.encrypted = (flags & 1) != 0;
        member.method = static_cast<std::uint16_t>(field(10, 2));
        member.checksum = static_cast<std::uint32_t>(field(16, 4));
        member.packed = field(20, 4);
        member.size = field(24, 4);
        member.begin = field(42, 4);
        if (!take_zip64(part_of(file_, at_ + kEntryBytes + name, extra), member))
            return damaged(say("zip.no_size", {{"name", quoted(member.name)}}));
        if (auto found = find_data(member); !found) return tl::unexpected(found.error());
        at_ += bytes;
        return member;
    }

  private:
    [[nodiscard]] std::uint64_t field(std::size_t offset, int bytes) const {
        return little_endian(file_, at_ + offset, bytes);
    }

    /// Fields that are too small for their number have it in extra field 1, one after the other.
    static bool take_zip64(Bytes extra, ZipMember& member) {
        std::uint64_t* const fields[] = {&member.size, &member.packed, &member.begin};
        if (std::none_of(std::begin(fields), std::end(fields),
                         [](auto* field) { return *field == kInZip64; }))
            return true;
        while (extra.size() >= 4) {
            const std::uint64_t id = little_endian(extra, 0, 2), size = little_endian(extra, 2, 2);
            if (extra.size() - 4 < size) break;
            if (id == 1) {
                Bytes values = part_of(extra, 4, size);
                for (std::uint64_t* field : fields) {
                    if (*field != kInZip64) continue;
                    if (values.size() < 8) return false;
                    *field = little_endian(values, 0, 8);
                    values = values.subspan(8);
                }
                return true;
            }
            extra = part_of(extra, 4 + size, extra.size() - 4 - size);
        }
        return true;  // exactly that number
    }

    /// From the member's own header to its data.
    Result<void> find_data(ZipMember& member) const {
        const auto wrong = [&] { return damaged(say("zip.not_there", {{"name", quoted(member.name)}})); };
        if (member.begin > file_.size()) return wrong();
        const std::uint64_t header = member.begin + shift_;
        if (!has(file_, header, kMemberBytes, kMember)) return wrong();
        member.begin = header + kMemberBytes + little_endian(file_, header + 26, 2) +
                       little_endian(file_, header + 28, 2);
        if (member.begin > file_.size() || file_.size() - member.begin < member.packed)
            return damaged(say("zip.beyond_end", {{"name", quoted(member.name)}}));
        return {};
    }

    Bytes file_;
    std::uint64_t at_, end_, shift_;
};

Result<void> refuse_shared_bytes(const std::vector<ZipMember>& members, const Entries& directory) {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges{{directory.begin(), directory.end()}};
    for (const ZipMember& member : members)
        ranges.push_back({member.begin - kMemberBytes, member.begin + member.packed});
    std::sort(ranges.begin(), ranges.end());
    for (std::size_t i = 1; i < ranges.size(); ++i)
        if (ranges[i].first < ranges[i - 1].second) return fail(ErrorKind::input, say("zip.shared_bytes"));
    return {};
}

}  // namespace

Result<std::vector<ZipMember>> zip_directory(Bytes file) {
    const auto directory = find_directory(file);
    if (!directory) return tl::unexpected(directory.error());
    Entries entries(file, *directory);
    const Entries first = entries;
    std::vector<ZipMember> members;
    while (!entries.done()) {
        auto member = entries.next();
        if (!member) return tl::unexpected(member.error());
        members.push_back(std::move(*member));
    }
    if (auto good = refuse_shared_bytes(members, first); !good) return tl::unexpected(good.error());
    return members;
}

}  // namespace snug

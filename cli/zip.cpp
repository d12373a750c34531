#include "cli/zip.h"

#include <memory>
#include <zip.h>

#include <fmt/core.h>

#include "snug/words/words.h"

namespace snug::cli {
namespace {

struct CloseError {
    zip_error_t error{};
    CloseError() { zip_error_init(&error); }
    ~CloseError() { zip_error_fini(&error); }
    CloseError(const CloseError&) = delete;
    CloseError& operator=(const CloseError&) = delete;
};

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Release {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};

tl::unexpected<Error> cannot_pack(const PackContainer& container, const char* why) {
    return fail(ErrorKind::output, in_file(container.name, say("zip.not_packed", {{"why", why}})));
}

/// False where the archive refuses; it then knows why.
bool add(zip_t* archive, const PackFile& member) {
    zip_source_t* source = zip_source_buffer(archive, member.bytes.data(), member.bytes.size(), 0);
    if (!source) return false;
    const zip_int64_t index = zip_file_add(archive, member.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return false;
    }
    const auto at = static_cast<zip_uint64_t>(index);
    constexpr zip_uint16_t kNoTime = 0, kFirstDay = (1 << 5) | 1;  // 1 January 1980
    return zip_file_set_dostime(archive, at, kNoTime, kFirstDay, 0) == 0 &&
           zip_set_file_compression(archive, at, ZIP_CM_DEFLATE, 9) == 0;
}

/// What the archive's buffer holds once it is closed.
Result<FileBytes> contents(const PackContainer& container, zip_source_t* source) {
    if (zip_source_open(source) != 0) return cannot_pack(container, "its buffer cannot be opened");
    zip_stat_t status;
    zip_stat_init(&status);
    FileBytes bytes;
    if (zip_source_stat(source, &status) == 0) bytes.resize(status.size);
    const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (bytes.empty() || count != static_cast<zip_int64_t>(bytes.size()))
        return cannot_pack(container, "its buffer cannot be read");
    return bytes;
}

}  // namespace

Result<FileBytes> write_zip(const PackContainer& container) {
    CloseError error;
    const std::unique_ptr<zip_source_t, Release> buffer(
        zip_source_buffer_create(nullptr, 0, 0, &error.error));
    if (!buffer) return cannot_pack(container, zip_error_strerror(&error.error));
    // The archive lets go of its source when it closes; one more hold keeps the bytes.
    zip_source_keep(buffer.get());
    std::unique_ptr<zip_t, Discard> archive(
        zip_open_from_source(buffer.get(), ZIP_CREATE | ZIP_TRUNCATE, &error.error));
    if (!archive) {
        zip_source_free(buffer.get());
        return cannot_pack(container, zip_error_strerror(&error.error));
    }
    for (const PackFile& member : container.members)
        if (!add(archive.get(), member)) return cannot_pack(container, zip_strerror(archive.get()));
    if (zip_close(archive.get()) != 0) return cannot_pack(container, zip_strerror(archive.get()));
    archive.release();
    return contents(container, buffer.get());
}

}  // namespace snug::cli

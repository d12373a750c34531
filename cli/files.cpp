#include "cli/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/core.h>

#include "snug/formats/text_scan.h"
#include "snug/words/words.h"

#include "cli/descriptor.h"
#include "cli/interrupt.h"
#include "cli/sha256.h"
#include "cli/system_error.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> cannot_write(const fs::path& path, int error) {
    return fail(ErrorKind::output,
                say("file.unwritable", {{"file", path.string()}, {"reason", reason(error)}}));
}

/// Gives 0 or the error number.
int write_all(int fd, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(fd, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 24));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        if (InterruptGuard::interrupted()) return ECANCELED;
    }
    return 0;
}

}  // namespace

Result<std::vector<std::byte>> read_file(const fs::path& path) {
    const auto refuse = [&](Message why) {
        return fail(ErrorKind::input, in_file(path.string(), std::move(why)));
    };
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.ok()) return refuse(errno == ENOENT ? say("file.none") : cannot_be_read(errno));
    struct stat status {};
    if (fstat(file.get(), &status) != 0) return refuse(cannot_be_read(errno));
    if (S_ISDIR(status.st_mode)) return refuse(say("file.is_folder"));

    std::vector<std::byte> bytes;
    std::size_t used = 0;
    // One byte more than the size, so that the end of a regular file is seen without growing.
    bytes.resize(S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : 1 << 16);
    for (;;) {
        const ssize_t count = ::read(file.get(), bytes.data() + used, bytes.size() - used);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return refuse(cannot_be_read(errno));
        if (count == 0) break;
        used += static_cast<std::size_t>(count);
        if (used == bytes.size()) bytes.resize(bytes.size() * 2);
    }
    // Some formats read well up to any line: what is missing would be missing from the object.
    if (S_ISREG(status.st_mode) && used < static_cast<std::size_t>(status.st_size))
        return refuse(say("file.shrank"));
    bytes.resize(used);
    return bytes;
}

ObjectFile describe(const fs::path& path, std::span<const std::byte> bytes) {
    constexpr std::size_t kMostOfShape = 100'000;
    ObjectFile file{path.filename().string(), bytes.size(), sha256(bytes)};
    if (same_word(path.extension().string(), ".shape") && bytes.size() <= kMostOfShape)
        file.shape.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return file;
}

FileSet::~FileSet() {
    if (committed_) return;
    std::error_code ignored;
    for (const Pending& file : pending_) fs::remove(file.temporary, ignored);
    for (auto folder = made_folders_.rbegin(); folder != made_folders_.rend(); ++folder)
        fs::remove(*folder, ignored);
}

std::string FileSet::temporary_name(const std::string& name) {
    return fmt::format(".{}.{}.part", name, ::getpid());
}

Result<void> FileSet::open() {
    return make_folder(folder_);
}

Result<void> FileSet::make_folder(const fs::path& folder) {
    std::vector<fs::path> missing;
    std::error_code error;
    for (fs::path at = fs::absolute(folder, error).lexically_normal(); !fs::exists(at, error);) {
        if (at.has_filename()) missing.push_back(at);
        if (at == at.parent_path()) break;
        at = at.parent_path();
    }
    for (auto next = missing.rbegin(); next != missing.rend(); ++next) {
        const bool made = fs::create_directory(*next, error);
        if (error) return cannot_write(folder, error.value());
        if (made) made_folders_.push_back(*next);  // otherwise another run was faster
    }
    if (!fs::is_directory(folder, error)) return cannot_write(folder, ENOTDIR);
    return {};
}

Result<void> FileSet::write(const std::string& name, std::span<const std::byte> bytes) {
    const fs::path final = folder_ / name;
    std::error_code ignored;
    if (fs::is_directory(final, ignored)) return cannot_write(final, EISDIR);
    if (final.parent_path() != folder_)
        if (auto done = make_folder(final.parent_path()); !done) return done;
    const fs::path temporary = final.parent_path() / temporary_name(final.filename().string());
    // What a killed run with the same number left, or a link to somewhere else, is not written through.
    ::unlink(temporary.c_str());
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.ok()) return cannot_write(final, errno);
    pending_.push_back({temporary, final});
    int error = write_all(file.get(), bytes);
    if (error == 0 && ::fsync(file.get()) != 0 && errno != EINVAL) error = errno;
    if (!file.close() && error == 0) error = errno;
    if (error == ECANCELED || InterruptGuard::interrupted())
        return fail(ErrorKind::cancelled, say("cancelled.nothing_written"));
    if (error != 0) return cannot_write(final, error);
    return {};
}

Result<void> FileSet::commit() {
    for (const Pending& file : pending_) {
        if (::rename(file.temporary.c_str(), file.final.c_str()) != 0) return cannot_write(file.final, errno);
        ++renamed_;
    }
    committed_ = true;
    return {};
}

Result<void> write_file(const fs::path& path, std::span<const std::byte> bytes) {
    const InterruptGuard guard;
    FileSet set(path.has_parent_path() ? path.parent_path() : fs::path("."));
    std::error_code error;
    if (path.has_parent_path() && !fs::is_directory(path.parent_path(), error))
        return fail(ErrorKind::output, say("file.no_folder", {{"file", path.string()},
                                                              {"folder", path.parent_path().string()}}));
    if (auto done = set.write(path.filename().string(), bytes); !done) return done;
    return set.commit();
}

}  // namespace snug::cli

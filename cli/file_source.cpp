#include "cli/file_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/core.h>

#include "snug/words/words.h"

#include "cli/descriptor.h"
#include "cli/system_error.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kShareOfMemory = 4;  // a quarter

/// At most this much is asked of the system at a time; more is cut by it anyway.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;

}  // namespace

Result<ByteSource> open_source(const fs::path& path) {
    const auto refuse = [name = path.string()](Message why) {
        return fail(ErrorKind::input, in_file(name, std::move(why)));
    };
    const auto file = std::make_shared<const Descriptor>(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file->ok()) return refuse(errno == ENOENT ? say("file.none") : cannot_be_read(errno));
    struct stat status {};
    if (fstat(file->get(), &status) != 0) return refuse(cannot_be_read(errno));
    if (S_ISDIR(status.st_mode)) return refuse(say("file.is_folder"));
    if (!S_ISREG(status.st_mode)) return refuse(say("file.not_regular"));
    (void)::posix_fadvise(file->get(), 0, 0, POSIX_FADV_SEQUENTIAL);

    ByteSource source;
    source.size = static_cast<std::uint64_t>(status.st_size);
    source.read = [file](std::uint64_t at, std::span<std::byte> into) -> Result<void> {
        while (!into.empty()) {
            const ssize_t count =
                ::pread(file->get(), into.data(), std::min(into.size(), kMostAtOnce), static_cast<off_t>(at));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) return fail(ErrorKind::input, cannot_be_read(errno));
            if (count == 0) return fail(ErrorKind::input, say("file.shrank"));
            into = into.subspan(static_cast<std::size_t>(count));
            at += static_cast<std::uint64_t>(count);
        }
        return {};
    };
    return source;
}

bool too_large_for_memory(std::uint64_t bytes) {
    const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page <= 0) return false;
    std::uint64_t memory = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        memory = std::min<std::uint64_t>(memory, limit.rlim_cur);
    return bytes > memory / kShareOfMemory;
}

}  // namespace snug::cli

#include "cli/folder_inside.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include <fmt/core.h>

#include "cli/interrupt.h"
#include "cli/sha256.h"
#include "cli/system_error.h"

namespace snug::cli {
namespace {

constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

/// The number of the process that wrote `.NAME.PID.part`; none for any other name.
std::optional<pid_t> writer_of(std::string_view name) {
    constexpr std::string_view kEnd = ".part";
    if (name.size() <= kEnd.size() || name.front() != '.' || name.substr(name.size() - kEnd.size()) != kEnd)
        return {};
    name.remove_suffix(kEnd.size());
    const std::size_t dot = name.rfind('.');
    if (dot < 2) return {};  // NAME is not empty
    const char *begin = name.data() + dot + 1, *end = name.data() + name.size();
    pid_t pid = 0;
    const auto [rest, error] = std::from_chars(begin, end, pid);
    if (begin == end || rest != end || error != std::errc() || pid <= 0) return {};
    return pid;
}

bool lives(pid_t pid) {
    return ::kill(pid, 0) == 0 || errno != ESRCH;
}

}  // namespace

Result<FolderInside> FolderInside::open(const std::filesystem::path& folder) {
    Descriptor root(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!root.ok())
        return fail(ErrorKind::output,
                    say("folder.unreadable", {{"folder", folder.string()}, {"reason", reason(errno)}}));
    return FolderInside(std::move(root), folder);
}

Result<void> FolderInside::lock(double seconds) {
    constexpr double kPause = 0.02;  // seconds
    while (::flock(root_.get(), LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR) return {};
        if (InterruptGuard::interrupted())
            return fail(ErrorKind::cancelled, say("cancelled.nothing_written"));
        if ((seconds -= kPause) < 0)
            return fail(ErrorKind::output, say("folder.busy", {{"folder", path_.string()}}));
        ::usleep(static_cast<useconds_t>(kPause * 1e6));
    }
    return {};
}

/// The folder that holds `name`, which becomes the last part of itself.
Descriptor FolderInside::folder_of(std::string_view& name) const {
    Descriptor at(::openat(root_.get(), ".", kFolder));
    for (std::size_t slash = name.find('/'); slash != std::string_view::npos && at.ok();
         slash = name.find('/')) {
        const std::string part(name.substr(0, slash));
        at = Descriptor(::openat(at.get(), part.c_str(), kFolder));
        name.remove_prefix(slash + 1);
    }
    return at;
}

FolderInside::Found FolderInside::find(const std::string& name) const {
    std::string_view leaf = name;
    const Descriptor folder = folder_of(leaf);
    struct stat status {};
    if (!folder.ok()) return {errno == ENOENT ? State::missing : State::other};
    if (::fstatat(folder.get(), std::string(leaf).c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return {errno == ENOENT ? State::missing : State::other};
    if (!S_ISREG(status.st_mode)) return {State::other};
    return {State::file, static_cast<std::uint64_t>(status.st_size),
            ::faccessat(folder.get(), ".", W_OK | X_OK, AT_EACCESS) == 0,
            static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

Descriptor FolderInside::file(const std::string& name) const {
    std::string_view leaf = name;
    const Descriptor folder = folder_of(leaf);
    if (!folder.ok()) return Descriptor(-1);
    Descriptor file(
        ::openat(folder.get(), std::string(leaf).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!file.ok() || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return Descriptor(-1);
    return file;
}

std::optional<std::string> FolderInside::read(const std::string& name, std::uint64_t most) const {
    const Descriptor from = file(name);
    if (!from.ok()) return {};
    std::string text;
    char part[1 << 14];
    for (;;) {
        const ssize_t count = ::read(from.get(), part, sizeof part);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 || text.size() + static_cast<std::size_t>(count) > most) return {};
        if (count == 0) return text;
        text.append(part, static_cast<std::size_t>(count));
    }
}

std::optional<std::string> FolderInside::sha256(const std::string& name) const {
    const Descriptor from = file(name);
    if (!from.ok()) return {};
    Sha256 hash;
    const auto part = std::make_unique<std::byte[]>(1 << 20);
    for (;;) {
        const ssize_t count = ::read(from.get(), part.get(), 1 << 20);
        if (InterruptGuard::interrupted()) return {};
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return {};
        if (count == 0) break;
        hash.add({part.get(), static_cast<std::size_t>(count)});
    }
    return hash.digits();
}

std::vector<std::string> FolderInside::leftovers(const std::string& folder,
                                                 const std::vector<std::string>& own) const {
    const std::string within = folder.empty() ? "" : folder + "/";
    std::string_view none = within;
    Descriptor at = folder_of(none);
    if (!at.ok()) return {};
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(::fdopendir(at.get()), ::closedir);
    if (!entries) return {};
    (void)at.release();  // it is closed with `entries`
    std::vector<std::string> names;
    while (const dirent* entry = ::readdir(entries.get())) {
        const auto writer = writer_of(entry->d_name);
        if (!writer) continue;
        const std::string name = within + entry->d_name;
        const bool mine = *writer == ::getpid();
        if (mine ? std::find(own.begin(), own.end(), name) != own.end() : lives(*writer)) continue;
        if (find(name).state == State::file) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::optional<std::string> FolderInside::link_as_old(const std::string& name) const {
    constexpr int kMost = 1000;
    std::string_view leaf = name;
    const Descriptor folder = folder_of(leaf);
    if (!folder.ok()) return {};
    const std::string from(leaf), within = name.substr(0, name.size() - leaf.size());
    for (int i = 1; i <= kMost; ++i) {
        const std::string to = from + ".old" + (i > 1 ? std::to_string(i) : "");
        if (::linkat(folder.get(), from.c_str(), folder.get(), to.c_str(), 0) == 0) return within + to;
        if (errno != EEXIST) return {};
    }
    return {};
}

int FolderInside::remove_file(const std::string& name) const {
    std::string_view leaf = name;
    const Descriptor folder = folder_of(leaf);
    if (!folder.ok()) return errno == ENOENT ? 0 : errno;
    return ::unlinkat(folder.get(), std::string(leaf).c_str(), 0) == 0 || errno == ENOENT ? 0 : errno;
}

void FolderInside::remove_if_empty(const std::string& folder) const {
    std::string_view leaf = folder;
    const Descriptor above = folder_of(leaf);
    if (above.ok()) (void)::unlinkat(above.get(), std::string(leaf).c_str(), AT_REMOVEDIR);
}

}  // namespace snug::cli

// A disk that fails, for a program that is started with this library in LD_PRELOAD. Reading the file
// $FAILING_FILE beyond the byte $FAILS_AT is an input/output error; with $SHRINKS set the file loses what
// lies there, as it is read.

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <dlfcn.h>
#include <string>
#include <sys/types.h>
#include <unistd.h>

#include <climits>

namespace {

bool is_failing_file(int fd) {
    const char* const wanted = std::getenv("FAILING_FILE");
    char path[PATH_MAX];
    const ssize_t length = ::readlink(("/proc/self/fd/" + std::to_string(fd)).c_str(), path, sizeof path);
    return wanted != nullptr && length > 0 && std::string(path, static_cast<std::size_t>(length)) == wanted;
}

/// Whether the read fails; the file may be shorter now.
bool fails(int fd, off_t end) {
    const off_t at = std::atoll(std::getenv("FAILS_AT"));
    if (end <= at) return false;
    if (std::getenv("SHRINKS") != nullptr) return ::truncate(std::getenv("FAILING_FILE"), at) != 0;
    errno = EIO;
    return true;
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" ssize_t read(int fd, void* into, std::size_t size) {
    if (is_failing_file(fd) && fails(fd, ::lseek(fd, 0, SEEK_CUR) + static_cast<off_t>(size))) return -1;
    return next<ssize_t (*)(int, void*, std::size_t)>("read")(fd, into, size);
}

extern "C" ssize_t pread(int fd, void* into, std::size_t size, off_t at) {
    if (is_failing_file(fd) && fails(fd, at + static_cast<off_t>(size))) return -1;
    return next<ssize_t (*)(int, void*, std::size_t, off_t)>("pread")(fd, into, size, at);
}

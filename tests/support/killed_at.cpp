// A program that is started with this library in LD_PRELOAD is killed before its KILLED_AT-th change to a
// folder: a file that it makes, renames or takes away, a folder that it makes or takes away. With $COUNTED
// set it runs to its end, and the number of changes stands in that file.

#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

std::atomic<long> changes{0};

void change() {
    const char* const at = std::getenv("KILLED_AT");
    if (++changes == (at ? std::atol(at) : -1)) ::raise(SIGKILL);
}

struct Count {
    ~Count() {
        const char* const path = std::getenv("COUNTED");
        if (std::FILE* file = path ? std::fopen(path, "w") : nullptr) {
            std::fprintf(file, "%ld", changes.load());
            std::fclose(file);
        }
    }
} count;

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int open(const char* path, int flags, ...) {
    mode_t mode = 0;
    if (flags & O_CREAT) {
        std::va_list rest;
        va_start(rest, flags);
        mode = va_arg(rest, mode_t);
        va_end(rest);
        change();
    }
    return next<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}

extern "C" int rename(const char* from, const char* to) noexcept {
    change();
    return next<int (*)(const char*, const char*)>("rename")(from, to);
}

extern "C" int mkdir(const char* path, mode_t mode) noexcept {
    change();
    return next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

extern "C" int unlinkat(int folder, const char* path, int flags) noexcept {
    change();
    return next<int (*)(int, const char*, int)>("unlinkat")(folder, path, flags);
}

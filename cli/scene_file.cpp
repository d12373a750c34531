#include "cli/scene_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "snug/formats/bundle.h"
#include "snug/formats/zip_read.h"
#include "snug/mesh/read_cloud.h"

#include "cli/assimp_scene.h"
#include "cli/descriptor.h"
#include "cli/inflate.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kMostSeconds = 600;  // of a scene's reader

std::optional<SceneFormat> scene_format(Bytes file, const fs::path& path) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    if (text.substr(0, 4) == "glTF") return SceneFormat::glb;
    if (text.substr(0, 4) == "PK\x03\x04" && ending == ".3mf") return SceneFormat::threemf;
    if (ending == ".gltf") return SceneFormat::gltf;
    return {};
}

bool write_whole(int to, const void* from, std::size_t size) {
    const char* at = static_cast<const char*>(from);
    while (size > 0) {
        const ssize_t count = ::write(to, at, size);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        at += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

bool read_whole(int from, void* to, std::size_t size) {
    char* at = static_cast<char*>(to);
    while (size > 0) {
        const ssize_t count = ::read(from, at, size);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        at += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

/// What goes through the pipe before the arrays.
struct Head {
    std::uint64_t vertices = 0, triangles = 0, message = 0;
    Vec3d origin;
};

template <class T>
bool write_array(int to, const std::vector<T>& values) {
    return write_whole(to, values.data(), values.size() * sizeof(T));
}

template <class T>
bool read_array(int from, std::uint64_t count, std::vector<T>& values) {
    values.resize(static_cast<std::size_t>(count));
    return read_whole(from, values.data(), values.size() * sizeof(T));
}

/// In the child. Never returns.
[[noreturn]] void tell(int pipe, const Result<Mesh>& mesh) {
    bool good = false;
    if (mesh) {
        const Head head{mesh->vertices.size(), mesh->triangles.size(), 0, mesh->origin};
        good = write_whole(pipe, &head, sizeof head) && write_array(pipe, mesh->vertices) &&
               write_array(pipe, mesh->triangles);
    } else {
        const std::string& message = mesh.error().message;
        const Head head{0, 0, message.size(), {}};
        good = write_whole(pipe, &head, sizeof head) && write_whole(pipe, message.data(), message.size());
    }
    ::_exit(good ? 0 : 1);
}

/// What the child told; none where it died before it was done.
std::optional<Result<Mesh>> hear(int pipe) {
    Head head;
    if (!read_whole(pipe, &head, sizeof head)) return {};
    if (head.message > 0) {
        std::string message(static_cast<std::size_t>(head.message), ' ');
        if (!read_whole(pipe, message.data(), message.size())) return {};
        return fail(ErrorKind::input, message);
    }
    Mesh mesh;
    mesh.origin = head.origin;
    if (!read_array(pipe, head.vertices, mesh.vertices) || !read_array(pipe, head.triangles, mesh.triangles))
        return {};
    return mesh;
}

Result<Mesh> read_in_a_process(Bytes file, SceneFormat format, const fs::path& path) {
    int ends[2];
    if (::pipe(ends) != 0)
        return fail(ErrorKind::input, std::string("cannot be read (") + std::strerror(errno) + ")");
    const Descriptor reading(ends[0]);
    Descriptor writing(ends[1]);
    const pid_t child = ::fork();
    if (child < 0)
        return fail(ErrorKind::input, std::string("cannot be read (") + std::strerror(errno) + ")");
    if (child == 0) {
        const rlimit none{0, 0}, seconds{kMostSeconds, kMostSeconds};
        (void)::setrlimit(RLIMIT_CORE, &none);
        (void)::setrlimit(RLIMIT_CPU, &seconds);
        try {
            tell(ends[1], read_scene_here(file, format, path));
        } catch (...) {
            ::_exit(1);
        }
    }
    (void)writing.close();
    auto mesh = hear(reading.get());
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (mesh) return std::move(*mesh);
    return fail(ErrorKind::input,
                "it is damaged or has more than its reader can take: export it again, or as STL or PLY");
}

}  // namespace

Result<Mesh> read_object(Bytes file, const fs::path& path) {
    if (is_zip(file)) {
        SceneTools tools;
        tools.inflate = inflate;
        return read_zip(file, tools, [](Bytes inner, std::string_view name, const SceneTools&) {
            return read_object(inner, fs::path(name));
        });
    }
    if (const auto format = scene_format(file, path)) return read_in_a_process(file, *format, path);
    return read_mesh_or_cloud(file, path.string());
}

}  // namespace snug::cli

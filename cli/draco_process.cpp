#include "cli/draco_process.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <draco/compression/decode.h>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "cli/descriptor.h"
#include "cli/system_error.h"

namespace snug::cli {
namespace {

constexpr rlim_t kMostSeconds = 600;
constexpr rlim_t kMemory = rlim_t{1} << 30, kMemoryPerByte = 1000;

/// Floats as they are, whole numbers without the scale that they may stand for.
bool values_of(const draco::Mesh& mesh, const DracoAttribute& asked, std::vector<float>& values) {
    const draco::PointAttribute* attribute =
        mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(asked.id));
    if (attribute == nullptr || attribute->num_components() != asked.components || asked.components > 4)
        return false;
    const bool real =
        attribute->data_type() == draco::DT_FLOAT32 || attribute->data_type() == draco::DT_FLOAT64;
    const auto components = static_cast<std::int8_t>(asked.components);
    values.reserve(static_cast<std::size_t>(mesh.num_points()) * static_cast<std::size_t>(asked.components));
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
        const draco::AttributeValueIndex at = attribute->mapped_index(point);
        float reals[4]{};
        std::int32_t wholes[4]{};
        if (real ? !attribute->ConvertValue<float>(at, components, reals)
                 : !attribute->ConvertValue<std::int32_t>(at, components, wholes))
            return false;
        for (int c = 0; c < asked.components; ++c)
            values.push_back(real ? reals[c] : static_cast<float>(wholes[c]));
    }
    return true;
}

std::optional<DracoMesh> unpack(Bytes packed, std::span<const DracoAttribute> attributes) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(packed.data()), packed.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) return {};
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    DracoMesh result;
    for (const DracoAttribute& asked : attributes)
        if (!values_of(*mesh, asked, result.attributes.emplace_back())) return {};
    result.corners.reserve(3 * static_cast<std::size_t>(mesh->num_faces()));
    for (draco::FaceIndex face(0); face < mesh->num_faces(); ++face)
        for (const draco::PointIndex& corner : mesh->face(face)) result.corners.push_back(corner.value());
    return result;
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

template <class T>
bool write_list(int to, const std::vector<T>& values) {
    const std::uint64_t count = values.size();
    return write_whole(to, &count, sizeof count) && write_whole(to, values.data(), count * sizeof(T));
}

template <class T>
bool read_list(int from, rlim_t most, std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!read_whole(from, &count, sizeof count) || count > most / sizeof(T)) return false;
    values.resize(static_cast<std::size_t>(count));
    return read_whole(from, values.data(), values.size() * sizeof(T));
}

rlim_t most_memory(Bytes packed) {
    return kMemory + kMemoryPerByte * packed.size();
}

/// What this process has already, which a child begins with.
rlim_t memory_now() {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

/// In the child. Never returns.
[[noreturn]] void tell(int pipe, Bytes packed, std::span<const DracoAttribute> attributes) {
    const rlimit none{0, 0}, seconds{kMostSeconds, kMostSeconds};
    (void)::setrlimit(RLIMIT_CORE, &none);
    (void)::setrlimit(RLIMIT_CPU, &seconds);
#ifndef __SANITIZE_ADDRESS__  // whose shadow is larger than any limit
    const rlim_t most = memory_now() + most_memory(packed);
    rlimit memory{};
    if (::getrlimit(RLIMIT_AS, &memory) == 0 && most < memory.rlim_cur) {
        memory.rlim_cur = most;
        (void)::setrlimit(RLIMIT_AS, &memory);
    }
#endif
    try {
        const auto mesh = unpack(packed, attributes);
        bool good = mesh.has_value();
        for (std::size_t i = 0; good && i < attributes.size(); ++i)
            good = write_list(pipe, mesh->attributes[i]);
        ::_exit(good && write_list(pipe, mesh->corners) ? 0 : 1);
    } catch (...) {
        ::_exit(1);
    }
}

}  // namespace

Result<DracoMesh> unpack_draco_in_a_process(Bytes packed, std::span<const DracoAttribute> attributes) {
    int ends[2];
    if (::pipe(ends) != 0) return fail(ErrorKind::input, cannot_be_read(errno));
    Descriptor reading(ends[0]);
    Descriptor writing(ends[1]);
    const pid_t child = ::fork();
    if (child < 0) return fail(ErrorKind::input, cannot_be_read(errno));
    if (child == 0) tell(ends[1], packed, attributes);
    (void)writing.close();
    DracoMesh mesh;
    mesh.attributes.resize(attributes.size());
    bool good = true;
    for (auto& values : mesh.attributes) good = good && read_list(reading.get(), most_memory(packed), values);
    good = good && read_list(reading.get(), most_memory(packed), mesh.corners);
    (void)reading.close();  // a child that still writes ends
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (good) return mesh;
    return fail(ErrorKind::input, say("draco.damaged"));
}

}  // namespace snug::cli

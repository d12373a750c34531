#include "snug/formats/gltf_meshopt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "snug/base/text.h"

// https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Vendor/EXT_meshopt_compression

namespace snug::gltf {
namespace {

struct Mode {
    std::string_view name;
    std::uint8_t header;          ///< the first byte of a packed view: codec and version
    std::uint64_t most_per_byte;  ///< bytes (elements of indices) that one packed byte can stand for
};
// Of vertices, a byte has the kinds of four groups of 16 bytes; of triangles, one has three corners.
constexpr std::array<Mode, 3> kModes = {
    {{"ATTRIBUTES", 0xA0, 64}, {"TRIANGLES", 0xE1, 3}, {"INDICES", 0xD1, 1}}};
constexpr std::uint64_t kMostStride = 256;

Result<MeshoptView> checked_view(Bytes packed, const Json& extension, const Mode& mode) {
    const auto count = whole(extension, "count", 0), stride = whole(extension, "byteStride", 0);
    if (!count) return tl::unexpected(count.error());
    if (!stride) return tl::unexpected(stride.error());
    const bool attributes = mode.name == "ATTRIBUTES";
    if (attributes ? *stride % 4 != 0 || *stride == 0 || *stride > kMostStride : *stride != 2 && *stride != 4)
        return refuse(say("meshopt.stride", {{"stride", *stride}}));
    const std::uint64_t most = mode.most_per_byte * packed.size() / (attributes ? *stride : 1);
    if (*count > most || (mode.name == "TRIANGLES" && *count % 3 != 0))
        return refuse(say("meshopt.too_many", {{"elements", *count}, {"bytes", packed.size()}}));
    return MeshoptView{static_cast<std::size_t>(*count), static_cast<std::size_t>(*stride),
                       std::string(mode.name)};
}

/// Each a whole number of 24 bits, times two to a power of 8.
void undo_exponential(FileBytes& bytes) {
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &bytes[at], 4);
        const int mantissa = static_cast<int>(bits << 8) >> 8;
        const int exponent = static_cast<std::int8_t>(bits >> 24);
        const float value = static_cast<float>(std::ldexp(static_cast<double>(mantissa), exponent));
        std::memcpy(&bytes[at], &value, 4);
    }
}

/// Three components of 16 bits below the greatest; the fourth word tells the scale and which one is greatest.
void undo_quaternion(FileBytes& bytes) {
    for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
        std::array<std::int16_t, 4> in{}, out{};
        std::memcpy(in.data(), &bytes[at], 8);
        const double scale = 1 / std::sqrt(2.0) / (in[3] | 3);
        std::array<double, 4> q{0, in[0] * scale, in[1] * scale, in[2] * scale};
        q[0] = std::sqrt(std::max(0.0, 1 - q[1] * q[1] - q[2] * q[2] - q[3] * q[3]));
        for (std::size_t i = 0; i < 4; ++i) {
            const double value = std::clamp(q[i] * 32767, -32767.0, 32767.0);
            out[(static_cast<std::size_t>(in[3]) + i) % 4] =
                static_cast<std::int16_t>(value + (value < 0 ? -0.5 : 0.5));
        }
        std::memcpy(&bytes[at], out.data(), 8);
    }
}

Result<void> undo_filter(FileBytes& bytes, const MeshoptView& view, const std::string& filter) {
    if (filter == "NONE") return {};
    if (filter == "EXPONENTIAL") {
        undo_exponential(bytes);
        return {};
    }
    if (filter == "QUATERNION" && view.stride == 8) {
        undo_quaternion(bytes);
        return {};
    }
    return refuse(say("meshopt.filter", {{"filter", snug::quoted(filter)}}));
}

}  // namespace

Result<FileBytes> unpack_meshopt(Bytes packed, const Json& extension, const SceneTools& tools) {
    const std::string name = text_of(extension, "mode");
    const auto mode =
        std::find_if(kModes.begin(), kModes.end(), [&](const Mode& m) { return m.name == name; });
    if (mode == kModes.end()) return refuse(say("meshopt.mode", {{"name", snug::quoted(name)}}));
    if (packed.empty() || std::to_integer<std::uint8_t>(packed[0]) != mode->header)
        return refuse(say("meshopt.newer"));
    const auto view = checked_view(packed, extension, *mode);
    if (!view) return tl::unexpected(view.error());
    if (!tools.meshopt) return refuse(say("meshopt.not_here"));
    auto bytes = tools.meshopt(packed, *view);
    if (!bytes) return bytes;
    if (bytes->size() != view->count * view->stride) return refuse(say("meshopt.damaged"));
    if (const auto done = undo_filter(*bytes, *view, text_of(extension, "filter", "NONE")); !done)
        return tl::unexpected(done.error());
    return bytes;
}

}  // namespace snug::gltf

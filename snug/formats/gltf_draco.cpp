#include "snug/formats/gltf_draco.h"

#include <algorithm>
#include <string_view>

namespace snug::gltf {
namespace {

constexpr std::string_view kDracoMagic = "DRACO";
constexpr std::size_t kDracoHeader = 11;  // magic, version, kind, method, flags
constexpr std::uint64_t kMostTrianglesPerByte = 1000;

std::uint8_t byte_at(Bytes bytes, std::size_t at) {
    return at < bytes.size() ? std::to_integer<std::uint8_t>(bytes[at]) : std::uint8_t{0};
}

std::uint64_t variable_length(Bytes bytes, std::size_t& at) {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
        const std::uint8_t byte = byte_at(bytes, at++);
        value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
        if (byte < 0x80) break;
    }
    return value;
}

}  // namespace

Result<void> check_draco(Bytes packed) {
    const std::string_view text(reinterpret_cast<const char*>(packed.data()), packed.size());
    if (text.size() < kDracoHeader || text.substr(0, kDracoMagic.size()) != kDracoMagic)
        return refuse(say("draco.damaged"));
    const int version = byte_at(packed, 5) * 256 + byte_at(packed, 6);
    if (byte_at(packed, 7) != 1) return refuse(say("draco.points"));
    const bool metadata = (byte_at(packed, 10) & 0x80) != 0;
    // glTF wants version 2.2, whose counts are of variable length; where they stand otherwise the decoder
    // looks.
    if (version != 0x202 || metadata) return {};
    std::size_t at = kDracoHeader;
    if (byte_at(packed, 8) == 1) {  // edgebreaker: its variant, then vertices before faces
        ++at;
        (void)variable_length(packed, at);
    }
    const std::uint64_t faces = variable_length(packed, at);
    if (faces <= kMostTrianglesPerByte * packed.size()) return {};
    return refuse(say("draco.too_many", {{"faces", faces}, {"bytes", packed.size()}}));
}

Result<const DracoMesh*> DracoMeshes::open(Buffers& buffers, std::uint64_t view,
                                           const std::vector<DracoAttribute>& attributes) {
    std::vector<std::uint64_t> key{view};
    for (const DracoAttribute& each : attributes) key.push_back(static_cast<std::uint64_t>(each.id));
    if (const auto known = known_.find(key); known != known_.end()) return &known->second;
    if (failed_) return tl::unexpected(*failed_);
    const auto packed = buffers.view(view);
    if (!packed) return tl::unexpected(packed.error());
    if (const auto good = check_draco(packed->bytes); !good) return tl::unexpected(good.error());
    auto mesh = decode(packed->bytes, attributes);
    if (!mesh) {
        failed_ = mesh.error();
        return tl::unexpected(*failed_);
    }
    return &known_.emplace(std::move(key), std::move(*mesh)).first->second;
}

Result<DracoMesh> DracoMeshes::decode(Bytes packed, const std::vector<DracoAttribute>& attributes) {
    if (!tools_.draco) return refuse(say("draco.not_here"));
    auto mesh = tools_.draco(packed, attributes);
    if (!mesh) return mesh;
    bool good = mesh->attributes.size() == attributes.size() && mesh->corners.size() % 3 == 0;
    const std::size_t points =
        good ? mesh->attributes[0].size() / static_cast<std::size_t>(attributes[0].components) : 0;
    for (std::size_t i = 0; good && i < attributes.size(); ++i)
        good = mesh->attributes[i].size() == points * static_cast<std::size_t>(attributes[i].components);
    good = good && std::all_of(mesh->corners.begin(), mesh->corners.end(),
                               [&](std::uint32_t corner) { return corner < points; });
    if (!good) return refuse(say("draco.damaged"));
    return mesh;
}

}  // namespace snug::gltf

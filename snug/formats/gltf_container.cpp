#include "snug/formats/gltf_container.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include "snug/base/text.h"

namespace snug::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

std::uint32_t word_at(Bytes file, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(file[at + i]) << (8 * i);
    return word;
}

bool chunk_at(Bytes file, std::size_t at, std::uint32_t type) {
    return at + kChunkHeader <= file.size() && word_at(file, at + 4) == type;
}

/// What the chunk holds; less than it says where the file is cut off, which those who read it see.
Bytes chunk_content(Bytes file, std::size_t at) {
    const Bytes rest = file.subspan(at + kChunkHeader);
    return rest.first(std::min<std::size_t>(rest.size(), word_at(file, at)));
}

Result<Container> open_glb(Bytes file) {
    if (file.size() < kHeader + kChunkHeader) return refuse(say("gltf.ends_early"));
    if (const auto version = word_at(file, 4); version != 2)
        return refuse(say("gltf.binary_version", {{"version", version}}));
    if (!chunk_at(file, kHeader, kJsonChunk)) return refuse(say("gltf.no_scene"));
    const std::size_t length = word_at(file, kHeader);
    const Bytes text = chunk_content(file, kHeader);
    if (text.size() < length) return refuse(say("gltf.ends_early"));
    auto json = parse_scene(text);
    if (!json) return tl::unexpected(json.error());
    const std::size_t next = kHeader + kChunkHeader + text.size();
    for (const std::size_t at : {next, (next + 3) / 4 * 4})
        if (chunk_at(file, at, kBinChunk)) return Container{std::move(*json), chunk_content(file, at)};
    return Container{std::move(*json), {}};
}

Result<void> check_version(const Json& json) {
    const std::string version = text_of(field(json, "asset"), "version", "2.0");
    if (version.substr(0, 1) == "2") return {};
    return refuse(say("gltf.version", {{"version", snug::quoted(version)}}));
}

}  // namespace

bool is_glb(Bytes file) {
    return file.size() >= 4 && word_at(file, 0) == kMagic;
}

Result<Container> open_container(Bytes file) {
    auto container = [&]() -> Result<Container> {
        if (is_glb(file)) return open_glb(file);
        auto json = parse_scene(file);
        if (!json) return tl::unexpected(json.error());
        return Container{std::move(*json), {}};
    }();
    if (!container) return container;
    if (const auto good = check_version(container->json); !good) return tl::unexpected(good.error());
    return container;
}

}  // namespace snug::gltf

#include "snug/formats/gltf_buffers.h"

#include <utility>

#include "snug/base/text.h"
#include "snug/formats/gltf_meshopt.h"
#include "snug/formats/gltf_uri.h"

namespace snug::gltf {
namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";
constexpr std::uint64_t kMostUnpackedPerByte = 64, kAlwaysUnpacked = 16'000'000;

constexpr std::uint64_t kAlwaysSteps = 100'000'000, kStepsPerByte = 200;

}  // namespace

Result<void> Buffers::spend(std::uint64_t steps) {
    spent_ += steps;
    if (spent_ <= kAlwaysSteps + kStepsPerByte * read_) return {};
    return refuse(say("gltf.repeats_parts"));
}

Result<View> Buffers::view(std::uint64_t index) {
    const Json& view = item(field(scene_, "bufferViews"), index);
    if (!view.is_object()) return refuse(say("gltf.no_view", {{"index", index}}));
    if (const Json& packed = extension(view, kMeshopt); packed.is_object()) {
        auto unpacked = packed_view(index, packed);
        if (unpacked || meshopt_required_) return unpacked;
        // Where it is not required, the same bytes may stand beside it as they are.
        const auto plain = slice(view);
        const auto stride = whole(view, "byteStride", 0);
        return plain && stride ? Result<View>(View{*plain, *stride}) : unpacked;
    }
    const auto bytes = slice(view);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto stride = whole(view, "byteStride", 0);
    if (!stride) return tl::unexpected(stride.error());
    return View{*bytes, *stride};
}

Result<View> Buffers::packed_view(std::uint64_t index, const Json& extension) {
    const auto stride = whole(extension, "byteStride", 0);
    if (!stride) return tl::unexpected(stride.error());
    auto known = unpacked_.find(index);
    if (known == unpacked_.end()) known = unpacked_.emplace(index, unpacked(extension)).first;
    if (!known->second) return tl::unexpected(known->second.error());
    return View{*known->second, *stride};
}

Result<FileBytes> Buffers::unpacked(const Json& extension) {
    const auto packed = slice(extension);
    if (!packed) return tl::unexpected(packed.error());
    const std::uint64_t most = kAlwaysUnpacked + kMostUnpackedPerByte * file_bytes_;
    auto bytes = unpacked_bytes_ <= most ? unpack_meshopt(*packed, extension, tools_) : FileBytes{};
    // One that fails may have taken as much time as it could.
    unpacked_bytes_ += bytes ? bytes->size() : kMostUnpackedPerByte * packed->size();
    if (unpacked_bytes_ > most) return refuse(say("meshopt.repeats_parts"));
    if (bytes) read_ += bytes->size();
    return bytes;
}

Result<Bytes> Buffers::slice(const Json& of) {
    const auto index = whole(of, "buffer", 0), offset = whole(of, "byteOffset", 0),
               length = whole(of, "byteLength", 0);
    for (const auto* number : {&index, &offset, &length})
        if (!*number) return tl::unexpected(number->error());
    const auto all = buffer(*index);
    if (!all) return all;
    if (*offset > all->size() || *length > all->size() - *offset)
        return refuse(say("gltf.short_buffer",
                          {{"index", *index}, {"bytes", all->size()}, {"wanted", *offset + *length}}));
    return all->subspan(static_cast<std::size_t>(*offset), static_cast<std::size_t>(*length));
}

Result<Bytes> Buffers::buffer(std::uint64_t index) {
    const auto known = known_.find(index);
    return known != known_.end() ? known->second : known_.emplace(index, find_buffer(index)).first->second;
}

Result<Bytes> Buffers::find_buffer(std::uint64_t index) {
    const Json& buffer = item(field(scene_, "buffers"), index);
    if (!buffer.is_object()) return refuse(say("gltf.no_buffer", {{"index", index}}));
    const Json& uri = field(buffer, "uri");
    if (uri.is_string()) {
        const std::string& text = uri.get_ref<const std::string&>();
        if (!is_data_uri(text)) return beside(text);
        auto data = data_of(text);
        if (!data) return refuse(say("gltf.damaged_text"));
        return Bytes(texts_.emplace(index, std::move(*data)).first->second);
    }
    if (index == 0 && !binary_.empty()) return binary_;
    if (extension(buffer, "KHR_meshopt_compression").is_object())
        return refuse(say("gltf.newer_meshopt", {{"extension", "KHR_meshopt_compression"}}));
    return refuse(say("gltf.buffer_nowhere", {{"index", index}}));
}

Result<Bytes> Buffers::beside(const std::string& uri) {
    if (const auto known = beside_.find(uri); known != beside_.end()) return Bytes(known->second);
    if (leads_elsewhere(uri)) return refuse(say("gltf.geometry_far", {{"uri", snug::quoted(uri, 60)}}));
    if (!tools_.beside) return refuse(say("gltf.geometry_beside", {{"uri", snug::quoted(uri, 60)}}));
    const std::string name = percent_decoded(uri);
    auto file = tools_.beside(name);
    // A name that really has a percent sign in it.
    if (!file && name != uri)
        if (auto raw = tools_.beside(uri)) file = std::move(raw);
    if (!file) return tl::unexpected(file.error());
    read_ += file->size();
    file_bytes_ += file->size();
    return Bytes(beside_.emplace(uri, std::move(*file)).first->second);
}

}  // namespace snug::gltf

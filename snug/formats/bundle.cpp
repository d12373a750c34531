#include "snug/formats/bundle.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/gltf_json.h"
#include "snug/formats/text_scan.h"
#include "snug/formats/threemf_read.h"
#include "snug/formats/zip_read.h"

namespace snug {
namespace {

constexpr std::array<std::string_view, 10> kEndings = {".stl",  ".obj", ".ply", ".off", ".glb",
                                                       ".gltf", ".3mf", ".xyz", ".pts", ".shape"};
constexpr std::string_view kProjectEnding = ".snug.json";
constexpr std::uint64_t kMostProjectBytes = 4'000'000;  // of all together: a pack has one, of a few thousand

bool is_longer_with_ending(std::string_view name, std::string_view lower) {
    return name.size() > lower.size() && same_word(name.substr(name.size() - lower.size()), lower);
}

std::string_view without_folders(std::string_view name) {
    return name.substr(name.rfind('/') + 1);
}

std::string folder_of(std::string_view name) {
    return std::string(name.substr(0, name.size() - without_folders(name).size()));
}

std::ptrdiff_t folders(std::string_view name) {
    return std::count(name.begin(), name.end(), '/');
}

bool is_hidden(std::string_view name) {
    return name.substr(0, 1) == "." || name.find("/.") != name.npos || name.find("__MACOSX/") != name.npos;
}

bool is_object(std::string_view name) {
    return !is_hidden(name) && std::any_of(kEndings.begin(), kEndings.end(), [&](std::string_view ending) {
        return is_longer_with_ending(name, ending);
    });
}

/// The member of that name; of equal names the last counts.
const ZipMember* find(const ZipReader& zip, std::string_view name) {
    const auto& members = zip.members();
    const auto found = std::find_if(members.rbegin(), members.rend(),
                                    [&](const ZipMember& member) { return member.name == name; });
    return found == members.rend() ? nullptr : &*found;
}

/// What a project calls its object; none where it is no project.
std::optional<std::string> object_in_project(const FileBytes& text) {
    const auto project = gltf::parse_scene(text);
    if (!project || gltf::field(*project, "snug").is_null()) return {};
    const gltf::Json& all = gltf::field(*project, "objects");
    const gltf::Json& object = gltf::count_of(all) > 0 ? all.front() : gltf::field(*project, "object");
    const gltf::Json& name = gltf::field(object, "name");
    if (!name.is_string()) return {};
    return std::string(without_folders(name.get_ref<const std::string&>()));
}

/// A pack's project, and its object where that is in the zip.
struct Packed {
    FileBytes text;
    std::string name;
    const ZipMember* object = nullptr;
};

/// The pack that Snug made, where the zip is one.
Result<std::optional<Packed>> find_packed(ZipReader& zip) {
    std::uint64_t read = 0;
    for (const ZipMember& member : zip.members()) {
        if (is_hidden(member.name) || !is_longer_with_ending(member.name, kProjectEnding)) continue;
        if (member.size > kMostProjectBytes - read) continue;
        read += member.size;
        auto text = zip.unpack(member);
        if (!text) return tl::unexpected(text.error());
        auto name = object_in_project(*text);
        if (!name) continue;
        const ZipMember* object = find(zip, folder_of(member.name) + *name);
        return Packed{std::move(*text), std::move(*name), object};
    }
    return std::nullopt;
}

}  // namespace

Result<BundleObject> find_bundle_object(const std::vector<std::string>& names) {
    BundleObject found{names.size(), {}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (is_object(names[i]) &&
            (found.file == names.size() || folders(names[i]) < folders(names[found.file])))
            found.file = i;
    if (found.file == names.size()) return fail(ErrorKind::input, say("bundle.no_object"));
    for (std::size_t i = 0; i < names.size(); ++i)
        if (i != found.file && is_object(names[i])) found.left_out.push_back(names[i]);
    return found;
}

namespace {

Result<Mesh> read_bundle(Bytes file, const SceneTools& tools, const ReadFile& read) {
    auto zip = ZipReader::open(file, tools.inflate);
    if (!zip) return tl::unexpected(zip.error());
    const auto packed = find_packed(*zip);
    if (!packed) return tl::unexpected(packed.error());
    const ZipMember* member = nullptr;
    std::vector<std::string> left_out;
    if (*packed) {
        member = (*packed)->object;
        if (member == nullptr)
            return fail(ErrorKind::input,
                        say("bundle.no_object_of", {{"name", quoted((*packed)->name, 80)}}));
    } else {
        std::vector<std::string> names;
        for (const ZipMember& each : zip->members()) names.push_back(each.name);
        auto object = find_bundle_object(names);
        if (!object) return tl::unexpected(object.error());
        member = &zip->members()[object->file];
        left_out = std::move(object->left_out);
    }
    const auto bytes = zip->unpack(*member);
    if (!bytes) return tl::unexpected(bytes.error());
    SceneTools inside = tools;
    inside.beside = [&](const std::string& name) -> Result<FileBytes> {
        if (const ZipMember* other = find(*zip, folder_of(member->name) + name)) return zip->unpack(*other);
        return fail(ErrorKind::input, say("bundle.geometry_elsewhere", {{"name", quoted(name, 80)}}));
    };
    auto mesh =
        is_zip(*bytes) ? read_3mf(*bytes, inside) : read(*bytes, without_folders(member->name), inside);
    if (!mesh)
        return fail(mesh.error().kind, say("bundle.member", {{"name", quoted(member->name, 80)},
                                                             {"problem", mesh.error().message}}));
    mesh->read.left_out_objects = std::move(left_out);
    return mesh;
}

}  // namespace

Result<std::optional<PackedProject>> find_packed_project(Bytes zip, const SceneTools& tools) {
    auto reader = ZipReader::open(zip, tools.inflate);
    if (!reader) return tl::unexpected(reader.error());
    auto packed = find_packed(*reader);
    if (!packed) return tl::unexpected(packed.error());
    if (!*packed) return std::nullopt;
    std::string text(reinterpret_cast<const char*>((*packed)->text.data()), (*packed)->text.size());
    return PackedProject{std::move(text), std::move((*packed)->name), (*packed)->object != nullptr};
}

Result<Mesh> read_zip(Bytes file, const SceneTools& tools, const ReadFile& read) {
    return is_3mf(file, tools) ? read_3mf(file, tools) : read_bundle(file, tools, read);
}

}  // namespace snug

#include "snug/formats/threemf_package.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/formats/xml_read.h"

namespace snug {
namespace {

constexpr std::string_view kRelationships = "_rels/.rels";
constexpr std::string_view kUsualModel = "3d/3dmodel.model";
constexpr std::string_view kModelType = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

std::string without_percents(std::string_view name) {
    std::string plain;
    for (std::size_t i = 0; i < name.size(); ++i) {
        unsigned value = 0;
        const char* const digits = name.data() + i + 1;
        if (name[i] == '%' && name.size() - i > 2 &&
            std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
            plain.push_back(static_cast<char>(value));
            i += 2;
        } else {
            plain.push_back(name[i]);
        }
    }
    return plain;
}

}  // namespace

std::string ThreeMfPackage::part_name(std::string_view written) {
    std::string name = without_percents(written);
    for (char& c : name) {
        if (c == '\\') c = '/';
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    std::string result;
    for (std::size_t at = 0; at <= name.size();) {
        const std::size_t slash = std::min(name.find('/', at), name.size());
        const std::string_view step = std::string_view(name).substr(at, slash - at);
        if (step == "..") {
            const std::size_t last = result.rfind('/');
            result.resize(last == std::string::npos ? 0 : last);
        } else if (!step.empty() && step != ".") {
            if (!result.empty()) result += '/';
            result += step;
        }
        at = slash + 1;
    }
    return result;
}

Result<ThreeMfPackage> ThreeMfPackage::open(Bytes file, const SceneTools& tools) {
    auto zip = ZipReader::open(file, tools.inflate);
    if (!zip) return tl::unexpected(zip.error());
    return ThreeMfPackage(std::move(*zip));
}

ThreeMfPackage::ThreeMfPackage(ZipReader zip) : zip_(std::move(zip)) {
    for (std::size_t i = 0; i < zip_.members().size(); ++i)
        if (const ZipMember& member = zip_.members()[i]; !member.is_folder())
            parts_[part_name(member.name)] = i;
}

Result<FileBytes> ThreeMfPackage::read(std::string_view part) {
    const auto found = parts_.find(part);
    if (found == parts_.end())
        return fail(ErrorKind::input, say("threemf.no_part", {{"part", quoted(part, 80)}}));
    return zip_.unpack(zip_.members()[found->second]);
}

Result<std::optional<std::string>> ThreeMfPackage::named_root() {
    std::optional<std::string> root;
    if (!has(kRelationships)) return root;
    const auto bytes = read(kRelationships);
    if (!bytes) return tl::unexpected(bytes.error());
    XmlReader xml(*bytes);
    for (;;) {
        const auto event = xml.next();
        if (!event)
            return fail(ErrorKind::input,
                        say("at_part", {{"part", kRelationships}, {"problem", event.error().message}}));
        if (*event == XmlEvent::done) return root;
        if (*event != XmlEvent::start || xml.name() != "Relationship") continue;
        if (xml.attribute("Type") != kModelType || xml.attribute("TargetMode") == "External") continue;
        const std::string target = part_name(xml.attribute("Target").value_or(""));
        if (has(target)) root = target;
    }
}

Result<std::optional<std::string>> ThreeMfPackage::root() {
    auto named = named_root();
    if (named && !*named && has(kUsualModel)) return std::optional<std::string>(kUsualModel);
    return named;
}

}  // namespace snug

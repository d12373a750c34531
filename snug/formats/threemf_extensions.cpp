#include "snug/formats/threemf_extensions.h"

#include <algorithm>
#include <string>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/";
constexpr std::string_view kDraft =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01";  // of the standard

/// Namespaces that may be required begin so, whatever their year.
constexpr std::string_view kKnown[] = {
    kCore,
    kDraft,
    kThreeMfProduction,
    "http://schemas.microsoft.com/3dmanufacturing/material/",      // looks
    "http://schemas.microsoft.com/3dmanufacturing/slice/",         // layers beside the mesh
    "http://schemas.microsoft.com/3dmanufacturing/volumetric/",    // what is inside
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/",  // names of faces
    "http://schemas.microsoft.com/3dmanufacturing/mirroring/",     // beside the mesh
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/",   // refused where it is used
    "http://schemas.microsoft.com/3dmanufacturing/securecontent/",
    "http://schemas.3mf.io/3dmanufacturing/production/",
    "http://schemas.3mf.io/3dmanufacturing/volumetric/",
    "http://schemas.3mf.io/3dmanufacturing/implicit/",
    "http://schemas.3mf.io/3dmanufacturing/displacement/",
    "http://schemas.microsoft.com/3dmanufacturing/displacement/",
    "http://schemas.3mf.io/3dmanufacturing/booleanoperations/",
};

bool is_known(std::string_view space) {
    return std::any_of(std::begin(kKnown), std::end(kKnown),
                       [&](std::string_view start) { return space.substr(0, start.size()) == start; });
}

}  // namespace

bool is_3mf_core(std::string_view space) {
    return space.empty() || space.substr(0, kCore.size()) == kCore ||
           space.substr(0, kDraft.size()) == kDraft;
}

Result<void> check_required_extensions(XmlReader& xml) {
    std::string_view required = xml.attribute("requiredextensions").value_or("");
    while (!required.empty()) {
        const std::size_t end = std::min(required.find_first_of(" \t\r\n"), required.size());
        const std::string_view prefix = required.substr(0, end);
        required.remove_prefix(std::min(end + 1, required.size()));
        if (prefix.empty()) continue;
        const std::string_view space = xml.space_of(prefix);
        if (is_known(space.empty() ? prefix : space)) continue;
        std::vector<Message> address;
        if (!space.empty()) address.push_back(as_it_is(" (" + quoted(space, 100) + ")"));
        return fail(ErrorKind::input,
                    say("threemf.extension", {{"prefix", quoted(prefix)}, {"address", address}}));
    }
    return {};
}

}  // namespace snug

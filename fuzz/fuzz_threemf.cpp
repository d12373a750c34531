#include <string>
#include <string_view>

#include "snug/formats/bundle.h"
#include "snug/formats/threemf_read.h"
#include "snug/formats/zip_read.h"

#include "cli/inflate.h"
#include "fuzz/check_mesh.h"
#include "tests/support/zip_builder.h"

/// A zip as it is; anything else is the text of up to three models, parted by a zero byte, which is packed
/// first: no mutation finds a checksum.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace snug;
    SceneTools tools;
    tools.inflate = cli::inflate;
    const Bytes file = fuzz::bytes(data, size);
    if (is_zip(file)) {
        fuzz::check(read_3mf(file, tools));
        const auto packed = find_packed_project(file, tools);
        fuzz::require(!packed || !*packed || !(*packed)->object.empty() || !(*packed)->has_object);
        return 0;
    }
    std::string_view text(reinterpret_cast<const char*>(data), size);
    std::vector<test::ZipPart> parts;
    for (const char* name : {"3D/3dmodel.model", "a.model", "_rels/.rels"}) {
        const std::size_t end = std::min(text.find('\0'), text.size());
        parts.push_back({name, std::string(text.substr(0, end))});
        if (end == text.size()) break;
        text.remove_prefix(end + 1);
    }
    const std::string zip = test::zip_of(parts);
    fuzz::check(read_3mf(std::as_bytes(std::span(zip)), tools));
    return 0;
}

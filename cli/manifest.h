#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snug::cli {

/// A file as a run wrote it.
struct MadeFile {
    std::string name;  ///< within the run's folder, as FileSet::write() takes it: "sponge/lower-01.svg"
    std::uint64_t bytes = 0;
    std::string sha256;  ///< 64 small hexadecimal digits
    [[nodiscard]] bool operator==(const MadeFile& other) const = default;
};

/// By name, then by what was written: a total order.
[[nodiscard]] bool in_order(const MadeFile& a, const MadeFile& b);

/// The list of files that a run made, as text: a first line that names the format, lines for people that
/// begin with "#" (`note`, one or more whole lines, without the "#"), then a line a file, "SHA256 BYTES
/// NAME", sorted by name. Names that parse_manifest() would not trust are left out.
[[nodiscard]] std::string manifest_text(std::vector<MadeFile> files, std::string_view note);

/// What such a text lists; the same name may stand there several times. None unless every line is as
/// manifest_text() writes it: one name that leads out of the folder, or to a hidden file, and nothing of the
/// list is trusted.
[[nodiscard]] std::optional<std::vector<MadeFile>> parse_manifest(std::string_view text);

}  // namespace snug::cli

#include "cli/manifest.h"

#include <algorithm>
#include <charconv>
#include <tuple>
#include <utility>

namespace snug::cli {
namespace {

constexpr std::string_view kFirstLine = "snug files 1";
constexpr std::size_t kHashDigits = 64;
constexpr std::size_t kLongestName = 1024;

/// "a" or "a/b", of parts that are neither empty nor hidden: with that no "..", no root, no list of files.
bool stays_inside(std::string_view name) {
    if (name.empty() || name.size() > kLongestName) return false;
    bool begins = true;
    for (const char c : name) {
        if (begins && (c == '.' || c == '/')) return false;
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
        begins = c == '/';
    }
    return !begins;
}

bool is_hash(std::string_view text) {
    return text.size() == kHashDigits && std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
}

std::optional<MadeFile> parse_line(std::string_view line) {
    if (line.size() < kHashDigits + 4 || !is_hash(line.substr(0, kHashDigits)) || line[kHashDigits] != ' ')
        return {};
    MadeFile file;
    file.sha256 = line.substr(0, kHashDigits);
    line.remove_prefix(kHashDigits + 1);
    const char* const end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data(), end, file.bytes);
    if (error != std::errc() || rest == end || *rest != ' ') return {};
    line.remove_prefix(static_cast<std::size_t>(rest - line.data()) + 1);
    if (!stays_inside(line)) return {};
    file.name = line;
    return file;
}

/// Takes the next line away from the text; none where it does not end.
std::optional<std::string_view> next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    return line;
}

}  // namespace

bool in_order(const MadeFile& a, const MadeFile& b) {
    return std::tie(a.name, a.bytes, a.sha256) < std::tie(b.name, b.bytes, b.sha256);
}

std::string manifest_text(std::vector<MadeFile> files, std::string_view note) {
    std::sort(files.begin(), files.end(), in_order);
    files.erase(std::unique(files.begin(), files.end()), files.end());
    std::string text = std::string(kFirstLine) + "\n";
    while (const auto line = next_line(note)) text += "# " + std::string(*line) + "\n";
    for (const MadeFile& file : files)
        if (stays_inside(file.name))
            text += file.sha256 + " " + std::to_string(file.bytes) + " " + file.name + "\n";
    return text;
}

std::optional<std::vector<MadeFile>> parse_manifest(std::string_view text) {
    if (next_line(text) != kFirstLine) return {};
    std::vector<MadeFile> files;
    while (!text.empty()) {
        const auto line = next_line(text);
        if (!line) return {};
        if (line->substr(0, 1) == "#") continue;
        auto file = parse_line(*line);
        if (!file) return {};
        files.push_back(std::move(*file));
    }
    return files;
}

}  // namespace snug::cli

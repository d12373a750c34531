#include "snug/formats/gltf_uri.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace snug::gltf {
namespace {

constexpr std::string_view kScheme = "data:", kBase64 = ";base64";

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool begins(std::string_view text, std::string_view with) {
    return text.size() >= with.size() &&
           std::equal(with.begin(), with.end(), text.begin(), [](char a, char b) { return a == lower(b); });
}

int hex(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char small = lower(c);
    return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

/// -1: no digit of base64.
int sextet(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    return c == '/' || c == '_' ? 63 : -1;
}

std::optional<FileBytes> from_base64(std::string_view text) {
    FileBytes bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int waiting = 0;
    for (const char c : text) {
        if (c == '=') break;
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        const int value = sextet(c);
        if (value < 0) return {};
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        waiting += 6;
        if (waiting < 8) continue;
        waiting -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> waiting & 0xFF));
    }
    return bytes;
}

}  // namespace

std::string percent_decoded(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape =
            text[i] == '%' && text.size() - i > 2 && hex(text[i + 1]) >= 0 && hex(text[i + 2]) >= 0;
        decoded += escape ? static_cast<char>(16 * hex(text[i + 1]) + hex(text[i + 2])) : text[i];
        if (escape) i += 2;
    }
    return decoded;
}

bool is_data_uri(std::string_view uri) {
    return begins(uri, kScheme);
}

std::optional<FileBytes> data_of(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) return {};
    const std::string_view head = uri.substr(0, comma), content = uri.substr(comma + 1);
    if (head.size() >= kBase64.size() && begins(head.substr(head.size() - kBase64.size()), kBase64)) {
        // Rarely, the digits + and / are escaped themselves.
        return content.find('%') == std::string_view::npos ? from_base64(content)
                                                           : from_base64(percent_decoded(content));
    }
    const std::string decoded = percent_decoded(content);
    const auto* begin = reinterpret_cast<const std::byte*>(decoded.data());
    return FileBytes(begin, begin + decoded.size());
}

bool leads_elsewhere(std::string_view uri) {
    if (uri.empty() || uri.front() == '/' || uri.front() == '\\') return true;
    const std::size_t colon = uri.find(':');
    return colon != std::string_view::npos && uri.find('/') > colon;
}

}  // namespace snug::gltf

#include "snug/formats/ply_header.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/ply_names.h"
#include "snug/formats/text_scan.h"

namespace snug {
namespace {

std::optional<PlyType> type_named(std::string_view name) {
    static constexpr std::pair<std::string_view, PlyType> kTypes[] = {
        {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
        {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
        {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
        {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
        {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
        {"float64", PlyType::float64}};
    for (const auto& [known, type] : kTypes)
        if (known == name) return type;
    return {};
}

class HeaderReader {
  public:
    explicit HeaderReader(std::string_view header)
        : text_(std::as_bytes(std::span(header.data(), header.size()))) {}

    Result<PlyHeader> read() {
        const std::string_view magic = text_.word('\0');
        if (magic != "ply")
            return fail(ErrorKind::input,
                        say("ply.no_ply", {{"place", text_.place()}, {"word", quoted(magic)}}));
        text_.next_line();
        bool has_format = false;
        for (; !text_.at_end(); text_.next_line()) {
            const std::string_view word = text_.word('\0');
            bool good = true;
            if (word == "format") {
                good = read_format();
                has_format = true;
            } else if (word == "element") {
                good = read_element();
            } else if (word == "property") {
                good = read_property();
            }
            if (!good) return tl::unexpected(error_);
        }
        if (!has_format) return fail(ErrorKind::input, say("ply.no_format"));
        header_.lines = text_.line() - 1;
        use_known_names(header_);
        return std::move(header_);
    }

  private:
    bool refuse(Message problem) {
        error_ = {ErrorKind::input,
                  say("at_place", {{"place", text_.place()}, {"problem", std::move(problem)}})};
        return false;
    }

    bool read_format() {
        const std::string_view name = text_.word('\0');
        if (name == "ascii")
            header_.encoding = PlyEncoding::ascii;
        else if (name == "binary_little_endian")
            header_.encoding = PlyEncoding::little_endian;
        else if (name == "binary_big_endian")
            header_.encoding = PlyEncoding::big_endian;
        else
            return refuse(say("ply.format", {{"name", quoted(name)}}));
        return true;
    }

    bool read_element() {
        PlyElement element;
        element.name = text_.word('\0');
        const std::string_view shown = text_.word('\0');
        std::int64_t count = 0;
        if (!to_number(shown, count) || count < 0) return refuse(say("ply.count", {{"word", quoted(shown)}}));
        element.count = static_cast<std::uint64_t>(count);
        header_.elements.push_back(std::move(element));
        return true;
    }

    bool read_property() {
        if (header_.elements.empty()) return refuse(say("ply.property_first"));
        PlyProperty property;
        std::string_view word = text_.word('\0');
        if (word == "list") {
            word = text_.word('\0');
            property.count_type = type_named(word);
            if (!property.count_type || !is_integer(*property.count_type))
                return refuse(say("ply.list_type", {{"word", quoted(word)}}));
            word = text_.word('\0');
        }
        const auto type = type_named(word);
        if (!type) return refuse(say("ply.type", {{"word", quoted(word)}}));
        property.type = *type;
        property.name = text_.word('\0');
        if (property.name.empty()) return refuse(say("ply.no_property_name"));
        header_.elements.back().properties.push_back(std::move(property));
        return true;
    }

    TextScan text_;
    PlyHeader header_;
    Error error_;
};

/// The least number of bytes that one element takes; none has fewer than one.
std::size_t least_size(const PlyElement& element, PlyEncoding encoding) {
    std::size_t size = 0;
    for (const PlyProperty& property : element.properties)
        size += encoding == PlyEncoding::ascii ? 2 : size_of(property.count_type.value_or(property.type));
    return encoding == PlyEncoding::ascii && size > 0 ? size - 1 : size;
}

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::float64:
            return 8;
        default:
            return 4;
    }
}

bool is_integer(PlyType type) {
    return type != PlyType::float32 && type != PlyType::float64;
}

std::size_t PlyElement::find(std::string_view property) const {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&](const PlyProperty& each) { return each.name == property; });
    return static_cast<std::size_t>(found - properties.begin());
}

Result<PlyHeader> read_ply_header(Bytes file) {
    return read_ply_header(file, file.size());
}

Result<PlyHeader> read_ply_header(Bytes file, std::uint64_t file_size) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()),
                                std::min(file.size(), kLongestPlyHeader));
    std::size_t end = text.find("\nend_header");
    if (end == std::string_view::npos) end = text.find("\rend_header");
    if (end == std::string_view::npos) return fail(ErrorKind::input, say("ply.no_end"));
    // The data begins behind the one line end of this line: LF, CR LF or CR. With CR the data itself may
    // begin with the byte of LF.
    const bool ends_with_cr = text[end] == '\r';
    std::size_t data = end + 11;
    while (data < text.size() && (text[data] == ' ' || text[data] == '\t')) ++data;
    if (data < text.size() && text[data] == '\r') ++data;
    if (data < text.size() && text[data] == '\n' && !ends_with_cr) ++data;

    auto header = HeaderReader(text.substr(0, end + 1)).read();
    if (!header) return header;
    header->bytes = data;
    header->lines += 1;
    std::uint64_t left = file_size - data + 1;
    for (const PlyElement& element : header->elements) {
        const std::size_t size = least_size(element, header->encoding);
        if (size > 0 && element.count > left / size)
            return fail(ErrorKind::input, say("ply.too_short", {{"count", element.count},
                                                                {"name", quoted(element.name)},
                                                                {"most", left / size}}));
        left -= size * element.count;
    }
    return header;
}

bool has_float_vertices(const PlyHeader& header) {
    const auto float_holds = [](PlyType type) { return type == PlyType::float32 || size_of(type) <= 2; };
    for (const PlyElement& element : header.elements)
        for (const PlyProperty& property : element.properties)
            if (element.name == "vertex" && !float_holds(property.type) &&
                (property.name == "x" || property.name == "y" || property.name == "z"))
                return false;
    return true;
}

Error ply_wrong_index(const Message& noun, std::uint64_t number, std::int64_t vertex,
                      std::uint64_t vertices) {
    return {ErrorKind::input, say("ply.wrong_index", {{"noun", noun},
                                                      {"number", number + 1},
                                                      {"vertex", std::to_string(vertex)},
                                                      {"vertices", vertices}})};
}

}  // namespace snug

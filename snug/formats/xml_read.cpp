#include "snug/formats/xml_read.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"
#include "snug/base/utf8.h"
#include "snug/formats/xml_text.h"

namespace snug {
namespace {

constexpr std::size_t kMostElementDepth = 256;  // of elements within elements
constexpr std::size_t kMostAttributes = 1024;   // of an element
constexpr std::size_t kMostBindings = 256;      // namespaces that hold at one place

std::string_view text_of(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool starts_with(std::string_view text, std::size_t at, std::string_view start) {
    return text.compare(at, start.size(), start) == 0;
}

bool ends_name(char c) {
    return is_xml_space(c) || c == '>' || c == '/' || c == '=' || c == '<' || c == '"' || c == '\'';
}

}  // namespace

XmlReader::XmlReader(Bytes document) : text_(text_of(document)) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (auto decoded = from_utf16(document)) {
        decoded_ = std::move(*decoded);
        text_ = decoded_;
    }
    if (starts_with(text_, 0, kByteOrderMark)) at_ = kByteOrderMark.size();
}

Result<XmlEvent> XmlReader::next() {
    if (std::exchange(over_, false)) {
        leave();
        return XmlEvent::end;
    }
    for (;;) {
        at_ = std::min(text_.find('<', at_), text_.size());
        if (at_ == text_.size()) {
            if (!begun_) return wrong(say("xml.nothing"));
            if (!open_.empty()) return wrong(say("xml.cut_off", {{"name", quoted(open_.back().name)}}));
            return XmlEvent::done;
        }
        bool whole = true;
        if (starts_with(text_, at_, "<!--")) {
            at_ += 4;
            whole = pass_over("-->");
        } else if (starts_with(text_, at_, "<![CDATA[")) {
            whole = pass_over("]]>");
        } else if (starts_with(text_, at_, "<?")) {
            whole = pass_over("?>");
        } else if (starts_with(text_, at_, "<!")) {
            whole = pass_over_document_type();
        } else {
            return starts_with(text_, at_, "</") ? end_tag() : start_tag();
        }
        if (!whole) return wrong(say("xml.cut_off_comment"));
    }
}

Result<void> XmlReader::skip() {
    for (const std::size_t outside = open_.size(); open_.size() >= outside;) {
        const auto event = next();
        if (!event) return tl::unexpected(event.error());
    }
    return {};
}

bool XmlReader::pass_over(std::string_view until) {
    const std::size_t end = text_.find(until, at_);
    at_ = end == std::string_view::npos ? text_.size() : end + until.size();
    return end != std::string_view::npos;
}

/// A document type may hold declarations in brackets, and those texts in quotes and comments.
bool XmlReader::pass_over_document_type() {
    bool in_brackets = false;
    while (++at_ < text_.size()) {
        const char c = text_[at_];
        if (c == '"' || c == '\'') {
            at_ = text_.find(c, at_ + 1);
            if (at_ == std::string_view::npos) break;
        } else if (starts_with(text_, at_, "<!--")) {
            if (!pass_over("-->")) return false;
            --at_;
        } else if (c == '[') {
            in_brackets = true;
        } else if (c == ']') {
            in_brackets = false;
        } else if (c == '>' && !in_brackets) {
            ++at_;
            return true;
        }
    }
    at_ = text_.size();
    return false;
}

Result<XmlEvent> XmlReader::start_tag() {
    if (begun_ && open_.empty()) return wrong(say("xml.two_roots"));
    begun_ = true;
    ++at_;
    const std::string_view name = word();
    if (name.empty()) return wrong(say("xml.no_name"));
    if (open_.size() == kMostElementDepth)
        return wrong(say("xml.deep", {{"most", std::to_string(kMostElementDepth)}}));
    open_.push_back({name, bindings_.size()});
    const auto over = attributes();
    if (!over) return tl::unexpected(over.error());
    over_ = *over;
    if (auto bound = bind_namespaces(); !bound) return tl::unexpected(bound.error());
    const std::size_t colon = name.find(':');
    name_ = colon == std::string_view::npos ? Name{{}, name}
                                            : Name{name.substr(0, colon), name.substr(colon + 1)};
    return XmlEvent::start;
}

Result<bool> XmlReader::attributes() {
    attributes_.clear();
    for (;;) {
        pass_spaces();
        if (at_ < text_.size() && text_[at_] == '>') {
            ++at_;
            return false;
        }
        if (starts_with(text_, std::min(at_, text_.size()), "/>")) {
            at_ += 2;
            return true;
        }
        const std::string_view name = word();
        pass_spaces();
        if (name.empty() || at_ >= text_.size() || text_[at_] != '=')
            return wrong(say("xml.tag", {{"name", quoted(open_.back().name)}}));
        ++at_;
        pass_spaces();
        const char quote = at_ < text_.size() ? text_[at_] : '\0';
        const std::size_t end = quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : text_.npos;
        if (end == text_.npos) return wrong(say("xml.quotes", {{"name", quoted(name)}}));
        if (attributes_.size() == kMostAttributes)
            return wrong(say("xml.attributes", {{"most", std::to_string(kMostAttributes)}}));
        const std::size_t colon = name.find(':');
        const Name parted = colon == std::string_view::npos
                                ? Name{{}, name}
                                : Name{name.substr(0, colon), name.substr(colon + 1)};
        attributes_.push_back({parted, text_.substr(at_ + 1, end - at_ - 1)});
        at_ = end + 1;
    }
}

Result<void> XmlReader::bind_namespaces() {
    for (const auto& [name, raw] : attributes_) {
        const bool is_default = name.prefix.empty() && name.local == "xmlns";
        if (!is_default && name.prefix != "xmlns") continue;
        if (bindings_.size() == kMostBindings)
            return wrong(say("xml.namespaces", {{"most", std::to_string(kMostBindings)}}));
        bindings_.push_back({is_default ? std::string_view() : name.local, without_xml_spaces(raw)});
    }
    return {};
}

Result<XmlEvent> XmlReader::end_tag() {
    at_ += 2;
    const std::string_view name = word();
    pass_spaces();
    if (open_.empty() || name != open_.back().name || at_ >= text_.size() || text_[at_] != '>') {
        if (open_.empty()) return wrong(say("xml.end", {{"name", quoted(name)}}));
        return wrong(say("xml.wrong_end", {{"name", quoted(name)}, {"wanted", quoted(open_.back().name)}}));
    }
    ++at_;
    leave();
    return XmlEvent::end;
}

void XmlReader::leave() {
    bindings_.resize(open_.back().bindings);
    open_.pop_back();
}

void XmlReader::pass_spaces() {
    while (at_ < text_.size() && is_xml_space(text_[at_])) ++at_;
}

std::string_view XmlReader::word() {
    const std::size_t begin = std::min(at_, text_.size());
    while (at_ < text_.size() && !ends_name(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
}

std::string_view XmlReader::space_of(std::string_view prefix) const {
    for (auto binding = bindings_.rbegin(); binding != bindings_.rend(); ++binding)
        if (binding->prefix == prefix) return binding->space;
    return {};
}

std::optional<std::string_view> XmlReader::attribute(std::string_view name) {
    for (const Attribute& each : attributes_)
        if (each.name.prefix.empty() && each.name.local == name) return value_of(each);
    return {};
}

std::optional<std::string_view> XmlReader::attribute(std::string_view space, std::string_view name) {
    for (const Attribute& each : attributes_)
        if (each.name.local == name && !each.name.prefix.empty() &&
            starts_with(space_of(each.name.prefix), 0, space))
            return value_of(each);
    return {};
}

std::optional<std::string_view> XmlReader::value_of(const Attribute& attribute) {
    if (attribute.raw.find('&') == std::string_view::npos) return without_xml_spaces(attribute.raw);
    if (!expand_xml(attribute.raw, expanded_)) return {};
    return without_xml_spaces(expanded_);
}

Message XmlReader::place() const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
    return say("at_line", {{"line", 1 + std::count(text_.begin(), end, '\n')}});
}

tl::unexpected<Error> XmlReader::wrong(Message what) const {
    return fail(ErrorKind::input, say("at_place", {{"place", place()}, {"problem", std::move(what)}}));
}

}  // namespace snug

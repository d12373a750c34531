#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/result.h"

namespace snug {

enum class XmlEvent {
    start,  ///< an element begins; its attributes can be asked for
    end,    ///< it ends; an element without content has both
    done,   ///< the document is over
};

/// Reads an XML document element by element, as the formats of packages use XML: namespaces, attributes in
/// either quotes, the five entities and character references. Text, comments, processing instructions and a
/// document type are passed over; nothing is ever expanded or fetched. UTF-8, and UTF-16 of either order.
/// Memory and time are linear in the bytes: nesting, attributes and namespaces of one element have limits,
/// which the sentences tell. Errors are of kind `input` and name the line.
class XmlReader {
  public:
    /// The bytes must outlive the reader.
    explicit XmlReader(Bytes document);
    XmlReader(XmlReader&&) = delete;  // views point into it

    [[nodiscard]] Result<XmlEvent> next();

    /// After a `start`: passes over everything up to the element's end, that one included.
    [[nodiscard]] Result<void> skip();

    // Of the element that began last, until the next call of next():

    /// Its name without the prefix.
    [[nodiscard]] std::string_view name() const { return name_.local; }
    /// The address of its namespace; empty where it has none or its prefix stands for none.
    [[nodiscard]] std::string_view space() const { return space_of(name_.prefix); }
    /// The attribute of that name without a prefix, spaces around it dropped; none where it is absent or has
    /// an entity that XML does not know.
    [[nodiscard]] std::optional<std::string_view> attribute(std::string_view name);
    /// The same of an attribute with a prefix that stands for a namespace which begins with `space`.
    [[nodiscard]] std::optional<std::string_view> attribute(std::string_view space, std::string_view name);
    /// What a prefix stands for here; empty where it stands for nothing.
    [[nodiscard]] std::string_view space_of(std::string_view prefix) const;

    /// "line 12"
    [[nodiscard]] Message place() const;

  private:
    struct Name {
        std::string_view prefix, local;
    };
    struct Attribute {
        Name name;
        std::string_view raw;
    };
    struct Binding {
        std::string_view prefix, space;
    };
    struct Open {
        std::string_view name;  // as written
        std::size_t bindings;   // that held before it
    };

    bool pass_over(std::string_view until);
    bool pass_over_document_type();
    [[nodiscard]] tl::unexpected<Error> wrong(Message what) const;
    Result<XmlEvent> start_tag();
    Result<XmlEvent> end_tag();
    Result<bool> attributes();  // true where the element is over with its tag
    Result<void> bind_namespaces();
    void pass_spaces();
    std::string_view word();
    std::optional<std::string_view> value_of(const Attribute& attribute);
    void leave();

    std::string decoded_;  // of UTF-16
    std::string_view text_;
    std::size_t at_ = 0;
    Name name_;
    bool over_ = false;   // an `end` without a tag is due
    bool begun_ = false;  // the root was there
    std::vector<Attribute> attributes_;
    std::vector<Binding> bindings_;
    std::vector<Open> open_;
    std::string expanded_;  // the value asked for last, if it had entities
};

}  // namespace snug

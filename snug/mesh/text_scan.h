#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace snug {

/// A cursor over the bytes of a text file, line by line and word by word. Nothing is copied and no locale is
/// asked. Lines end with LF, CR LF or CR. A byte order mark at the start is no part of the first word.
class TextScan {
  public:
    explicit TextScan(std::span<const std::byte> bytes);

    [[nodiscard]] bool at_end() const { return at_ == end_; }
    [[nodiscard]] std::size_t line() const { return line_; }
    /// "line 12: "
    [[nodiscard]] std::string place() const { return "line " + std::to_string(line_) + ": "; }

    /// The next word of this line; empty at its end. A comment (from `comment` on) ends the line.
    std::string_view word(char comment = '#');
    /// Goes to the start of the next line.
    void next_line();
    /// The next word of the file, lines passed over; empty at the end.
    std::string_view word_anywhere(char comment = '#');

  private:
    const char* at_;
    const char* end_;
    std::size_t line_ = 1;
};

/// The whole word as a finite number; a leading + is allowed.
[[nodiscard]] bool to_number(std::string_view word, double& value);
[[nodiscard]] bool to_number(std::string_view word, std::int64_t& value);

/// Case of ASCII letters ignored; `lower` must be in lower case.
[[nodiscard]] bool same_word(std::string_view word, std::string_view lower);

}  // namespace snug

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "snug/base/message.h"
#include "snug/formats/ply_header.h"
#include "snug/formats/text_scan.h"

namespace snug {

// The values of a PLY behind its header, one after the other, from bytes or from text. Both can be copied, to
// come back to a place later. Their functions return false where the file ends or holds no such value.

class BinaryPlyValues {
  public:
    BinaryPlyValues(Bytes data, bool big_endian) : data_(data), swapped_(big_endian) {}

    template <class T>
    bool next(PlyType type, T& value) {
        if (is_integer(type)) {
            std::int64_t whole = 0;
            if (!next_whole(type, whole)) return false;
            value = static_cast<T>(whole);
            return true;
        }
        return type == PlyType::float32 ? take<float>(value) : take<double>(value);
    }
    /// Of a whole type.
    bool next_whole(PlyType type, std::int64_t& value) {
        switch (type) {
            case PlyType::int8:
                return take<std::int8_t>(value);
            case PlyType::uint8:
                return take<std::uint8_t>(value);
            case PlyType::int16:
                return take<std::int16_t>(value);
            case PlyType::uint16:
                return take<std::uint16_t>(value);
            case PlyType::int32:
                return take<std::int32_t>(value);
            case PlyType::uint32:
                return take<std::uint32_t>(value);
            default:
                return false;
        }
    }
    /// Only text has lines.
    void begin_record() {}
    template <class Left>
    void end_record(const Left&) {}

    bool skip(PlyType type, std::size_t count) {
        if (count > (data_.size() - at_) / size_of(type)) return false;
        at_ += count * size_of(type);
        return true;
    }
    [[nodiscard]] std::size_t left() const { return data_.size() - at_; }
    [[nodiscard]] Message place() const { return {}; }
    /// What stands where a value should; only text shows that.
    [[nodiscard]] std::string_view wrong_word() const { return {}; }

  private:
    template <class Stored, class T>
    bool take(T& value) {
        if (data_.size() - at_ < sizeof(Stored)) return false;
        Stored raw;
        std::memcpy(&raw, data_.data() + at_, sizeof raw);
        if (swapped_) {
            std::byte bytes[sizeof raw];
            std::memcpy(bytes, &raw, sizeof raw);
            std::reverse(std::begin(bytes), std::end(bytes));
            std::memcpy(&raw, bytes, sizeof raw);
        }
        value = static_cast<T>(raw);
        at_ += sizeof raw;
        return true;
    }

    Bytes data_;
    std::size_t at_ = 0;
    bool swapped_;
};

/// Writers do not agree on line ends, so words count, not lines; but where each record has a line of its own
/// and there is more in it than the header says, the rest is passed over. Comments are, too.
class AsciiPlyValues {
  public:
    enum class Lines { end_records_so_far, end_records, do_not_count };

    AsciiPlyValues(Bytes data, std::size_t header_lines, Lines lines = Lines::end_records_so_far)
        : text_(data), size_(data.size()), header_lines_(header_lines), lines_(lines) {}

    /// NaN for what is no number and says so.
    bool next(PlyType, double& value) {
        if (!begins_record_ && text_.plain_number(value)) return true;
        word_ = next_word();
        return to_coordinate(word_, value);
    }
    /// Whole numbers may be written as 3.0 or 3e0; those beyond all counts are cut to about 1e15.
    bool next_whole(PlyType type, std::int64_t& value) {
        double number = 0;
        TextScan before = text_;
        if (!next(type, number)) return false;
        if (number != std::floor(number)) {
            word_ = before.word_anywhere('\0');
            return false;
        }
        value = static_cast<std::int64_t>(std::clamp(number, -1e15, 1e15));
        return true;
    }
    bool skip(PlyType, std::size_t count) {
        for (; count > 0; --count) {
            word_ = next_word();
            if (word_.empty()) return false;
        }
        return true;
    }
    /// A record is a vertex, a face or another element.
    void begin_record() { begins_record_ = true; }
    /// `left()`: how many records follow in the file.
    template <class Left>
    void end_record(const Left& left) {
        if (lines_ == Lines::do_not_count) return;
        if (lines_ == Lines::end_records) return text_.next_line();
        TextScan behind = text_;
        if (const std::string_view word = behind.word('\0'); word.empty() || is_comment(word)) return;
        // The first record behind which more stands in its line.
        const bool in_one_line = text_.line() == record_line_;
        behind.next_line();
        const bool enough = in_one_line && has_lines(behind, left());
        lines_ = enough ? Lines::end_records : Lines::do_not_count;
        if (enough) text_.next_line();
    }
    /// Whether it was taken for granted that each record has its line.
    [[nodiscard]] bool by_lines() const { return lines_ == Lines::end_records; }
    /// Whether nothing but comments follows.
    [[nodiscard]] bool used_up() { return next_word().empty(); }
    [[nodiscard]] std::size_t left() const { return text_.at_end() ? 0 : size_; }
    [[nodiscard]] Message place() const { return at_line(text_.line() + header_lines_); }
    [[nodiscard]] std::string_view wrong_word() const { return word_; }

  private:
    static bool is_comment(std::string_view word) {
        return word[0] == '#' || word == "comment" || word == "obj_info";
    }

    std::string_view next_word() {
        for (;;) {
            const bool within_line = lines_ == Lines::end_records && !begins_record_;
            const std::string_view word = within_line ? text_.word('\0') : text_.word_anywhere('\0');
            if (word.empty() || !is_comment(word)) {
                if (begins_record_) record_line_ = text_.line();
                begins_record_ = false;
                return word;
            }
            if (within_line) return {};
            text_.next_line();
        }
    }

    /// Whether that many lines with something in them follow.
    static bool has_lines(TextScan text, std::uint64_t wanted) {
        for (; wanted > 0 && !text.at_end(); text.next_line())
            if (const std::string_view word = text.word('\0'); !word.empty() && !is_comment(word)) --wanted;
        return wanted == 0;
    }

    TextScan text_;
    std::string_view word_;
    std::size_t size_;
    std::size_t header_lines_;
    std::size_t record_line_ = 0;
    bool begins_record_ = false;
    Lines lines_;
};

}  // namespace snug

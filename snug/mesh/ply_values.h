#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "snug/mesh/ply_header.h"
#include "snug/mesh/text_scan.h"

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
    bool skip(PlyType type, std::size_t count) {
        if (count > (data_.size() - at_) / size_of(type)) return false;
        at_ += count * size_of(type);
        return true;
    }
    [[nodiscard]] std::size_t left() const { return data_.size() - at_; }
    [[nodiscard]] std::string place() const { return ""; }
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

/// Writers do not agree on line ends, so words count, not lines.
class AsciiPlyValues {
  public:
    AsciiPlyValues(Bytes data, std::size_t header_lines)
        : text_(data), size_(data.size()), header_lines_(header_lines) {}

    bool next(PlyType, double& value) {
        word_ = text_.word_anywhere('\0');
        return to_number(word_, value);
    }
    /// Whole numbers may be written as 3.0 or 3e0; those beyond all counts are cut to about 1e15.
    bool next_whole(PlyType type, std::int64_t& value) {
        double number = 0;
        if (!next(type, number) || number != std::floor(number)) return false;
        value = static_cast<std::int64_t>(std::clamp(number, -1e15, 1e15));
        return true;
    }
    bool skip(PlyType, std::size_t count) {
        for (; count > 0; --count) {
            word_ = text_.word_anywhere('\0');
            if (word_.empty()) return false;
        }
        return true;
    }
    [[nodiscard]] std::size_t left() const { return text_.at_end() ? 0 : size_; }
    [[nodiscard]] std::string place() const {
        return "line " + std::to_string(text_.line() + header_lines_) + ": ";
    }
    [[nodiscard]] std::string_view wrong_word() const { return word_; }

  private:
    TextScan text_;
    std::string_view word_;
    std::size_t size_;
    std::size_t header_lines_;
};

}  // namespace snug

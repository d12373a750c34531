#pragma once

#include <cstdint>

namespace snug {

struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;
    friend bool operator==(const Color&, const Color&) = default;
};
constexpr Color kWhite{255, 255, 255}, kBlack{0, 0, 0};
constexpr Color kLowerBlue{64, 132, 214};
constexpr Color kMiddleGreen{84, 166, 116};
constexpr Color kUpperOrange{242, 145, 46};

}  // namespace snug

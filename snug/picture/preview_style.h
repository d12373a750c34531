#pragma once

#include <string_view>

// The preview's look besides its foam colours: SVG presentation attributes.

namespace snug {

constexpr std::string_view kFontFamilies =  // and those of more_fonts()
    "'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans'";
constexpr std::string_view kDimensionStroke = "stroke=\"#8a94a3\" stroke-width=\"1\"";
constexpr std::string_view kDimensionText =
    "fill=\"#4b5665\" stroke=\"#ffffff\" stroke-opacity=\".8\" stroke-width=\"4\" stroke-linejoin=\"round\" "
    "paint-order=\"stroke\"";
constexpr std::string_view kAxisStroke = "stroke=\"#6b7686\" stroke-width=\"1.4\" stroke-linecap=\"round\"";
constexpr std::string_view kAxisText = "fill=\"#6b7686\"";
constexpr std::string_view kLegendText = "fill=\"#2c3642\"";
constexpr std::string_view kHingeStroke =
    "stroke=\"#2c3642\" stroke-width=\"1.4\" stroke-dasharray=\"14 4 2.5 4\"";
constexpr std::string_view kBackText = "fill=\"#2c3642\" font-weight=\"600\" letter-spacing=\"1\"";
constexpr std::string_view kWallText =
    "fill=\"#ffffff\" fill-opacity=\".92\" font-weight=\"700\" letter-spacing=\"2\"";
constexpr std::string_view kLowerTableText = "fill=\"#2f6bb3\" font-weight=\"700\" letter-spacing=\"1\"";
constexpr std::string_view kLidTableText = "fill=\"#c26a12\" font-weight=\"700\" letter-spacing=\"1\"";
constexpr std::string_view kTableStyle =
    "fill=\"#f4f5f7\" stroke=\"#c5cbd3\" stroke-width=\"1\" stroke-dasharray=\"5 4\"";
constexpr std::string_view kObjectSwatch = "fill=\"#ffffff\" stroke=\"#1c2530\" stroke-width=\"1.8\"";
constexpr std::string_view kObjectFill = "fill=\"#ffffff\" fill-opacity=\".42\" fill-rule=\"evenodd\"";
constexpr std::string_view kObjectShade = "fill=\"#14202e\" fill-opacity=\".09\" fill-rule=\"evenodd\"";
constexpr std::string_view kObjectStroke =
    "fill=\"none\" stroke=\"#1c2530\" stroke-width=\"1.9\" stroke-linejoin=\"round\"";
constexpr std::string_view kObjectHiddenStroke =
    "fill=\"none\" stroke=\"#1c2530\" stroke-width=\"1.2\" stroke-opacity=\".75\" stroke-dasharray=\"5 4\" "
    "stroke-linejoin=\"round\"";
constexpr std::string_view kCaptionText = "fill=\"#2c3642\" text-anchor=\"middle\"";

}  // namespace snug

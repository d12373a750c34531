#include "cli/pdf_text.h"

#include <hpdf_font.h>

#include "snug/base/wide_text.h"

#include "cli/latin_text.h"
#include "cli/pdf_fonts.h"

namespace snug::cli {
namespace {

constexpr char32_t kHiraganaA = 0x3042, kLastOfPlane = 0xffff;

bool has_glyph(HPDF_Font font, char32_t character) {
    const auto* const known = static_cast<HPDF_FontAttr>(font->attr);
    return character <= kLastOfPlane &&
           HPDF_TTFontDef_GetGlyphid(known->fontdef, static_cast<HPDF_UINT16>(character)) != 0;
}

}  // namespace

PdfFonts::PdfFonts(HPDF_Doc document, HPDF_STATUS& error, const std::optional<std::filesystem::path>& chosen)
    : document_(document),
      error_(error),
      chosen_(chosen),
      plain_(HPDF_GetFont(document, "Helvetica", "WinAnsiEncoding")),
      bold_(HPDF_GetFont(document, "Helvetica-Bold", "WinAnsiEncoding")) {}

std::vector<PdfRun> PdfFonts::runs_of(std::string_view text, bool bold) {
    std::vector<PdfRun> runs;
    const auto add = [&](HPDF_Font font, std::string_view bytes, bool thicken) {
        if (runs.empty() || runs.back().font != font) runs.push_back({font, {}, thicken});
        runs.back().bytes += bytes;
    };
    const HPDF_Font own = bold ? bold_ : plain_;
    while (!text.empty()) {
        const auto [character, size] = first_character(text);
        const std::string_view bytes = text.substr(0, size);
        text.remove_prefix(size);
        if (const auto latin = latin_letter(character)) {
            add(own, {&*latin, 1}, false);
        } else if (const HPDF_Font font = font_with(character)) {
            add(font, bytes, bold);
        } else {
            add(own, "?", false);
            if (missing_.find(bytes) == std::string::npos) missing_ += bytes;
        }
    }
    if (runs.empty()) runs.push_back({own, {}, false});
    return runs;
}

void PdfFonts::set_title(std::string_view title) {
    const std::string latin = latin_text(title);
    const bool beyond = !is_latin(title);
    if (beyond) {
        use_utf8();
        HPDF_SetCurrentEncoder(document_, "UTF-8");
    }
    HPDF_SetInfoAttr(document_, HPDF_INFO_TITLE, beyond ? std::string(title).c_str() : latin.c_str());
}

void PdfFonts::use_utf8() {
    if (!utf8_) HPDF_UseUTFEncodings(document_);  // a second time would be an error
    utf8_ = true;
}

bool PdfFonts::has_japanese() {
    return font_with(kHiraganaA) != nullptr;
}

void PdfFonts::look_for_fonts() {
    looked_ = true;
    use_utf8();
    const auto files = chosen_ ? std::vector{*chosen_} : fonts_beyond_latin();
    for (const std::filesystem::path& file : files) {
        const HPDF_STATUS before = error_;
        const char* const name = HPDF_LoadTTFontFromFile(document_, file.c_str(), HPDF_TRUE);
        const HPDF_Font font = name ? HPDF_GetFont(document_, name, "UTF-8") : nullptr;
        if (font) beyond_.push_back(font);
        if (font || before != HPDF_OK) continue;
        error_ = HPDF_OK;
        HPDF_ResetError(document_);
    }
}

HPDF_Font PdfFonts::font_with(char32_t character) {
    if (!looked_) look_for_fonts();
    for (const HPDF_Font font : beyond_)
        if (has_glyph(font, character)) return font;
    return nullptr;
}

}  // namespace snug::cli

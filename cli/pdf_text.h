#pragma once

#include <filesystem>
#include <hpdf.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snug::cli {

/// Letters of one font, as that font has them.
struct PdfRun {
    HPDF_Font font;
    std::string bytes;     ///< Windows-1252, or UTF-8 for a font that was put into the file
    bool thicken = false;  ///< bold is asked for, and the font has no bold letters
};

/// The fonts of a document: Helvetica, and for letters that it lacks TrueType fonts, which are looked for and
/// read when the first such letter comes.
class PdfFonts {
  public:
    /// `error` is where the document notes what fails; a font that cannot be read leaves nothing there.
    PdfFonts(HPDF_Doc document, HPDF_STATUS& error, const std::optional<std::filesystem::path>& chosen);

    /// The text, divided where the font changes. A question mark stands for a letter that no font has.
    [[nodiscard]] std::vector<PdfRun> runs_of(std::string_view text, bool bold);
    void set_title(std::string_view title);

    /// The letters that no font had, each once.
    [[nodiscard]] const std::string& missing() const { return missing_; }
    [[nodiscard]] bool has_japanese();
    /// Whether fonts were looked for and none could be read.
    [[nodiscard]] bool unreadable() const { return looked_ && beyond_.empty(); }

  private:
    void use_utf8();
    void look_for_fonts();
    [[nodiscard]] HPDF_Font font_with(char32_t character);

    HPDF_Doc document_;
    HPDF_STATUS& error_;
    const std::optional<std::filesystem::path>& chosen_;
    HPDF_Font plain_, bold_;
    bool utf8_ = false, looked_ = false;
    std::vector<HPDF_Font> beyond_;
    std::string missing_;
};

}  // namespace snug::cli

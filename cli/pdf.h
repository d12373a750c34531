#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/drawing/drawing.h"
#include "snug/words/words.h"

namespace snug::cli {

/// What the pages are written with.
struct PdfLetters {
    Language language = Language::english;      ///< of the pages
    std::optional<std::filesystem::path> font;  ///< TrueType, for letters beyond Latin; none: looked for
};

struct WrittenPdf {
    std::vector<std::byte> bytes;
    std::string missing;  ///< letters that no font had, each once: question marks stand for them
};

/// The document as PDF, a page a drawing, asking the viewer not to scale it where it must keep its true size.
/// Latin letters are those of PDF's own fonts; a font of this machine is put into the file for others
/// (pdf_fonts.h). Fails with kind `usage` for a page that PDF cannot hold (longer than 5 m), with kind
/// `output` where pages in Japanese find no font that has its letters, or where the file cannot be made, with
/// kind `input` where the chosen font is none.
[[nodiscard]] Result<WrittenPdf> write_pdf(const DrawingDocument& document, const PdfLetters& letters);

}  // namespace snug::cli

#include "cli/pdf.h"

#include <algorithm>
#include <cmath>
#include <hpdf.h>
#include <memory>
#include <type_traits>

#include <fmt/core.h>

#include "snug/words/words.h"

#include "cli/pdf_text.h"

namespace snug::cli {
namespace {

constexpr double kPoints = 72 / 25.4;   // a mm
constexpr double kLongestPage = 14400;  // points
constexpr std::size_t kMostDashes = 8;
constexpr double kBoldOutline = 0.03;  // of the height

void note_error(HPDF_STATUS code, HPDF_STATUS, void* first) {
    auto& kept = *static_cast<HPDF_STATUS*>(first);
    if (kept == HPDF_OK) kept = code;
}

float points(double mm) {
    return static_cast<float>(mm * kPoints);
}
float part(std::uint8_t value) {
    return static_cast<float>(value) / 255.0F;
}

/// Draws the items of one page; y turned upward.
class PagePainter {
  public:
    PagePainter(HPDF_Page page, PdfFonts& fonts, Vec2d size_mm)
        : page_(page), fonts_(fonts), height_mm_(size_mm.y) {}

    void paint(const PathItem& path) {
        const bool filled = path.closed && path.fill;
        if (!filled && !path.pen) return;
        use(filled ? path.fill : std::nullopt, path.pen);
        bool any = false;
        for (const std::vector<Vec2d>& line : path.lines) {
            if (line.size() < 2) continue;
            any = true;
            HPDF_Page_MoveTo(page_, x(line.front()), y(line.front()));
            for (std::size_t i = 1; i < line.size(); ++i) HPDF_Page_LineTo(page_, x(line[i]), y(line[i]));
            if (path.closed) HPDF_Page_ClosePath(page_);
        }
        if (any) finish(filled, path.pen.has_value());
    }

    void paint(const CircleItem& circle) {
        if (!circle.fill && !circle.pen) return;
        use(circle.fill, circle.pen);
        HPDF_Page_Circle(page_, x(circle.centre), y(circle.centre), points(circle.radius_mm));
        finish(circle.fill.has_value(), circle.pen.has_value());
    }

    void paint(const TextItem& text) {
        const std::vector<PdfRun> runs = fonts_.runs_of(text.text, text.bold);
        use(text.color, {});
        HPDF_Page_BeginText(page_);
        float width = 0;
        for (const PdfRun& run : runs) {
            HPDF_Page_SetFontAndSize(page_, run.font, points(text.height_mm));
            width += HPDF_Page_TextWidth(page_, run.bytes.c_str());
        }
        const float back = text.anchor == TextAnchor::start    ? 0
                           : text.anchor == TextAnchor::middle ? width / 2
                                                               : width;
        const int quarter = static_cast<int>(std::lround(text.turn_deg / 90)) & 3;  // clockwise
        const float cosine = quarter == 0 ? 1.0F : quarter == 2 ? -1.0F : 0.0F;
        const float sine = quarter == 1 ? -1.0F : quarter == 3 ? 1.0F : 0.0F;
        HPDF_Page_SetTextMatrix(page_, cosine, sine, -sine, cosine, x(text.at) - back * cosine,
                                y(text.at) - back * sine);
        for (const PdfRun& run : runs) {
            if (runs.size() > 1) HPDF_Page_SetFontAndSize(page_, run.font, points(text.height_mm));
            if (run.thicken) thicken(text);
            HPDF_Page_ShowText(page_, run.bytes.c_str());
            if (run.thicken) HPDF_Page_SetTextRenderingMode(page_, HPDF_FILL);
        }
        HPDF_Page_EndText(page_);
    }

  private:
    [[nodiscard]] float x(Vec2d at) const { return points(at.x); }
    [[nodiscard]] float y(Vec2d at) const { return points(height_mm_ - at.y); }

    void use(std::optional<Color> fill, const std::optional<Pen>& pen) {
        if (fill) HPDF_Page_SetRGBFill(page_, part(fill->red), part(fill->green), part(fill->blue));
        if (!pen) return;
        HPDF_Page_SetRGBStroke(page_, part(pen->color.red), part(pen->color.green), part(pen->color.blue));
        HPDF_Page_SetLineWidth(page_, points(pen->width_mm));
        std::vector<HPDF_UINT16> dashes;  // whole points only
        for (const double dash : pen->dashes_mm)
            dashes.push_back(static_cast<HPDF_UINT16>(std::max(1L, std::lround(dash * kPoints))));
        if (dashes.size() % 2 != 0) dashes.insert(dashes.end(), dashes.begin(), dashes.end());
        dashes.resize(std::min(dashes.size(), kMostDashes));
        HPDF_Page_SetDash(page_, dashes.empty() ? nullptr : dashes.data(),
                          static_cast<HPDF_UINT>(dashes.size()), 0);
    }

    /// A font that has no bold letters: their outlines are drawn as well.
    void thicken(const TextItem& text) {
        use({}, Pen{text.color, text.height_mm * kBoldOutline, {}});
        HPDF_Page_SetTextRenderingMode(page_, HPDF_FILL_THEN_STROKE);
    }

    void finish(bool filled, bool stroked) {
        if (filled && stroked)
            HPDF_Page_EofillStroke(page_);
        else if (filled)
            HPDF_Page_Eofill(page_);
        else
            HPDF_Page_Stroke(page_);
    }

    HPDF_Page page_;
    PdfFonts& fonts_;
    double height_mm_;
};

struct Free {
    void operator()(HPDF_Doc document) const { HPDF_Free(document); }
};

void add_page(HPDF_Doc pdf, PdfFonts& fonts, const Drawing& drawing) {
    HPDF_Page page = HPDF_AddPage(pdf);
    if (!page) return;
    HPDF_Page_SetWidth(page, points(drawing.size_mm.x));
    HPDF_Page_SetHeight(page, points(drawing.size_mm.y));
    HPDF_Page_SetLineJoin(page, HPDF_ROUND_JOIN);
    PagePainter painter(page, fonts, drawing.size_mm);
    for (const DrawingItem& item : drawing.items)
        std::visit([&](const auto& what) { painter.paint(what); }, item.what);
}

}  // namespace

Result<WrittenPdf> write_pdf(const DrawingDocument& document, const PdfLetters& letters) {
    const std::string name = document.name + ".pdf";
    for (const Drawing& page : document.pages)
        if (std::max(page.size_mm.x, page.size_mm.y) * kPoints > kLongestPage)
            return fail(ErrorKind::usage, in_file(name, say("pdf.long_page")));
    HPDF_STATUS error = HPDF_OK;
    const std::unique_ptr<std::remove_pointer_t<HPDF_Doc>, Free> pdf(HPDF_New(note_error, &error));
    if (!pdf) return fail(ErrorKind::output, in_file(name, say("pdf.no_memory")));
    HPDF_SetCompressionMode(pdf.get(), HPDF_COMP_ALL);
    PdfFonts fonts(pdf.get(), error, letters.font);
    fonts.set_title(document.title);
    HPDF_SetInfoAttr(pdf.get(), HPDF_INFO_CREATOR, "Snug");
    if (document.true_size) HPDF_SetViewerPreference(pdf.get(), HPDF_PRINT_SCALING_NONE);
    for (const Drawing& page : document.pages) add_page(pdf.get(), fonts, page);
    if (letters.font && fonts.unreadable())
        return fail(ErrorKind::input, in_file(letters.font->string(), say("pdf.no_true_type")));
    if (letters.language == Language::japanese && !fonts.missing().empty() && !fonts.has_japanese())
        return fail(ErrorKind::output, in_file(name, say("pdf.no_japanese")));

    HPDF_SaveToStream(pdf.get());
    WrittenPdf written{std::vector<std::byte>(HPDF_GetStreamSize(pdf.get())), fonts.missing()};
    auto size = static_cast<HPDF_UINT32>(written.bytes.size());
    if (size > 0) HPDF_ReadFromStream(pdf.get(), reinterpret_cast<HPDF_BYTE*>(written.bytes.data()), &size);
    if (error != HPDF_OK || written.bytes.empty())
        return fail(ErrorKind::output,
                    in_file(name, say("pdf.not_made", {{"error", fmt::format("{:#x}", error)}})));
    written.bytes.resize(size);
    return written;
}

}  // namespace snug::cli

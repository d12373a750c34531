#include "cli/make_workshop.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "snug/words/words.h"

#include "cli/wrapped.h"
#include "cli/zip.h"

namespace snug::cli {

std::vector<std::string> workshop_folders() {
    std::vector<std::string> folders;
    for (const std::string_view name : names_of<Workshop>())
        if (!name.empty()) folders.emplace_back(name);
    return folders;
}

std::string workshop_summary(const WorkshopPack& pack, const Design& design, Language language) {
    std::size_t widest = 0;
    for (const PackFigure& figure : pack.figures)
        widest = std::max(widest, columns_of(text(figure.label, language)));
    const std::string_view work = name_of(design.workshop.work);
    std::string lines = text(say("summary.workshop", {{"work", work}}), language) + "\n";
    for (const PackFigure& figure : pack.figures)
        lines +=
            "  " + padded(text(figure.label, language), widest) + "  " + text(figure.value, language) + "\n";
    return lines;
}

Result<WorkshopFiles> workshop_files(const WorkshopPack& pack, const PdfLetters& letters) {
    WorkshopFiles made;
    std::vector<PackFile>& files = made.files;
    for (const PackFile& file : pack.files) files.push_back({file.name, file.bytes});
    for (const PackContainer& container : pack.containers) {
        auto bytes = write_zip(container);
        if (!bytes) return tl::unexpected(bytes.error());
        files.push_back({container.name, std::move(*bytes)});
    }
    for (const DrawingDocument& document : pack.documents) {
        auto written = write_pdf(document, letters);
        if (!written) return tl::unexpected(written.error());
        files.push_back({document.name + ".pdf", std::move(written->bytes)});
        if (made.findings.empty() && !written->missing.empty())
            made.findings.push_back(
                {Severity::note, say("letters_missing", {{"letters", written->missing}})});
    }
    return made;
}

}  // namespace snug::cli

#include "cli/pdf_fonts.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <string>
#include <system_error>

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

/// The best first. Collections and fonts of PostScript outlines, such as most of Noto, are none that libharu
/// reads.
constexpr const char* kFonts[] = {
    "ipag.ttf",          "ipaexg.ttf",    "TakaoGothic.ttf", "VL-Gothic-Regular.ttf", "mplus-1p-regular.ttf",
    "Arial Unicode.ttf", "DejaVuSans.ttf"};
constexpr int kDeepest = 4;

std::vector<fs::path> folders() {
    const char* const data = std::getenv("XDG_DATA_HOME");
    const char* const home = std::getenv("HOME");
    std::vector<fs::path> found;
    if (data && *data) found.push_back(fs::path(data) / "fonts");
    if (home && *home)
        for (const char* const folder : {".local/share/fonts", ".fonts", "Library/Fonts"})
            found.push_back(fs::path(home) / folder);
    for (const char* const folder :
         {"/usr/local/share/fonts", "/usr/share/fonts", "/Library/Fonts", "/System/Library/Fonts"})
        found.emplace_back(folder);
    return found;
}

}  // namespace

std::vector<fs::path> fonts_beyond_latin() {
    std::vector<fs::path> found(std::size(kFonts));
    for (const fs::path& folder : folders()) {
        std::error_code error;
        fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
        for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
            if (entry.depth() >= kDeepest) entry.disable_recursion_pending();
            const auto* const known =
                std::find(std::begin(kFonts), std::end(kFonts), entry->path().filename());
            if (known == std::end(kFonts)) continue;
            fs::path& kept = found[static_cast<std::size_t>(known - std::begin(kFonts))];
            if (kept.empty()) kept = entry->path();
        }
    }
    found.erase(std::remove(found.begin(), found.end(), fs::path()), found.end());
    return found;
}

}  // namespace snug::cli

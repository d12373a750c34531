#include <algorithm>
#include <string>
#include <string_view>

#include "snug/formats/read.h"
#include "snug/formats/text_scan.h"

namespace snug {
namespace {

constexpr const char* kExport = "foreign.export";
constexpr const char* kDownload = "foreign.download";

struct Foreign {
    std::string_view start;        ///< of the file; letters in lower case
    const char* what;              ///< code of what it is
    const char* advice = kExport;  ///< code of what to do
};

constexpr Foreign kForeign[] = {
    {"pk\x03\x04", "foreign.zip_or_3mf_file"},
    {"gltf", "foreign.gltf_file"},
    {"iso-10303-21", "foreign.step_file"},
    {"kaydara fbx", "foreign.fbx_file"},
    {"; fbx", "foreign.fbx_file"},
    {"blender", "foreign.blender_file"},
    {"astm-e57", "foreign.e57_scan"},
    {"lasf", "foreign.las_or_laz_scan"},
    {"# .pcd", "foreign.pcd_cloud", "foreign.export_cloud"},
    {"# vtk datafile", "foreign.vtk_file"},
    {"#vrml", "foreign.vrml_file"},
    {"draco", "foreign.draco_file"},
    {"solidworks", "foreign.solidworks_file"},
    {"\xd0\xcf\x11\xe0", "foreign.cad_or_office_document"},
    {"ac10", "foreign.dwg_drawing"},
    {"dbrep_drawable", "foreign.brep_file"},
    {"casca", "foreign.brep_file"},
    {"%pdf", "foreign.pdf_document"},
    {"\x89png", "foreign.picture_png"},
    {"\xff\xd8\xff", "foreign.picture_jpeg"},
    {"gif8", "foreign.picture_gif"},
    {"\x1f\x8b", "foreign.gzip_archive", "foreign.unpack"},
    {"7z\xbc\xaf\x27\x1c", "foreign.7_zip_archive", "foreign.unpack"},
    {"rar!", "foreign.rar_archive", "foreign.unpack"},
    {"<!doctype html", "foreign.web_page", kDownload},
    {"<html", "foreign.web_page", kDownload},
    {"version https://git-lfs", "foreign.git_lfs", kDownload},
    {"<collada", "foreign.collada_file"},
    {"<x3d", "foreign.x3d_file"},
    {"<amf", "foreign.amf_file"},
    {"<svg", "foreign.drawing_svg"},
};

bool starts_with(std::string_view text, std::string_view lower) {
    return same_word(text.substr(0, lower.size()), lower);
}

/// Behind "<?xml ...?>", comments and blanks; at most the first few kB are looked at.
std::string_view first_element(std::string_view text) {
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        const std::string_view end = starts_with(text, "<?") ? "?>" : starts_with(text, "<!--") ? "-->" : "";
        const std::size_t at = end.empty() ? std::string_view::npos : text.find(end);
        if (at == std::string_view::npos) return text;
        text.remove_prefix(at + end.size());
    }
}

}  // namespace

std::optional<Error> foreign_format(Bytes beginning) {
    constexpr std::size_t kLooked = 4096;
    std::string_view text(reinterpret_cast<const char*>(beginning.data()),
                          std::min(beginning.size(), kLooked));
    if (starts_with(text, "\xef\xbb\xbf")) text.remove_prefix(3);
    const auto is = [](const char* what, const char* advice) {
        return Error{ErrorKind::input, say("foreign", {{"what", say(what)}, {"advice", say(advice)}})};
    };
    for (const std::string_view view : {text, first_element(text)})
        for (const auto& [start, what, advice] : kForeign)
            if (starts_with(view, start)) return is(what, advice);
    const std::string_view element = first_element(text);
    if (starts_with(text, "<?xml") || starts_with(element, "<!doctype"))
        return is("foreign.xml_file", kExport);
    if (!element.empty() && element[0] == '{') {
        if (text.find("\"snug\"") != text.npos) return is("foreign.project", "foreign.make");
        return is("foreign.json_file", kExport);
    }
    return {};
}

}  // namespace snug

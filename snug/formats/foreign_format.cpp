#include <algorithm>
#include <string>
#include <string_view>

#include "snug/formats/read.h"
#include "snug/formats/text_scan.h"

namespace snug {
namespace {

constexpr const char* kExport = "export it as STL, OBJ or PLY instead";
constexpr const char* kDownload = "download the file itself again";

struct Foreign {
    std::string_view start;  ///< of the file; letters in lower case
    const char* what;
    const char* advice = kExport;
};

constexpr Foreign kForeign[] = {
    {"pk\x03\x04", "a zip or 3MF file"},
    {"gltf", "a glTF file"},
    {"iso-10303-21", "a STEP file"},
    {"kaydara fbx", "an FBX file"},
    {"; fbx", "an FBX file"},
    {"blender", "a Blender file"},
    {"astm-e57", "an E57 scan"},
    {"lasf", "a LAS or LAZ scan"},
    {"# .pcd", "a PCD cloud", "export it as PLY or XYZ instead"},
    {"# vtk datafile", "a VTK file"},
    {"#vrml", "a VRML file"},
    {"draco", "a Draco file"},
    {"solidworks", "a SolidWorks file"},
    {"\xd0\xcf\x11\xe0", "a CAD or Office document"},
    {"ac10", "a DWG drawing"},
    {"dbrep_drawable", "a BREP file"},
    {"casca", "a BREP file"},
    {"%pdf", "a PDF document"},
    {"\x89png", "a picture (PNG)"},
    {"\xff\xd8\xff", "a picture (JPEG)"},
    {"gif8", "a picture (GIF)"},
    {"\x1f\x8b", "a gzip archive", "unpack it first"},
    {"7z\xbc\xaf\x27\x1c", "a 7-Zip archive", "unpack it first"},
    {"rar!", "a RAR archive", "unpack it first"},
    {"<!doctype html", "a web page", kDownload},
    {"<html", "a web page", kDownload},
    {"version https://git-lfs", "a pointer of Git LFS and not the file", kDownload},
    {"<collada", "a COLLADA file"},
    {"<x3d", "an X3D file"},
    {"<amf", "an AMF file"},
    {"<svg", "a drawing (SVG)"},
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
    const auto is = [](const std::string& what, const char* advice) {
        return Error{ErrorKind::input, "this is " + what + ": " + advice};
    };
    for (const std::string_view view : {text, first_element(text)})
        for (const auto& [start, what, advice] : kForeign)
            if (starts_with(view, start)) return is(what, advice);
    const std::string_view element = first_element(text);
    if (starts_with(text, "<?xml") || starts_with(element, "<!doctype")) return is("an XML file", kExport);
    if (!element.empty() && element[0] == '{') {
        if (text.find("\"snug\"") != text.npos)
            return is("a project of Snug's", "make its foams with snug make, or inspect the object itself");
        return is("a JSON file", kExport);
    }
    return {};
}

}  // namespace snug

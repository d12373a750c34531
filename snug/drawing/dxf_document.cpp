#include "snug/drawing/dxf_document.h"

#include <utility>

#include "snug/base/text.h"

namespace snug {
namespace {

// Handles of what every file has; layers and entities follow.
enum Handle : unsigned {
    kNone,
    kViewports,
    kLinetypes,
    kLayers,
    kStyles,
    kViews,
    kCoordinateSystems,
    kApplications,
    kDimensionStyles,
    kBlockRecords,
    kViewport,
    kByBlock,
    kByLayer,
    kContinuous,
    kLayerZero,
    kStyle,
    kApplication,
    kDimensionStyle,
    kModelSpace,
    kPaperSpace,
    kModelBlock,
    kModelBlockEnd,
    kPaperBlock,
    kPaperBlockEnd,
    kRootDictionary,
    kGroups,
    kFirstFree,
};

std::string hexadecimal(unsigned value) {
    std::string text;
    do text.insert(text.begin(), "0123456789ABCDEF"[value % 16]);
    while ((value /= 16) > 0);
    return text;
}

std::string pair(int code, std::string_view value) {
    return std::to_string(code) + "\n" + std::string(value) + "\n";
}
std::string real(int code, double value) {
    return pair(code, number(value, 5));
}
std::string point(int code, Vec2d at) {
    return real(code, at.x) + real(code + 10, at.y);
}

/// What an entry or object begins with; entries name their table, objects their dictionary as their owner.
std::string object(std::string_view type, std::string_view handle, unsigned owner) {
    return pair(0, type) + pair(type == "DIMSTYLE" ? 105 : 5, handle) + pair(330, hexadecimal(owner));
}

std::string entry(std::string_view type, std::string_view handle, unsigned table, std::string_view subclass,
                  std::string_view name) {
    return object(type, handle, table) + pair(100, "AcDbSymbolTableRecord") + pair(100, subclass) +
           pair(2, name) + (type == "BLOCK_RECORD" ? "" : pair(70, "0"));
}

std::string table(std::string_view type, unsigned handle, std::size_t count, const std::string& entries) {
    std::string text = pair(0, "TABLE") + pair(2, type) + pair(5, hexadecimal(handle)) + pair(330, "0") +
                       pair(100, "AcDbSymbolTable") + pair(70, std::to_string(count));
    if (type == "DIMSTYLE") text += pair(100, "AcDbDimStyleTable") + pair(71, "0");
    return text + entries + pair(0, "ENDTAB");
}

std::string section(std::string_view name, const std::string& contents) {
    return pair(0, "SECTION") + pair(2, name) + contents + pair(0, "ENDSEC");
}

std::string header(Vec2d size, const std::string& next_handle) {
    return section("HEADER", pair(9, "$ACADVER") + pair(1, "AC1015") +               //
                                 pair(9, "$DWGCODEPAGE") + pair(3, "ANSI_1252") +    //
                                 pair(9, "$HANDSEED") + pair(5, next_handle) +       //
                                 pair(9, "$INSUNITS") + pair(70, "4") +              // millimetres
                                 pair(9, "$MEASUREMENT") + pair(70, "1") +           // metric
                                 pair(9, "$LUNITS") + pair(70, "2") +                // decimal
                                 pair(9, "$EXTMIN") + point(10, {}) + real(30, 0) +  //
                                 pair(9, "$EXTMAX") + point(10, size) + real(30, 0));
}

/// The view that shows the whole sheet.
std::string viewport(Vec2d size) {
    return entry("VPORT", hexadecimal(kViewport), kViewports, "AcDbViewportTableRecord", "*Active") +
           point(10, {}) + point(11, {1, 1}) + point(12, size * 0.5) + point(13, {}) + point(14, {1, 1}) +
           point(15, {1, 1}) + point(16, {}) + real(36, 1) + point(17, {}) + real(37, 0) +
           real(40, size.y > 0 ? size.y : 1) + real(41, size.y > 0 ? size.x / size.y : 1) + real(42, 50);
}

std::string linetype(unsigned handle, std::string_view name) {
    return entry("LTYPE", hexadecimal(handle), kLinetypes, "AcDbLinetypeTableRecord", name) + pair(3, "") +
           pair(72, "65") + pair(73, "0") + real(40, 0);
}

std::string layer(std::string_view handle, const DxfLayer& layer) {
    return entry("LAYER", handle, kLayers, "AcDbLayerTableRecord", layer.name) +
           pair(62, std::to_string(layer.color_number)) + pair(6, "Continuous");
}

std::string block(std::string_view name, unsigned record, unsigned begin, unsigned end, bool paper) {
    const auto part = [&](std::string_view type, unsigned handle, std::string_view subclass) {
        return object(type, hexadecimal(handle), record) + pair(100, "AcDbEntity") +
               (paper ? pair(67, "1") : "") + pair(8, "0") + pair(100, subclass);
    };
    return part("BLOCK", begin, "AcDbBlockBegin") + pair(2, name) + pair(70, "0") + point(10, {}) +
           real(30, 0) + pair(3, name) + pair(1, "") + part("ENDBLK", end, "AcDbBlockEnd");
}

std::string objects() {
    const auto dictionary = [](unsigned handle, unsigned owner) {
        return object("DICTIONARY", hexadecimal(handle), owner) + pair(100, "AcDbDictionary") +
               pair(281, "1");
    };
    return section("OBJECTS", dictionary(kRootDictionary, kNone) + pair(3, "ACAD_GROUP") +
                                  pair(350, hexadecimal(kGroups)) + dictionary(kGroups, kRootDictionary));
}

}  // namespace

DxfDocument::DxfDocument(Vec2d size_mm, std::vector<DxfLayer> layers)
    : size_(size_mm),
      layers_(std::move(layers)),
      next_handle_(kFirstFree + static_cast<unsigned>(layers_.size())) {}

std::string DxfDocument::new_handle() {
    return hexadecimal(next_handle_++);
}

void DxfDocument::begin_entity(std::string_view type, std::string_view layer, std::string_view subclass) {
    entities_ += object(type, new_handle(), kModelSpace) + pair(100, "AcDbEntity") + pair(8, layer) +
                 pair(100, subclass);
}

void DxfDocument::polyline(std::string_view layer, const std::vector<Vec2d>& points, bool closed) {
    begin_entity("LWPOLYLINE", layer, "AcDbPolyline");
    entities_ += pair(90, std::to_string(points.size())) + pair(70, closed ? "1" : "0");
    for (const Vec2d p : points) entities_ += point(10, p);
}

void DxfDocument::circle(std::string_view layer, Vec2d centre, double radius) {
    begin_entity("CIRCLE", layer, "AcDbCircle");
    entities_ += point(10, centre) + real(30, 0) + real(40, radius);
}

std::string DxfDocument::finish() {
    std::string layers = layer(hexadecimal(kLayerZero), {"0", 7});
    for (std::size_t i = 0; i < layers_.size(); ++i)
        layers += layer(hexadecimal(kFirstFree + static_cast<unsigned>(i)), layers_[i]);
    const std::string tables =
        table("VPORT", kViewports, 1, viewport(size_)) +
        table("LTYPE", kLinetypes, 3,
              linetype(kByBlock, "ByBlock") + linetype(kByLayer, "ByLayer") +
                  linetype(kContinuous, "Continuous")) +
        table("LAYER", kLayers, layers_.size() + 1, layers) +
        table("STYLE", kStyles, 1,
              entry("STYLE", hexadecimal(kStyle), kStyles, "AcDbTextStyleTableRecord", "Standard") +
                  real(40, 0) + real(41, 1) + real(50, 0) + pair(71, "0") + real(42, 2.5) + pair(3, "txt") +
                  pair(4, "")) +
        table("VIEW", kViews, 0, "") + table("UCS", kCoordinateSystems, 0, "") +
        table("APPID", kApplications, 1,
              entry("APPID", hexadecimal(kApplication), kApplications, "AcDbRegAppTableRecord", "ACAD")) +
        table("DIMSTYLE", kDimensionStyles, 1,
              entry("DIMSTYLE", hexadecimal(kDimensionStyle), kDimensionStyles, "AcDbDimStyleTableRecord",
                    "Standard")) +
        table("BLOCK_RECORD", kBlockRecords, 2,
              entry("BLOCK_RECORD", hexadecimal(kModelSpace), kBlockRecords, "AcDbBlockTableRecord",
                    "*Model_Space") +
                  entry("BLOCK_RECORD", hexadecimal(kPaperSpace), kBlockRecords, "AcDbBlockTableRecord",
                        "*Paper_Space"));
    const std::string blocks = block("*Model_Space", kModelSpace, kModelBlock, kModelBlockEnd, false) +
                               block("*Paper_Space", kPaperSpace, kPaperBlock, kPaperBlockEnd, true);
    return header(size_, hexadecimal(next_handle_)) + section("CLASSES", "") + section("TABLES", tables) +
           section("BLOCKS", blocks) + section("ENTITIES", entities_) + objects() + pair(0, "EOF");
}

}  // namespace snug

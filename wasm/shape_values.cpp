#include "wasm/shape_values.h"

#include "snug/formats/shape_text.h"

namespace snug::wasm {
namespace {

val numbers(std::initializer_list<double> values) {
    val list = val::array();
    for (const double value : values) list.call<void>("push", value);
    return list;
}

val size_val(const SimpleSolid& solid) {
    const Vec3d size = solid.size_mm;
    switch (solid.kind) {
        case SolidKind::box:
            return numbers({size.x, size.y, size.z});
        case SolidKind::cylinder:
            return numbers({size.x, size.z});
        case SolidKind::cone:
            return numbers({size.x, solid.top_mm, size.z});
        case SolidKind::ball:
            return numbers({size.x});
    }
    return val::null();
}

val solid_val(const SimpleSolid& solid) {
    val result = val::object();
    result.set("kind", std::string(name_of(solid.kind)));
    result.set("size", size_val(solid));
    result.set("radius", solid.radius_mm);
    result.set("along", std::string(1, solid.along));
    result.set("turn", to_val(solid.turn_deg));
    result.set("at", to_val(solid.centre_mm));
    return result;
}

}  // namespace

val shape_val(const std::string& text) {
    const auto solids = parse_shape(text);
    if (!solids) return to_val(solids.error());
    val list = val::array();
    for (const SimpleSolid& solid : *solids) list.call<void>("push", solid_val(solid));
    val result = val::object();
    result.set("solids", list);
    return result;
}

}  // namespace snug::wasm

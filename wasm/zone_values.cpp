#include "wasm/zone_values.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "snug/base/finding.h"
#include "snug/fabricate/kit/zone_text.h"

namespace snug::wasm {

val zones_val(const std::vector<ZoneReport>& zones, const Packing& packing) {
    const auto told = [&](std::string_view code, const ZoneReport& zone) {
        return std::any_of(packing.findings.begin(), packing.findings.end(), [&](const Finding& finding) {
            return finding.code() == code && finding.where && *finding.where == zone.where;
        });
    };
    val list = val::array();
    for (const ZoneReport& zone : zones) {
        val one = val::object();
        one.set("item", zone.item);
        one.set("number", zone.number);
        one.set("cut_blocks", static_cast<double>(zone.cut_blocks));
        one.set("text", to_val(zone_text(zone)));
        one.set("reached", told("zone_reached", zone));
        one.set("pressed", told("zone_pressed", zone));
        list.call<void>("push", one);
    }
    std::vector<Finding> findings;
    for (const Finding& finding : packing.findings)
        if (finding.code().starts_with("zone_")) findings.push_back(finding);
    val result = val::object();
    result.set("zones", list);
    result.set("findings", to_val(findings, packing.items));
    return result;
}

val part_numbers(const Object& object) {
    const std::vector<std::uint32_t>& parts = object.measure.part_of_triangle;
    if (!object.whole() || object.measure.parts.size() < 2) return val::null();
    std::vector<std::uint32_t> numbers(object.mesh.vertices.size(), 0);
    for (std::size_t i = 0; i < std::min(parts.size(), object.mesh.triangles.size()); ++i)
        for (const std::uint32_t vertex : object.mesh.triangles[i]) numbers[vertex] = parts[i] + 1;
    return typed_array(numbers.data(), numbers.size());
}

}  // namespace snug::wasm

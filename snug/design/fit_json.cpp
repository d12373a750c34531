#include "snug/design/fit_json.h"

#include <array>
#include <string>

namespace snug {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json notches_json(const NotchOptions& notches) {
    return {{"width_mm", notches.width_mm},
            {"depth_mm", notches.depth_mm},
            {"room_mm", notches.room_mm},
            {"axis", notches.axis ? Json(*notches.axis == 1 ? "y" : "z") : Json(nullptr)},
            {"first_mm", or_null(notches.first_mm)},
            {"second_mm", or_null(notches.second_mm)}};
}

void read_notches(JsonReader json, NotchOptions& notches, JsonReader& parent) {
    std::optional<std::string> axis;
    json.read("width_mm", notches.width_mm)
        .read("depth_mm", notches.depth_mm)
        .read("room_mm", notches.room_mm)
        .read("axis", axis)
        .read("first_mm", notches.first_mm)
        .read("second_mm", notches.second_mm);
    notches.axis.reset();
    if (axis == "y") notches.axis = 1;
    if (axis == "z") notches.axis = 2;
    if (axis && !notches.axis) json.refuse("axis", "y, z or null");
    parent.adopt(json);
}

}  // namespace

Json fit_json(const FitOptions& fit) {
    return {{"least_rib_mm", fit.least_rib_mm},
            {"notches", fit.notches ? notches_json(*fit.notches) : Json(nullptr)},
            {"creep_kpa", or_null(fit.creep_kpa)}};
}

void read_fit(JsonReader json, FitOptions& fit, JsonReader& parent) {
    json.read("least_rib_mm", fit.least_rib_mm).read("creep_kpa", fit.creep_kpa);
    if (json.is_null("notches")) {
        fit.notches.reset();
    } else if (json.has("notches")) {
        NotchOptions notches = fit.notches.value_or(NotchOptions{});
        read_notches(json.object("notches"), notches, json);
        fit.notches = notches;
    }
    parent.adopt(json);
}

Json clearance_json(const Clearance& clearance) {
    if (clearance.is_one()) return clearance.lower.x;
    return Json::array({clearance.lower.x, clearance.lower.y, clearance.lower.z, clearance.upper.x,
                        clearance.upper.y, clearance.upper.z});
}

void read_clearance(JsonReader& json, const char* name, Clearance& clearance) {
    constexpr const char* kExpected =
        "a number, or six in brackets (x, y, z of the lower foam, then of the upper)";
    std::optional<std::array<double, 6>> six;
    if (!json.has(name)) return;
    json.read_list(name, six, kExpected, true);
    if (!six) return json.refuse(name, kExpected);
    const auto& [a, b, c, d, e, f] = *six;
    clearance = {{a, b, c}, {d, e, f}};
}

}  // namespace snug

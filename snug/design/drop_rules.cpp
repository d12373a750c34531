#include "snug/design/drop_rules.h"

#include <array>
#include <span>

namespace snug {
namespace {

constexpr double kPound = 0.45359237;  // kg

/// Packs below so many pounds fall from this height.
struct Step {
    double below_lb;
    double height_mm;
};

constexpr Step kIsta1A[] = {{21, 760}, {41, 610}, {61, 460}, {100, 310}, {150, 200}};
constexpr Step kIsta2A[] = {{21, 970}, {41, 810}, {61, 660}, {100, 510}, {150, 310}};
// One face drop of the light ones is from 910 mm, of the others from 600.
constexpr Step kIsta3A[] = {{32 / kPound, 910}, {70 / kPound, 600}};
constexpr Step kD4169Two[] = {{20, 381}, {40, 330}, {60, 305}, {80, 254}, {100, 229}, {200, 178}};
constexpr Step kHandling[] = {{20, 1067}, {50, 914}, {250, 762}, {500, 610}, {1000, 457}, {1e9, 305}};

std::span<const Step> steps_of(DropRule rule) {
    switch (rule) {
        case DropRule::ista_1a:
            return kIsta1A;
        case DropRule::ista_2a:
            return kIsta2A;
        case DropRule::ista_3a:
            return kIsta3A;
        case DropRule::d4169_2:
            return kD4169Two;
        case DropRule::handling:
            return kHandling;
    }
    return {};
}

}  // namespace

std::string_view title_of(DropRule rule) {
    constexpr std::array<std::string_view, 5> kTitles{"ISTA 1A", "ISTA 2A", "ISTA 3A", "ASTM D4169 II",
                                                      "MIL-HDBK-304"};
    return kTitles[static_cast<std::size_t>(rule)];
}

bool is_verified(DropRule rule) {
    return rule == DropRule::ista_1a || rule == DropRule::ista_2a;
}

std::optional<double> drop_height_mm(DropRule rule, double gross_kg) {
    for (const Step& step : steps_of(rule))
        if (gross_kg < step.below_lb * kPound) return step.height_mm;
    return {};
}

double fragility_g(FragilityClass of) {
    constexpr std::array<double, 7> kLeast{25, 15, 25, 40, 60, 85, 115};
    return kLeast[static_cast<std::size_t>(of)];
}

std::string_view source_of(FragilityClass of) {
    switch (of) {
        case FragilityClass::museum:
            return "usual for an unknown object, no source";
        case FragilityClass::extremely_fragile:
        case FragilityClass::very_delicate:
            return "Gemstar technical brief";
        default:
            return "bands as published by makers of cushions, weak source";
    }
}

}  // namespace snug

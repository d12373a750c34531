#include "snug/design/zone.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

#include "snug/base/text.h"
#include "snug/design/clearance.h"
#include "snug/design/option.h"
#include "snug/design/option_text.h"

namespace snug {
namespace {

constexpr std::string_view kPart = "part=", kPress = "press=", kKpa = "kPa", kLoose = "loose";

/// "part=3", or one more of a ball's four numbers.
bool take_place(std::string_view word, Zone& zone, std::vector<double>& numbers) {
    if (!word.starts_with(kPart)) {
        const auto value = typed_number(word);
        if (value) numbers.push_back(*value);
        return value.has_value();
    }
    const auto part = typed_integer(word.substr(kPart.size()));
    if (!part || *part < 1 || zone.part != 0) return false;
    zone.part = *part;
    return true;
}

/// What follows a place: "15", "press=2kPa", "loose".
bool take_rule(std::string_view word, Zone& zone) {
    if (word == kLoose) return zone.loose = true;
    const bool press = word.starts_with(kPress);
    if (press) word.remove_prefix(kPress.size());
    if (press && word.ends_with(kKpa)) word.remove_suffix(kKpa.size());
    const auto value = typed_number(word);
    if (!value) return false;
    if (press)
        zone.press_kpa = *value;
    else
        zone.keep_off_mm = *value;
    return true;
}

bool take_balls(const std::vector<double>& numbers, Zone& zone) {
    if (numbers.size() % 4 != 0) return false;
    for (std::size_t i = 0; i < numbers.size(); i += 4)
        zone.balls.push_back({{numbers[i], numbers[i + 1], numbers[i + 2]}, numbers[i + 3]});
    return true;
}

bool in_range(const Zone::Ball& ball) {
    constexpr Range kPlace{-kFarthestPlace, kFarthestPlace};
    constexpr Range kRadius{.least = 0, .most = kGreatestLength, .above = true};
    return kPlace.has(ball.centre.x) && kPlace.has(ball.centre.y) && kPlace.has(ball.centre.z) &&
           kRadius.has(ball.radius_mm);
}

std::optional<Message> problem_of(const Zone& zone, const std::string& number) {
    if ((zone.balls.empty() && zone.part == 0) || zone.part < 0)
        return say("zone.no_place", {{"zone", number}, {"example", "10,20,30,25:15"}});
    if (zone.balls.size() > kMostBalls)
        return say("zone.many_balls", {{"zone", number}, {"most", std::to_string(kMostBalls)}});
    if (!std::all_of(zone.balls.begin(), zone.balls.end(), in_range))
        return say("zone.ball", {{"zone", number}});
    if (!Range{0, kMostKeepOff}.has(zone.keep_off_mm))
        return say("zone.keep_off", {{"zone", number}, {"most", snug::number(kMostKeepOff, 0)}});
    if (zone.press_kpa && !kAbove0.has(*zone.press_kpa)) return say("zone.press", {{"zone", number}});
    if (zone.loose && zone.press_kpa) return say("zone.loose_pressed", {{"zone", number}});
    if (zone.keep_off_mm == 0 && !zone.press_kpa) return say("zone.no_rule", {{"zone", number}});
    return {};
}

std::string text_of(const Zone& zone) {
    std::string text;
    for (const Zone::Ball& ball : zone.balls)
        text += "," + exact({ball.centre.x, ball.centre.y, ball.centre.z, ball.radius_mm}, ',');
    if (zone.part != 0) text += "," + std::string(kPart) + std::to_string(zone.part);
    if (!text.empty()) text.erase(0, 1);
    if (zone.keep_off_mm != 0 || !zone.press_kpa) text += ":" + exact(zone.keep_off_mm);
    if (zone.press_kpa) text += ":" + std::string(kPress) + exact(*zone.press_kpa) + std::string(kKpa);
    return text + (zone.loose ? ":" + std::string(kLoose) : "");
}

}  // namespace

std::optional<Zones> typed_zones(std::string_view text) {
    Zones zones;
    Zone zone;
    std::vector<double> numbers;
    for (const std::string_view word : words_between(text, ',')) {
        const auto rules = words_between(word, ':');
        if (rules.empty() || !take_place(rules.front(), zone, numbers)) return {};
        if (rules.size() == 1) continue;  // its place goes on
        for (std::size_t i = 1; i < rules.size(); ++i)
            if (!take_rule(rules[i], zone)) return {};
        if (!take_balls(numbers, zone)) return {};
        zones.push_back(std::move(zone));
        zone = {};
        numbers.clear();
    }
    if (zones.empty() || zone.part != 0 || !numbers.empty()) return {};
    return zones;
}

std::optional<std::string> text_of(const Zones& zones) {
    std::optional<std::string> text;
    for (const Zone& zone : zones) text = text ? *text + "," + text_of(zone) : text_of(zone);
    return text;
}

std::optional<Message> problem_of(const Zones& zones) {
    if (zones.size() > kMostZones) return say("zone.many", {{"most", std::to_string(kMostZones)}});
    for (std::size_t i = 0; i < zones.size(); ++i)
        if (auto problem = problem_of(zones[i], std::to_string(i + 1))) return problem;
    return {};
}

}  // namespace snug

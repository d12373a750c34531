#include "snug/design/cases.h"

namespace snug {
namespace {

constexpr double kInch = 25.4;

constexpr const char* kHardCaseSource = "published list of interior sizes, 2024; makers differ by 1 to 5 mm";
constexpr const char* kInchCaseSource = "published case data in inches; makers differ by 1 to 5 mm";
constexpr const char* kUnchecked = "common stock size, not checked against a maker";

KnownCase hard_case(const char* name, double length, double width, double height,
                    const char* source = kHardCaseSource) {
    KnownCase known;
    known.name = name;
    known.kind = "hard case";
    known.maker = "Peli";
    known.inside_mm = {height, width, length};
    known.source = source;
    return known;
}

KnownCase parcel_class(const char* name, const char* carrier, double most_kg, Vec3d inside_mm,
                       const char* source) {
    KnownCase known;
    known.name = name;
    known.kind = "parcel class";
    known.inside_mm = inside_mm;
    known.most_kg = most_kg;
    known.carrier = carrier;
    known.source = source;
    return known;
}

KnownCase cube(int inches) {
    KnownCase known;
    known.name = "cube-" + std::to_string(inches) + "in";
    known.kind = "carton";
    known.inside_mm = Vec3d{1, 1, 1} * (inches * kInch);
    known.source = kUnchecked;
    return known;
}

std::vector<KnownCase> make_list() {
    std::vector<KnownCase> list{hard_case("1010", 111, 73, 43),
                                hard_case("1020", 135, 90, 43),
                                hard_case("1040", 165, 98, 44),
                                hard_case("1050", 160, 93, 70),
                                hard_case("1060", 210, 108, 57),
                                hard_case("1120", 185, 121, 85),
                                hard_case("1150", 211, 147, 95),
                                hard_case("1170", 268, 153, 80),
                                hard_case("1200", 235, 181, 105),
                                hard_case("1300", 233, 178, 155),
                                hard_case("1400", 300, 225, 132),
                                hard_case("1430", 344, 146, 297),
                                hard_case("1450", 372, 260, 155),
                                hard_case("1470", 399, 272, 98),
                                hard_case("1500", 425, 284, 155),
                                hard_case("1440", 434, 191, 406),
                                hard_case("1507Air", 385, 289, 216),
                                hard_case("1557Air", 440, 330, 248),
                                hard_case("iM2050", 241, 191, 108),
                                hard_case("iM2075", 241, 191, 184),
                                hard_case("iM2100", 330, 234, 152),
                                hard_case("iM2200", 381, 267, 152),
                                hard_case("iM2275", 359, 335, 251),
                                hard_case("iM2300", 432, 297, 157),
                                hard_case("1510", 502, 279, 193, kInchCaseSource),
                                hard_case("1600", 544, 419, 200, kInchCaseSource),
                                hard_case("1650", 726, 445, 271, kInchCaseSource),
                                hard_case("1700", 908, 343, 133, kInchCaseSource),
                                hard_case("1720", 1067, 343, 133, kInchCaseSource),
                                hard_case("1750", 1283, 343, 133, kInchCaseSource),
                                hard_case("1550", 473, 360, 196, "one weak source")};
    const char* const mail = "carrier's greatest sizes, from guides of 2024";
    list.push_back(parcel_class("royal-mail-small", "Royal Mail", 2, {160, 350, 450}, mail));
    list.push_back(parcel_class("royal-mail-medium", "Royal Mail", 20, {460, 460, 610}, mail));
    const char* const box = "carrier's box, inside";
    const auto usps = [&](const char* name, Vec3d inches) {
        list.push_back(parcel_class(name, "USPS flat rate", 31.8, inches * kInch, box));
    };
    usps("usps-small", {1.625, 5.375, 8.625});
    usps("usps-medium-1", {5.5, 8.5, 11});
    usps("usps-medium-2", {3.375, 11.875, 13.625});
    usps("usps-large", {5.5, 12, 12});
    const auto fedex = [&](const char* name, Vec3d inches) {
        list.push_back(parcel_class(name, "FedEx", 9.1, inches * kInch, box));
    };
    fedex("fedex-small", {1.5, 10.875, 12.375});
    fedex("fedex-medium", {2.375, 11.5, 13.25});
    fedex("fedex-large", {3, 12.38, 17.88});
    for (const int inches : {4, 6, 8, 10, 12, 14, 16, 18, 20, 24}) list.push_back(cube(inches));
    return list;
}

}  // namespace

const std::vector<KnownCase>& built_in_cases() {
    static const std::vector<KnownCase> list = make_list();
    return list;
}

}  // namespace snug

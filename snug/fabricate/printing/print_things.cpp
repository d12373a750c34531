#include "snug/fabricate/printing/print_things.h"

#include <utility>

#include "snug/base/box.h"
#include "snug/base/text.h"
#include "snug/fabricate/printing/print_bed.h"
#include "snug/fabricate/printing/print_solid.h"
#include "snug/fabricate/printing/threemf.h"

namespace snug {
namespace {

constexpr std::size_t kMostParts = 1000;  // more are printed by nobody
constexpr Color kDowelGrey{150, 150, 150};

Vec3d size_of(const Solid& solid) {
    Box3d box;
    for (const Vec3f v : solid.vertices) box.include(vec_cast<double>(v));
    return box.max;
}

Result<void> check_part_count(std::size_t parts, Vec3d bed) {
    if (parts <= kMostParts) return {};
    return fail(ErrorKind::usage,
                say("print.too_many_parts", {{"bed", dimensions(bed)}, {"most", kMostParts}}));
}

}  // namespace

std::string two_digits(std::size_t value) {
    return (value < 10 ? "0" : "") + std::to_string(value);
}

Result<void> check_part_count(const PrintCuts& cuts, Vec3d bed) {
    return check_part_count(static_cast<std::size_t>(1LL * cuts.pieces(0) * cuts.pieces(1) * cuts.pieces(2)),
                            bed);
}

Result<void> check_part_count(const PrintLayout& layout, Vec3d bed) {
    return check_part_count(layout.parts.size(), bed);
}

void add_dowels(std::size_t bores, const PrintOptions& options, std::vector<PrintThing>& things) {
    if (bores > 0) things.push_back({"dowel", kDowelGrey, dowel_solid(options), static_cast<int>(bores)});
}

Message dowels_text(std::size_t bores, const PrintOptions& options) {
    return say("figure.dowels_of", {{"dowels", std::to_string(bores)},
                                    {"diameter_mm", number(options.dowel_diameter_mm)},
                                    {"length_mm", number(options.dowel_length_mm)}});
}

Finding no_dowel_finding(const char* code, int pairs, const PrintOptions& options) {
    return {Severity::note, say(code, {{"diameter_mm", number(options.dowel_diameter_mm)},
                                       {"length_mm", number(options.dowel_length_mm)},
                                       {"pairs", pairs}})};
}

std::size_t add_beds(const std::vector<PrintThing>& things, Vec3d bed_mm, const std::string& title,
                     const std::string& folder, const std::string& name, WorkshopPack& pack) {
    std::vector<const PrintThing*> each;
    std::vector<Vec3d> sizes;
    for (const PrintThing& thing : things) {
        each.insert(each.end(), static_cast<std::size_t>(thing.count), &thing);
        sizes.insert(sizes.end(), static_cast<std::size_t>(thing.count), size_of(thing.solid));
    }
    const std::vector<BedPlace> places = places_on_beds(sizes, bed_mm);
    std::vector<std::vector<ThreeMfItem>> beds;
    for (std::size_t i = 0; i < each.size(); ++i) {
        const auto bed = static_cast<std::size_t>(places[i].bed);
        if (beds.size() <= bed) beds.resize(bed + 1);
        beds[bed].push_back({each[i]->name, each[i]->color, &each[i]->solid, {places[i].x, places[i].y, 0}});
    }
    for (std::size_t bed = 0; bed < beds.size(); ++bed)
        pack.containers.push_back(
            three_mf(folder + "/" + name + "-" + two_digits(bed + 1) + ".3mf", title, beds[bed]));
    return beds.size();
}

void add_stls(const std::vector<PrintThing>& things, const std::string& folder, WorkshopPack& pack) {
    for (const PrintThing& thing : things)
        pack.files.push_back({folder + "/" + thing.name + ".stl",
                              write_stl(thing.solid.vertices, thing.solid.triangles, thing.name)});
}

}  // namespace snug

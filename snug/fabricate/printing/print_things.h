#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/print_options.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/fabricate/printing/print_joints.h"
#include "snug/fabricate/printing/print_parts.h"
#include "snug/formats/mesh_files.h"
#include "snug/solid/solid.h"

// What every pack for a 3D printer does with its solids: onto beds, into files.

namespace snug {

/// Something to print, so many times; it lies from the origin into the positive octant, z upwards, in mm.
struct PrintThing {
    std::string name;
    Color color;
    Solid solid;
    int count = 1;
};

/// "01"
[[nodiscard]] std::string two_digits(std::size_t value);

/// The pieces of a half, or why that are more than anyone prints.
[[nodiscard]] Result<void> check_part_count(const PrintCuts& cuts, Vec3d bed_mm);
[[nodiscard]] Result<void> check_part_count(const PrintLayout& layout, Vec3d bed_mm);

/// As many loose dowels as there are bores; none where there are none.
void add_dowels(std::size_t bores, const PrintOptions& options, std::vector<PrintThing>& things);
/// "12 of 6 x 24 mm"
[[nodiscard]] Message dowels_text(std::size_t bores, const PrintOptions& options);
/// What to do where pairs of parts meet without a dowel; `stuff` is what a dowel needs around it.
[[nodiscard]] Finding no_dowel_finding(const char* code, int pairs, const PrintOptions& options);

/// One 3MF for each bed, "folder/name-01.3mf"; returns how many.
std::size_t add_beds(const std::vector<PrintThing>& things, Vec3d bed_mm, const std::string& title,
                     const std::string& folder, const std::string& name, WorkshopPack& pack);
/// One STL for each thing, "folder/lower-01.stl".
void add_stls(const std::vector<PrintThing>& things, const std::string& folder, WorkshopPack& pack);

}  // namespace snug

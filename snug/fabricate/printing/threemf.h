#pragma once

#include <span>
#include <string>

#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/formats/mesh_files.h"
#include "snug/solid/solid.h"

namespace snug {

/// An object on the bed. Several may show the same solid.
struct ThreeMfItem {
    std::string name;  ///< UTF-8
    Color color;
    const Solid* solid = nullptr;
    Vec3d at_mm;  ///< of the solid's origin
};

/// The members of a 3MF file (core specification 1.4): millimetres, a material of each colour, an object for
/// each solid, a build item for each item. The same bytes for the same items.
[[nodiscard]] PackContainer three_mf(std::string file_name, const std::string& title,
                                     std::span<const ThreeMfItem> items);

}  // namespace snug

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/project.h"

// An object as it is typed, with choices of its own: "lens.stl:count=2,mass=0.6,move=0x40x0".

namespace snug {

struct ObjectArgument {
    std::string file;
    std::vector<std::pair<std::string, std::string>> choices;  ///< "move", "0x40x0"
};

/// Takes the choices off behind the first colon that any follow. A text without any, such as "C:/a.stl", is a
/// file alone.
[[nodiscard]] ObjectArgument object_argument(std::string_view text);

/// Objects and items from what was typed, one after the other; the design is that of the other flags. Files
/// that are typed twice with equal choices of the object are one object. Choices of an object are the
/// table's flags for objects without their dashes ("units=m"); of an item the words of item_options.h, and
/// besides `count` and `upright` (x, y, z, -x, -y, -z: the file's axis that points up). Errors are of kind
/// `usage` and name the file and the choice. `files`: the path of each object, in the project's order.
[[nodiscard]] Result<Project> with_objects(std::span<const ObjectArgument> arguments, Design design,
                                           std::vector<std::string>& files);

/// What to type for the project's items, one after the other: "lens.stl:count=2,mass=0.6" for two of an
/// object that follow each other. `files`: of each object. An item's name with a colon in it cannot be typed
/// and is left out.
[[nodiscard]] std::vector<std::string> typed_items(const Project& project,
                                                   std::span<const std::string> files);

/// Whether an item without a place of its own lies beside others, so that somebody must arrange them, or they
/// stand in a row.
[[nodiscard]] bool wants_arrangement(const Design& design);

}  // namespace snug

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/scene_tools.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Which of a bundle's files is the object: a mesh, a scene or a cloud by its name's ending. Of several the
/// one in the fewest folders counts, and of those the first; hidden files and those that only one system
/// writes are none.
struct BundleObject {
    std::size_t file = 0;
    std::vector<std::string> left_out;  ///< names of the other objects
};

/// Fails (input) where no file is an object. `names` are UTF-8, folders parted by slashes.
[[nodiscard]] Result<BundleObject> find_bundle_object(const std::vector<std::string>& names);

/// The project of a pack that Snug made and somebody zipped.
struct PackedProject {
    std::string text;         ///< of its file
    std::string object;       ///< name of the one that it is of, without folders
    bool has_object = false;  ///< it is in the zip, too
};

/// None: the zip is of something else. Fails (input) where it cannot be read as a zip.
[[nodiscard]] Result<std::optional<PackedProject>> find_packed_project(Bytes zip, const SceneTools& tools);

/// Reads a file by its content, then its name without folders; not a zip.
using ReadFile = std::function<Result<Mesh>(Bytes file, std::string_view name, const SceneTools& tools)>;

/// The mesh of a zip: a 3MF (read_3mf), or a bundle of one object and what it needs, which is taken from the
/// zip, too; the rest is passed over. In a pack that Snug made it is the object that its project names, never
/// a foam. A zip in a zip is read where it is a 3MF. Names of other objects go to
/// Mesh::read.left_out_objects. Errors of kind `input`, without the zip's name.
[[nodiscard]] Result<Mesh> read_zip(Bytes file, const SceneTools& tools, const ReadFile& read);

}  // namespace snug

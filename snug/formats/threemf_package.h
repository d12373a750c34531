#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "snug/formats/scene_tools.h"
#include "snug/formats/zip_read.h"

namespace snug {

/// The package around a 3MF's models: parts in a zip, found by relationships (Open Packaging Conventions,
/// ECMA-376 part 2). Names of parts are equal without regard to the case of ASCII letters, to a leading
/// slash, to percent-encoding and to the way of the slashes.
class ThreeMfPackage {
  public:
    /// The bytes must outlive the package.
    [[nodiscard]] static Result<ThreeMfPackage> open(Bytes file, const SceneTools& tools);

    /// The name of the model that the package starts with, as part_name() gives it; none where this is no
    /// 3MF. Of several the one that is named last.
    [[nodiscard]] Result<std::optional<std::string>> root();

    [[nodiscard]] bool has(std::string_view part) const { return parts_.count(part) > 0; }
    [[nodiscard]] Result<FileBytes> read(std::string_view part);

    /// The one spelling of a part's name by which parts are found.
    [[nodiscard]] static std::string part_name(std::string_view written);

  private:
    explicit ThreeMfPackage(ZipReader zip);
    [[nodiscard]] Result<std::optional<std::string>> named_root();

    ZipReader zip_;
    std::map<std::string, std::size_t, std::less<>> parts_;  // by name, members of the zip
};

}  // namespace snug

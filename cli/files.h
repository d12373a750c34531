#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/project.h"

namespace snug::cli {

/// The bytes of a file, or an Error of kind `input` that names it.
[[nodiscard]] Result<std::vector<std::byte>> read_file(const std::filesystem::path& path);

/// Name, size and hash, as a project file keeps them.
[[nodiscard]] ObjectFile describe(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A set of files that appears as a whole or not at all: each is written beside its place under a temporary
/// name, and only when all are on the disk do they take their names. Destroying an uncommitted set takes
/// everything away again, folders that it made included. Errors are of kind `output`, or `cancelled` after
/// Ctrl-C.
class FileSet {
  public:
    explicit FileSet(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~FileSet();
    FileSet(const FileSet&) = delete;
    FileSet& operator=(const FileSet&) = delete;

    [[nodiscard]] Result<void> open();
    /// `name` may lie in a folder of its own within the set's ("sponge/lower-01.svg").
    [[nodiscard]] Result<void> write(const std::string& name, std::span<const std::byte> bytes);
    [[nodiscard]] Result<void> commit();
    /// The name under which a file is written first, in the folder where it will lie: `.NAME.PID.part`.
    [[nodiscard]] static std::string temporary_name(const std::string& name);
    /// Whether a file has taken its name, even if a later one could not.
    [[nodiscard]] bool begun() const { return renamed_ > 0; }

  private:
    [[nodiscard]] Result<void> make_folder(const std::filesystem::path& folder);

    struct Pending {
        std::filesystem::path temporary;
        std::filesystem::path final;
    };
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> made_folders_;  ///< outermost first
    std::vector<Pending> pending_;
    std::size_t renamed_ = 0;
    bool committed_ = false;
};

/// Writes one file, whole or not at all.
[[nodiscard]] Result<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace snug::cli

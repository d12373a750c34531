#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"

#include "cli/descriptor.h"

namespace snug::cli {

/// A folder, held open, and what lies inside it. Nothing here follows a symbolic link, so nothing reaches
/// out of the folder, whatever names it is given. Names are relative, with '/' between parts.
class FolderInside {
  public:
    /// An Error of kind `output` where it cannot be opened.
    [[nodiscard]] static Result<FolderInside> open(const std::filesystem::path& folder);

    /// Waits until no other run of the program holds the folder, and holds it until this object goes. Where
    /// the file system knows no locks it does not wait. Fails with kind `output` after `seconds`, with kind
    /// `cancelled` after Ctrl-C.
    [[nodiscard]] Result<void> lock(double seconds);

    enum class State { missing, other, file };
    struct Found {
        State state = State::missing;  ///< `other`: no plain file, or behind a link
        std::uint64_t bytes = 0;       ///< of a file
        bool removable = false;        ///< a file, in a folder that may be written to
        std::uint64_t device = 0, inode = 0;
    };
    [[nodiscard]] Found find(const std::string& name) const;
    /// The bytes of a file of at most `most` bytes; none where that is not what is there.
    [[nodiscard]] std::optional<std::string> read(const std::string& name, std::uint64_t most) const;
    /// The hash of a file; none where there is no file or Ctrl-C was pressed.
    [[nodiscard]] std::optional<std::string> sha256(const std::string& name) const;

    /// The names of what killed runs left in this or one of its folders ("" is itself): `.NAME.PID.part`
    /// where no process has that number, or this one has it and the name is not among `own`.
    [[nodiscard]] std::vector<std::string> leftovers(const std::string& folder,
                                                     const std::vector<std::string>& own) const;

    /// Gives a file a second name in its folder, NAME.old or, where that is taken, NAME.old2 and so on: the
    /// name, or none where that cannot be done.
    [[nodiscard]] std::optional<std::string> link_as_old(const std::string& name) const;
    /// 0 or the error number; a file that is gone already is none.
    [[nodiscard]] int remove_file(const std::string& name) const;
    /// Takes a folder away if it is empty.
    void remove_if_empty(const std::string& folder) const;

  private:
    explicit FolderInside(Descriptor root, std::filesystem::path path)
        : root_(std::move(root)), path_(std::move(path)) {}
    [[nodiscard]] Descriptor folder_of(std::string_view& name) const;
    [[nodiscard]] Descriptor file(const std::string& name) const;

    Descriptor root_;
    std::filesystem::path path_;
};

}  // namespace snug::cli

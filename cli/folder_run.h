#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/result.h"

#include "cli/files.h"
#include "cli/folder_inside.h"
#include "cli/manifest.h"

// A folder holds the files of one run. What a run made stands in the hidden list `.snug-files`; the next run
// into the folder takes away what the list names and it does not make again, if the bytes are still those
// that were written, and nothing else.
//
// The order, and what a kill after each step leaves:
//
//   1. every file is written beside its place, the two lists with them      leftovers; the earlier run, whole
//   2. the folder is locked, and what earlier runs left is looked at        the same
//   3. UNFINISHED.txt takes its name: a sentence for people, and all that
//      this run makes (and what is still known of runs killed here before)  the same, under a warning
//   4. the new files take their names; what stands there and is not as a
//      run wrote it gets a second name first, NAME.old                     a mix, under a warning
//   5. what is left of earlier runs is taken away                          a mix, under a warning
//   6. `.snug-files` takes its name                                        the new run, under a warning
//   7. UNFINISHED.txt is taken away                                        the new run
//
// Whatever stands in the folder is in one of the two lists at any moment, so the next run that ends takes all
// of it away. Up to 3 a failure or Ctrl-C changes nothing; in 4 it leaves the earlier run's files that have
// no successor. Only 5 removes files, and only those that were seen to be an earlier run's in 2.

namespace snug::cli {

class FolderRun {
  public:
    /// `pack_folders`: where else in the folder earlier runs may have been killed. `inputs`: files that this
    /// run has read, which stay even where an earlier run made them.
    FolderRun(std::filesystem::path folder, std::vector<std::string> pack_folders,
              std::vector<std::filesystem::path> inputs);

    // Errors of all of them are of kind `output`, or `cancelled` after Ctrl-C, before which nothing changed.
    [[nodiscard]] Result<void> open();
    [[nodiscard]] Result<void> write(const std::string& name, std::span<const std::byte> bytes);
    /// Step 2; `to_come` are the names that are still to be written. What a person must know: files of
    /// earlier runs that go (`earlier_files`, note) or stay (`earlier_files_stay`, warning), files of others
    /// that make room (`earlier_files_kept`, warning), an unfinished run (`earlier_unfinished`, note), a list
    /// that cannot be trusted (`earlier_unknown`, warning). Fails where a file that was read, other than a
    /// project, would be written over.
    [[nodiscard]] Result<std::vector<Finding>> look_back(std::span<const std::string> to_come);
    /// Steps 3 to 7, after look_back().
    [[nodiscard]] Result<void> commit();

  private:
    void sort_out(const std::vector<std::string>& names);
    [[nodiscard]] Result<void> find_foreign(const std::vector<std::string>& names);
    [[nodiscard]] Result<void> keep_foreign();
    [[nodiscard]] bool is_as_written(const std::string& name, const FolderInside::Found& found,
                                     std::span<const MadeFile> written) const;
    [[nodiscard]] bool is_input(const FolderInside::Found& found) const;
    [[nodiscard]] std::vector<Finding> findings() const;
    [[nodiscard]] Result<void> take_away();

    std::filesystem::path folder_;
    std::vector<std::string> pack_folders_;
    std::vector<std::filesystem::path> inputs_;
    FileSet set_;
    std::optional<FolderInside> inside_;  ///< from look_back() on
    std::vector<MadeFile> made_;
    std::vector<MadeFile> earlier_;     ///< what the lists of earlier runs name
    std::vector<MadeFile> unfinished_;  ///< of them, what a run that was killed had begun to make
    bool was_unfinished_ = false, untrusted_ = false;
    std::vector<std::string> gone_;                    ///< to be taken away
    std::vector<std::string> foreign_;                 ///< would be written over, and nobody wrote them
    std::vector<std::string> kept_;                    ///< the second names of those
    std::vector<std::string> changed_, read_, fixed_;  ///< stay: changed since, inputs, not removable
    std::vector<MadeFile> staying_;                    ///< the entries of those
};

}  // namespace snug::cli

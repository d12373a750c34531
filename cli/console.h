#pragma once

#include <string>
#include <string_view>

#include "snug/base/progress.h"
#include "snug/base/result.h"

namespace snug::cli {

/// The exit status for a kind of error.
[[nodiscard]] int exit_status(ErrorKind kind);

/// Prints "snug: sentence" to standard error and gives the exit status.
int report(const Error& error);

/// Text to standard output; an Error of kind `output` where nobody takes it.
[[nodiscard]] Result<void> print(std::string_view text);

/// One changing line on standard error while long work runs; silent where that is no terminal or `quiet` is
/// set.
class StatusLine {
  public:
    explicit StatusLine(bool quiet);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    void show(const std::string& text);
    /// A progress callback that shows `text` with percents.
    [[nodiscard]] Progress progress(std::string text);

  private:
    bool visible_;
    std::string shown_;
};

}  // namespace snug::cli

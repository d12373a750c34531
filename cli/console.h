#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/words/words.h"

namespace snug::cli {

/// The exit status for a kind of error.
[[nodiscard]] int exit_status(ErrorKind kind);

/// Prints "snug: sentence" on one line of standard error, without what would steer a terminal (names of files
/// may hold anything), and gives the exit status.
int report(const Error& error, Language language);

/// Runs a command; where memory does not suffice for an object, that is a sentence of kind `input`, too.
int within_memory(const std::string& object, Language language, const std::function<int()>& command);

/// Text to standard output; an Error of kind `output` where nobody takes it.
[[nodiscard]] Result<void> print(std::string_view text);

/// One changing line on standard error while long work runs; silent where that is no terminal or `quiet` is
/// set.
class StatusLine {
  public:
    StatusLine(bool quiet, Language language);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    void show(const Message& message);
    /// A progress callback that shows what is worked on with percents.
    [[nodiscard]] Progress progress(Message work);

  private:
    void show_text(const std::string& text);

    bool visible_;
    Language language_;
    std::string shown_;
};

}  // namespace snug::cli

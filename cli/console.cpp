#include "cli/console.h"

#include <cstdio>
#include <new>
#include <unistd.h>

#include <fmt/core.h>

#include "snug/base/one_line.h"
#include "snug/words/words.h"

#include "cli/commands.h"

namespace snug::cli {

int exit_status(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return kWrongUsage;
        case ErrorKind::input:
            return kBadInput;
        case ErrorKind::does_not_fit:
            return kDoesNotFit;
        case ErrorKind::output:
            return kCannotWrite;
        case ErrorKind::cancelled:
            return kCancelled;
    }
    return kBadInput;
}

int report(const Error& error, Language language) {
    std::fputs(fmt::format("snug: {}\n", one_line(text(error.message, language))).c_str(), stderr);
    return exit_status(error.kind);
}

int within_memory(const std::string& object, Language language, const std::function<int()>& command) {
    try {
        return command();
    } catch (const std::bad_alloc&) {
        return report({ErrorKind::input, in_file(object, say("file.no_memory"))}, language);
    }
}

Result<void> print(std::string_view text) {
    const bool written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!written) return fail(ErrorKind::output, say("console.no_output"));
    return {};
}

StatusLine::StatusLine(bool quiet, Language language)
    : visible_(!quiet && isatty(STDERR_FILENO) != 0), language_(language) {}

StatusLine::~StatusLine() {
    show_text("");
}

void StatusLine::show(const Message& message) {
    show_text(text(message, language_));
}

void StatusLine::show_text(const std::string& text) {
    if (!visible_ || text == shown_) return;
    std::fputs(fmt::format("\r\033[K{}", one_line(text)).c_str(), stderr);
    std::fflush(stderr);
    shown_ = text;
}

Progress StatusLine::progress(Message work) {
    return [this, work = std::move(work)](double fraction) {
        show(say("status.percent", {{"work", work}, {"percent", fmt::format("{:.0f}", fraction * 100)}}));
        return true;
    };
}

}  // namespace snug::cli

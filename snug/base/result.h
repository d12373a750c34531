#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "snug/base/message.h"

namespace snug {

/// What kind of trouble stopped the work. The command line turns each into its exit status.
enum class ErrorKind {
    usage,         ///< an option that has no meaning, or a number outside its range
    input,         ///< the object or project is unreadable, invalid or of implausible size
    does_not_fit,  ///< the object does not fit the design space
    output,        ///< a file cannot be written
    cancelled,     ///< the caller asked to stop
};

/// One sentence for the person who works with Snug: what is wrong, where, and what to do.
struct Error {
    Error() = default;
    Error(ErrorKind kind_, Message message_) : kind(kind_), message(std::move(message_)) {}

    ErrorKind kind = ErrorKind::input;
    Message message;
};

/// A value, or the sentence that says why there is none.
template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] tl::unexpected<Error> fail(ErrorKind kind, Message message);

}  // namespace snug

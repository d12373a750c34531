#include "snug/base/result.h"

namespace snug {

tl::unexpected<Error> fail(ErrorKind kind, Message message) {
    return tl::unexpected<Error>(Error{kind, std::move(message)});
}

}  // namespace snug

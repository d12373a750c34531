#pragma once

#include <cstddef>
#include <span>

#include "snug/search/arrange.h"

namespace snug {

/// As many of one item as go into the space that is given, beside all that is there: copies of it join the
/// design, which is then arranged anew but for what is locked; where it names no walls with the thickest of
/// the usual ones that what is there goes in with. How many is found by trying ever more, so a few that would
/// have needed a longer look may be missing. `watch.better` is told of every number that goes in. The same
/// for the same seed on every machine, unless cancelled: then it is the most that went in until then. Objects
/// are prepared for many. Fails with kind `usage` where no space is given or there is no such item, and as
/// arrange() does where not even what is there goes in. `work`: of one number that is tried.
[[nodiscard]] Result<Arrangement> fill_space(std::span<Object> objects, Design& design, std::size_t item,
                                             long long work, const ArrangeWatch& watch = {});

}  // namespace snug

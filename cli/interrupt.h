#pragma once

#include "snug/words/words.h"

namespace snug::cli {

/// From now on Ctrl-C (or a request to terminate) ends the program with status 5 and one sentence, at once
/// while nothing is being written.
void catch_interrupts(Language language);

/// While one of these lives, an interrupt only raises a flag, so that half-written files can be taken away.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    [[nodiscard]] static bool interrupted();
    /// What was asked for is done: from now on an interrupt ends nothing, since it would say that nothing was
    /// written.
    static void finished();
    /// The interrupt was answered: what follows may be interrupted again.
    static void forget();
};

}  // namespace snug::cli

#include "cli/interrupt.h"

#include <csignal>
#include <string>
#include <unistd.h>

#include "cli/commands.h"

namespace snug::cli {
namespace {

// A signal handler can reach nothing but globals.
volatile std::sig_atomic_t deferred = 0;
volatile std::sig_atomic_t raised = 0;
volatile std::sig_atomic_t ended = 0;
std::string cancelled;  // what an interrupt says; made before there can be one

void on_interrupt(int) {
    raised = 1;
    if (deferred || ended) return;
    (void)!write(STDERR_FILENO, cancelled.data(), cancelled.size());
    _exit(kCancelled);
}

}  // namespace

void catch_interrupts(Language language) {
    cancelled = "\nsnug: " + text(say("cancelled.nothing_written"), language) + "\n";
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    // A reader that goes away, or a limit on file sizes, is an error of the write, not the end of the
    // program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

InterruptGuard::InterruptGuard() {
    deferred = 1;
}
InterruptGuard::~InterruptGuard() {
    deferred = 0;
}
void InterruptGuard::finished() {
    ended = 1;
}
void InterruptGuard::forget() {
    raised = 0;
}
bool InterruptGuard::interrupted() {
    return raised != 0;
}

}  // namespace snug::cli

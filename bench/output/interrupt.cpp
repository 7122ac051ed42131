#include "bench/output/interrupt.h"

#include <atomic>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace rayshoot {
namespace {

// A signal handler is a plain function that can reach nothing but what is static.
static_assert(std::atomic<bool>::is_always_lock_free);  // else a handler may not touch it
std::atomic<bool> guarded = false, raised = false;
struct sigaction action_before;

void remember(int) {
    raised = true;
    sigaction(SIGINT, &action_before, nullptr);  // async-signal-safe (POSIX.1-2017, 2.4.3)
}

}  // namespace

InterruptGuard::InterruptGuard() {
    if (guarded.exchange(true)) throw std::logic_error("an InterruptGuard within another");
    raised = false;
    sigaction(SIGINT, nullptr, &former_);
    action_before = former_;
    struct sigaction action {};
    action.sa_handler = remember;
    action.sa_flags = SA_RESTART;  // what is being read or written goes on
    sigemptyset(&action.sa_mask);
    if (sigaction(SIGINT, &action, nullptr) == 0) return;
    guarded = false;
    throw std::system_error(errno, std::system_category(), "cannot listen for Ctrl-C");
}

InterruptGuard::~InterruptGuard() {
    sigaction(SIGINT, &former_, nullptr);
    guarded = false;
}

bool InterruptGuard::interrupted() const { return raised; }

}  // namespace rayshoot

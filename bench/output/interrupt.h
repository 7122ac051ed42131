#pragma once

#include <csignal>

/// Ctrl-C as a request: long work is asked to stop, and what is done so far is kept.
namespace rayshoot {

/// While it lives, the first SIGINT is remembered instead of ending the program, and the second one
/// does what it did before. One at a time.
class InterruptGuard {
public:
    /// Throws std::logic_error when there is one already, std::system_error when the system
    /// refuses.
    InterruptGuard();
    /// Puts the former handling back.
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Whether SIGINT came since it was made; from any thread.
    bool interrupted() const;

private:
    struct sigaction former_;
};

}  // namespace rayshoot

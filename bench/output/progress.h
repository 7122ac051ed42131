#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

/// One line that overwrites itself: share done, time left, what is being done.
/// Quiet unless standard error is a terminal.
namespace rayshoot {

class ProgressLine {
public:
    ProgressLine();
    ProgressLine(std::ostream& out, bool visible) : out_(out), visible_(visible) {}
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `seconds_left` below 0: not known.
    void show(double share_done, double seconds_left, const std::string& what);
    void clear();

private:
    std::ostream& out_;
    bool visible_;
    std::size_t width_ = 0;  ///< of the line that stands on the terminal
};

/// Progress through steps of about equal length.
class Progress {
public:
    /// `steps`: how many times advance will be called.
    explicit Progress(std::size_t steps) : steps_(steps) {}
    Progress(std::size_t steps, std::ostream& out, bool visible)
        : line_(out, visible), steps_(steps) {}

    /// Starts the next step.
    void advance(const std::string& what);

private:
    ProgressLine line_;
    std::size_t steps_;
    std::size_t done_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rayshoot

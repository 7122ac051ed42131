#include "bench/output/progress.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace rayshoot {
namespace {

std::string time_left(double seconds) {
    if (seconds < 0) return "";
    const auto whole = static_cast<long>(seconds);
    return ", " +
           (whole >= 120 ? std::to_string(whole / 60) + " min" : std::to_string(whole) + " s") +
           " left";
}

}  // namespace

ProgressLine::ProgressLine() : ProgressLine(std::cerr, isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(double share_done, double seconds_left, const std::string& what) {
    if (!visible_) return;
    const std::string line = std::to_string(static_cast<int>(100 * share_done)) + " %" +
                             time_left(seconds_left) + ": " + what;
    clear();
    out_ << line << std::flush;
    width_ = line.size();
}

void ProgressLine::clear() {
    if (visible_ && width_ > 0) out_ << '\r' << std::string(width_, ' ') << '\r' << std::flush;
    width_ = 0;
}

void Progress::advance(const std::string& what) {
    steps_ = std::max(steps_, done_ + 1);
    const double share = static_cast<double>(done_) / static_cast<double>(steps_);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    line_.show(share, share > 0 ? spent.count() * (1 - share) / share : -1, what);
    ++done_;
}

}  // namespace rayshoot

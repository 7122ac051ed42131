#include "bench/timing/peak_memory.h"

#include <fstream>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace rayshoot {
namespace {

/// The kernel counts pages per processor and adds them up now and then.
constexpr std::uint64_t resolution = std::uint64_t{1} << 19;

/// A line of /proc/self/status, "VmHWM:  1234 kB", in bytes.
std::optional<std::uint64_t> status_line(const std::string& name) {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with(name + ":")) return 1024 * std::stoull(line.substr(name.size() + 1));
    }
    return std::nullopt;
}

void give_back_freed_memory() {
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
}

bool reset_mark() {
    std::ofstream out("/proc/self/clear_refs");
    out << "5" << std::flush;  // proc(5): the peak resident set size becomes the current one
    return static_cast<bool>(out);
}

}  // namespace

PeakMemory::PeakMemory() {
    give_back_freed_memory();
    if (!reset_mark()) return;
    const auto in_use = status_line("VmRSS"), mark = status_line("VmHWM");
    if (in_use && mark && *mark < *in_use + resolution) start_ = *in_use;
}

std::optional<std::uint64_t> PeakMemory::risen() const {
    const auto mark = status_line("VmHWM");
    if (!start_ || !mark || *mark < *start_ + resolution) return std::nullopt;
    return *mark - *start_;
}

}  // namespace rayshoot

#include "bench/limits/probe_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <new>
#include <sstream>
#include <string>

namespace rayshoot {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;

std::size_t rounded_up(std::size_t bytes) {
    return (bytes + large_page - 1) / large_page * large_page;
}

/// "Name:  1234 kB" in bytes; 0 for another line.
std::size_t kilobytes_of(const std::string& line, const std::string& name) {
    if (!line.starts_with(name + ":")) return 0;
    return 1024 * std::strtoull(line.c_str() + name.size() + 1, nullptr, 10);
}

/// "7f00-7fff rw-p ...": a mapping's first line in /proc/self/smaps.
bool holds(const std::string& line, std::uintptr_t address) {
    std::istringstream in(line);
    std::uintptr_t first = 0, last = 0;
    char dash = 0;
    in >> std::hex >> first >> dash >> last;
    return in && dash == '-' && first <= address && address < last;
}

/// Bytes on large pages of the mapping that holds the address.
std::size_t bytes_on_large_pages(const void* address) {
    std::ifstream in("/proc/self/smaps");
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        inside = inside || holds(line, reinterpret_cast<std::uintptr_t>(address));
        if (inside && line.starts_with("AnonHugePages:"))
            return kilobytes_of(line, "AnonHugePages");
    }
    return 0;
}

}  // namespace

ProbeMemory::ProbeMemory(std::size_t lines, Pages pages) : pages_(pages) {
    const std::size_t bytes = rounded_up(lines * sizeof(CacheLine));
    mapped_ = bytes + large_page;  // room to begin at a large page
    mapping_ = mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapping_ == MAP_FAILED) throw std::bad_alloc();
    const auto first = rounded_up(reinterpret_cast<std::uintptr_t>(mapping_));
    auto* memory = reinterpret_cast<CacheLine*>(first);
    madvise(memory, bytes, pages == Pages::large ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
    std::fill_n(memory, bytes / sizeof(CacheLine), CacheLine{});
    lines_ = {memory, lines};
}

ProbeMemory::~ProbeMemory() { munmap(mapping_, mapped_); }

bool ProbeMemory::granted() const {
    const std::size_t on_large = bytes_on_large_pages(lines_.data());
    const std::size_t bytes = rounded_up(lines_.size_bytes());
    return pages_ == Pages::large ? on_large >= bytes - bytes / 16 : on_large == 0;
}

std::size_t available_memory() {
    std::ifstream in("/proc/meminfo");
    for (std::string line; std::getline(in, line);) {
        if (const std::size_t bytes = kilobytes_of(line, "MemAvailable")) return bytes;
    }
    return 0;
}

}  // namespace rayshoot

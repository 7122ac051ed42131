#pragma once

#include <cstddef>
#include <span>

/// Memory whose pages are chosen, for measuring what pages cost.
namespace rayshoot {

enum class Pages { small, large };  ///< 4 KiB; 2 MiB where the system grants them

struct alignas(64) CacheLine {
    const CacheLine* next = nullptr;
};

class ProbeMemory {
public:
    /// `lines` of them, every page touched. Throws std::bad_alloc.
    ProbeMemory(std::size_t lines, Pages pages);
    ~ProbeMemory();
    ProbeMemory(const ProbeMemory&) = delete;
    ProbeMemory& operator=(const ProbeMemory&) = delete;

    std::span<CacheLine> lines() const { return lines_; }
    /// The pages are of the size that was asked for; false where the system tells nothing of it.
    bool granted() const;

private:
    Pages pages_;
    void* mapping_ = nullptr;
    std::size_t mapped_ = 0;  ///< bytes
    std::span<CacheLine> lines_;
};

/// Bytes that the system can still give out; 0 where it does not say.
std::size_t available_memory();

}  // namespace rayshoot

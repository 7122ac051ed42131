#pragma once

#include <cstdint>
#include <optional>

/// How far the memory in use rises above what it is when this is made. Resident memory of the whole
/// process, as the kernel accounts it: whoever allocates, and by whatever means, is in it.
namespace rayshoot {

class PeakMemory {
public:
    /// Gives memory that was freed back to the system first, so that a build that reuses it is not
    /// thought to need none; then resets the kernel's mark.
    PeakMemory();

    /// Bytes between the mark and what was in use at the start; nothing where the kernel keeps no
    /// mark or does not reset it (it takes Linux), and for less than it can tell.
    std::optional<std::uint64_t> risen() const;

private:
    std::optional<std::uint64_t> start_;  ///< bytes
};

}  // namespace rayshoot

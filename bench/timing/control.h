#pragma once

#include <cstddef>
#include <vector>

/// A fixed piece of work, timed between the rows: what wavers here is the machine, not a structure.
namespace rayshoot {

class ControlKernel {
public:
    ControlKernel();
    /// Seconds for dependent loads through a table larger than most second-level caches, with an
    /// fma on each: some 10 ms.
    double seconds();

private:
    std::vector<std::size_t> next_;  ///< one cycle through all of it
    float result_ = 0;
};

}  // namespace rayshoot

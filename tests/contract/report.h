#pragma once

#include "accel/core/ray.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

/// What a run of the contract kit found.
namespace rayshoot::contract {

struct Report {
    std::uint64_t scenes = 0;           ///< scenes (times precisions) run
    std::uint64_t refused = 0;          ///< of these, left out because the structure refuses them
    std::uint64_t answers = 0;          ///< answers compared
    std::uint64_t failures = 0;         ///< of any kind
    std::vector<std::string> messages;  ///< the first few failures

    bool passed() const { return failures == 0 && answers > 0; }
    void fail(std::string message);
    Report& operator+=(const Report& other);
};

std::ostream& operator<<(std::ostream& out, const Report& report);

/// Every number as a hex float, so that a failure can be repeated exactly.
std::string printed(const Ray& ray);
std::string printed(const Hit& hit);

/// Equal as bits: -0 is not 0 here.
bool same_bits(const Hit& a, const Hit& b);

}  // namespace rayshoot::contract

#pragma once

#include <cstdint>
#include <vector>

namespace rayshoot {

/// The permutations that samples are dealt to strata by: some made beforehand by permuted(), each
/// of which a key turns round before and after. A third of the time of permuted() itself, which is
/// what lengths above largest_table are left to.
class Permutations {
public:
    static constexpr std::uint32_t largest_table = 2048;

    Permutations(std::uint32_t length, std::uint64_t seed);

    /// Where the permutation that `key`, 64 random bits, names sends index < length. Over the keys
    /// each index is sent everywhere equally often.
    std::uint32_t operator()(std::uint32_t index, std::uint64_t key) const;

private:
    std::uint32_t length_;
    std::uint32_t rows_;                ///< a power of two
    std::vector<std::uint16_t> table_;  ///< by row
};

}  // namespace rayshoot

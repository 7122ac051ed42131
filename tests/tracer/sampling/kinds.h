#pragma once

#include <numeric>
#include <vector>

#include "tests/tracer/sampling/chi_squared.h"
#include "tracer/sampling/sampler.h"

namespace rayshoot {

inline constexpr Use every_use[] = {Use::pixel, Use::lens,        Use::time, Use::light_choice,
                                    Use::light, Use::lobe_choice, Use::lobe, Use::roulette};
static_assert(std::size(every_use) == uses);

/// Each kind with each of the options that it has.
inline std::vector<SamplerSettings> every_kind(int spp) {
    using enum SamplerKind;
    return {{random, spp},
            {regular, spp},
            {jitter, spp},
            {gaussian, spp},
            {sobol, spp},
            {sobol, spp, true},
            {jitter, spp, false, true},
            {regular, spp, false, true}};
}

/// 0 to spp - 1. (Not std::views::iota, which clang 14 does not take from GCC's library.)
inline std::vector<std::uint32_t> samples(int spp) {
    std::vector<std::uint32_t> numbers(static_cast<std::size_t>(spp));
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

}  // namespace rayshoot

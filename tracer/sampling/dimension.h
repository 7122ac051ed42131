#pragma once

#include <cstdint>

#include "tracer/random.h"

namespace rayshoot {

/// What the numbers of a camera sample are used for.
enum class Use : std::uint8_t {
    pixel,         ///< the place within the cell; root of the ray tree only
    lens,          ///< root only
    time,          ///< root only
    light_choice,  ///< which light
    light,         ///< the point on it
    lobe_choice,   ///< which lobe of a surface
    lobe,          ///< the direction within it
    roulette,
};
inline constexpr std::uint32_t uses = 8;

/// A dimension of the integrand, or a pair of them: a use at a place in the tree of rays of one
/// camera sample. Either the number or the pair of a dimension is used, they are not independent.
struct Dimension {
    Use use = Use::pixel;
    std::uint32_t place = 1;  ///< 1 is the camera ray's; less than place_limit

    static constexpr std::uint32_t place_limit = 1u << 29;  ///< a place and a use make 32 bits

    /// The same use one level down: along the i-th ray that leaves the hit, 2 place + i for a
    /// reflected (0) and a refracted (1) one. A larger i is for further branches, such as one of
    /// several lights. Those and whatever is 28 levels down are hashed into the upper half of
    /// the places, where two may fall together, which is harmless as rare.
    constexpr Dimension child(std::uint32_t i) const {
        constexpr std::uint32_t half = place_limit / 2;
        if (i < 2 && place < half / 2) return {use, 2 * place + i};
        const std::uint64_t hash = scrambled(std::uint64_t{i} << 32 | place);
        return {use, half | static_cast<std::uint32_t>(hash >> 36)};  // 28 bits
    }
    constexpr bool operator==(const Dimension&) const = default;
};

}  // namespace rayshoot

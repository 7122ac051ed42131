#pragma once

#include "accel/core/options.h"
#include "accel/grid/lattice.h"

/// How many cells a grid has.
namespace rayshoot::inline RAYSHOOT_ISA {

/// In each rule N objects in a box of x * y * z get about density * N cells.
enum class ResolutionRule : std::uint8_t {
    cleary,        ///< Cleary & Wyvill 1988: cubes, numbers along the axes rounded down
    woo,           ///< Woo 1992 as Havran & Sixta 1999 print it: cubes, rounded to nearest
    klimaszewski,  ///< Klimaszewski & Sederberg 1997: each axis makes up for how others round
    fixed          ///< as given
};

struct Resolution {
    ResolutionRule rule = ResolutionRule::cleary;
    Cell fixed{1, 1, 1};

    /// "woo", "cleary", "klimaszewski" or "46x46x3".
    static Resolution chosen(const Options& options, std::string_view key);
    Cell cells(const Box& space, double objects, double density) const;

    static constexpr int most_along = 1 << 16;  ///< cells along an axis
    static constexpr double most_cells = 1 << 27;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

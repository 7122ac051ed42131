#include "accel/grid/density.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Of a test, in steps: so that the density is about 4, which took least time for the bunny and the
/// dragon.
constexpr double reference_cost = 1.5;
constexpr std::uint32_t most_sampled = 1024;
/// Cells of one primitive that are asked one by one: of larger ones the boxes say enough.
constexpr std::size_t most_asked = 128;

double references_of(const Membership& membership, const Lattice& lattice,
                     std::uint32_t primitive) {
    const CellRange range = lattice.around(membership.box(primitive));
    if (range.size() > most_asked) return double(range.size());
    std::size_t references = 0;
    for_each_cell(range, [&](const Cell& cell) {
        references += membership.in_cell(primitive, lattice.box(cell));
    });
    return double(references);
}

/// In whole numbers, so that the sum does not depend on its order.
double mean_references(const Membership& membership, const Lattice& lattice,
                       std::uint32_t primitives) {
    const std::uint32_t sampled = std::min(primitives, most_sampled);
    const double sum = tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, sampled, 64), 0.0,
        [&](const auto& part, double partial) {
            for (std::uint32_t i = part.begin(); i < part.end(); ++i) {
                const auto primitive =
                    static_cast<std::uint32_t>(std::uint64_t{i} * primitives / sampled);
                partial += references_of(membership, lattice, primitive);
            }
            return partial;
        },
        std::plus<>());
    return sum / sampled;
}

double cost(const Membership& membership, const Lattice& lattice, std::uint32_t primitives) {
    const double references = primitives * mean_references(membership, lattice, primitives);
    const double share =
        double(lattice.box({0, 0, 0}).half_area()) / double(membership.space().half_area());
    return share * (double(lattice.size()) + reference_cost * references);
}

}  // namespace

double cheapest_density(const Membership& membership, const Resolution& resolution,
                        std::uint32_t primitives) {
    double cheapest = 1, least = infinity;
    if (primitives == 0) return cheapest;
    for (double density = 0.125; density <= 32; density *= 2) {
        const Cell cells = resolution.cells(membership.space(), primitives, density);
        const double found = cost(membership, Lattice(membership.space(), cells), primitives);
        if (!(found < least)) continue;
        least = found;
        cheapest = density;
    }
    return cheapest;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

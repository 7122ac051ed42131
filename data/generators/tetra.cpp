#include "data/generators/printer.h"
#include "data/generators/scenes.h"

#include <array>

/// A tetrahedral pyramid (Sierpinski's tetrahedron; Glassner 1984, Kay & Kajiya 1986).
/// 4^size triangles.
namespace rayshoot::procedural {

namespace {

using Tetrahedron = std::array<dvec3, 4>;

/// Every other corner of the cube of half side `half`.
Tetrahedron corners(const dvec3& centre, double half) {
    constexpr Tetrahedron signs{dvec3(-1, -1, 1), dvec3(-1, 1, -1), dvec3(1, -1, -1),
                                dvec3(1, 1, 1)};
    Tetrahedron result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = centre + signs[i] * half;
    return result;
}

void grow(Printer& printer, int depth, const dvec3& centre, double half) {
    if (depth > 1) {
        for (const dvec3& child : corners(centre, half / 2))
            grow(printer, depth - 1, child, half / 2);
        return;
    }
    constexpr std::array<std::array<std::size_t, 3>, 4> faces{
        {{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}}};
    const Tetrahedron tetrahedron = corners(centre, half);
    for (const auto& [a, b, c] : faces)
        printer.polygon(std::array{tetrahedron[a], tetrahedron[b], tetrahedron[c]});
}

}  // namespace

Scene tetra(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {1.022846, -3.177154, -2.174512},
                 .at = {-0.004103, -0.004103, 0.216539},
                 .up = {-0.816497, -0.816497, 0.816497},
                 .hither = 1});
    printer.light({2, -18, -5});
    printer.surface({.colour = {1, 0.2, 0.2}});
    grow(printer, size, {0, 0, 0}, 1);
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

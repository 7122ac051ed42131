#include "data/generators/random.h"
#include "data/generators/scenes.h"
#include "data/generators/unit_cube.h"

/// Equilateral triangles of one edge length, turned anyhow, their centres anywhere in the unit
/// cube.
namespace rayshoot::procedural {

Scene soup(int count, double length, int seed, Precision precision) {
    Printer printer = unit_cube_printer();
    const double half_edge = length / 2;
    const double height = half_edge * std::sqrt(3.0);
    for (int i = 0; i < count; ++i) {
        Random random(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(i));
        const dvec3 centre = random.place();
        const dvec3 upward = random.direction();
        const dvec3 sideward = random.across(upward);
        const dvec3 foot = centre - height / 3 * upward;
        printer.triangle(vec3(foot - half_edge * sideward), vec3(foot + half_edge * sideward),
                         vec3(foot + height * upward));
    }
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

#include "data/generators/random.h"
#include "data/generators/scenes.h"
#include "data/generators/unit_cube.h"

/// Isosceles triangles of height 1 and base 1 / aspect, turned anyhow, their middles anywhere in
/// the unit cube.
namespace rayshoot::procedural {

Scene needles(int count, double aspect, int seed, Precision precision) {
    Printer printer = unit_cube_printer();
    const double half_width = 0.5 / aspect;
    for (int i = 0; i < count; ++i) {
        Random random(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(i));
        const dvec3 middle = random.place();
        const dvec3 along = random.direction();
        const dvec3 across = random.across(along);
        const dvec3 foot = middle - 0.5 * along, tip = middle + 0.5 * along;
        printer.triangle(vec3(foot - half_width * across), vec3(foot + half_width * across),
                         vec3(tip));
    }
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

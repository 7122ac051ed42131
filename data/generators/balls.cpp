#include "data/generators/printer.h"
#include "data/generators/scenes.h"
#include "data/generators/transform.h"

#include <numbers>

/// Sphereflake: every ball carries nine of a third of its radius. (9^(size+1) - 1) / 8 spheres,
/// floor.
namespace rayshoot::procedural {

namespace {

using Directions = std::array<dvec3, 9>;
constexpr double shrink = 1.0 / 3.0;  // a child's radius in its parent's

/// Where the children sit on a ball whose own outward direction is +z: three round the pole and six
/// round the equator.
Directions child_directions() {
    const double diagonal = 1 / std::sqrt(2.0);
    const std::array<dvec3, 3> edges{dvec3(diagonal, diagonal, 0), dvec3(diagonal, 0, -diagonal),
                                     dvec3(0, diagonal, -diagonal)};
    const Matrix tilt = rotation(unit({1, -1, 0}), std::asin(2 / std::sqrt(6.0)));
    Directions directions;
    for (std::size_t trio = 0; trio < 3; ++trio) {
        const Matrix turn = rotation(z_axis, static_cast<double>(trio) * 2 * std::numbers::pi / 3);
        for (std::size_t i = 0; i < 3; ++i)
            directions[3 * trio + i] = direction(direction(edges[i], tilt), turn);
    }
    return directions;
}

/// Turns +z to `outward`, which is of unit length but for rounding.
Matrix frame(const dvec3& outward) {
    constexpr double aligned = 0.9999;
    if (outward.z >= aligned) return {};
    if (outward.z <= -aligned) return rotation(y_axis, std::numbers::pi);
    const dvec3 up(0, 0, 1);
    return rotation(unit(glm::cross(up, outward)), std::acos(glm::dot(up, outward)));
}

void grow(Printer& printer, const Directions& directions, int depth, const dvec3& centre,
          double radius, const dvec3& outward) {
    printer.sphere(centre, radius);
    if (depth == 0) return;
    const Matrix to_world = frame(outward);
    const double distance = radius * (1 + shrink);
    for (const dvec3& child : directions) {
        const dvec3 child_centre = direction(child, to_world) * distance + centre;
        grow(printer, directions, depth - 1, child_centre, radius * shrink,
             (child_centre - centre) / distance);
    }
}

}  // namespace

Scene balls(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {2.1, 1.3, 1.7}, .up = {0, 0, 1}, .hither = 0.01});
    for (const dvec3 light : {dvec3(4, 3, 2), dvec3(1, -4, 4), dvec3(-3, 1, 5)})
        printer.light(light);

    printer.surface({.colour = {1, 0.75, 0.33}, .diffuse = 0.8, .refraction_index = 1});
    printer.polygon(std::array{dvec3(12, 12, -0.5), dvec3(-12, 12, -0.5), dvec3(-12, -12, -0.5),
                               dvec3(12, -12, -0.5)});

    printer.surface({.colour = {1, 0.9, 0.7},
                     .diffuse = 0.5,
                     .specular = 0.5,
                     .highlight_angle = 37,
                     .refraction_index = 1});
    grow(printer, child_directions(), size, {0, 0, 0}, 0.5, {0, 0, 1});
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

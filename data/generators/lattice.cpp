#include "data/generators/printer.h"
#include "data/generators/scenes.h"

#include <array>
#include <cmath>

/// Shiny balls on a cubic lattice, joined by matt rods, seen from inside.
/// (size + 1)^3 spheres and 3 size (size + 1)^2 cylinders.
namespace rayshoot::procedural {

namespace {

struct Lattice {
    Printer& printer;
    int size;
    double step = 1.0 / size;
    double ball_radius = 0.25 / size, rod_radius = 0.0625 / size;
    /// A rod starts a little inside the ball's surface.
    double inset = ball_radius * (1 - std::sqrt(0.0625 / 0.25)) * 0.99;

    void print_node(const std::array<int, 3>& node) const {
        const dvec3 centre(static_cast<double>(node[0]) / size, static_cast<double>(node[1]) / size,
                           static_cast<double>(node[2]) / size);
        printer.surface(
            {.colour = dvec3(0.9), .diffuse = 0.5, .specular = 0.5, .highlight_angle = 37});
        printer.sphere(centre, ball_radius);
        for (int axis = 0; axis < 3; ++axis) {
            if (node[static_cast<std::size_t>(axis)] == size) continue;
            dvec3 colour(0.1), base = centre, apex = centre;
            colour[axis] = 0.9;
            base[axis] = centre[axis] + inset;
            apex[axis] = centre[axis] + step - inset;
            printer.surface({.colour = colour, .diffuse = 0.99});
            printer.frustum(base, rod_radius, apex, rod_radius);
        }
    }
};

}  // namespace

Scene lattice(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    const double middle = (size / 2 + 0.5) * (1.0 / size);  // of a gap between two layers
    printer.eye({.from = {middle, 1, 1 - 1.0 / (2 * size)},
                 .at = {middle, -1, -1 - 1.0 / (2 * size)},
                 .up = {0.2, 1, 0},
                 .angle = 60});
    for (int axis = 0; axis < 3; ++axis)
        for (const double distance : {2.0, -1.0}) {
            dvec3 light(0.5);
            light[axis] = distance;
            printer.light(light);
        }

    const Lattice lattice{printer, size};
    for (int x = 0; x <= size; ++x)
        for (int y = 0; y <= size; ++y)
            for (int z = 0; z <= size; ++z) lattice.print_node({x, y, z});
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

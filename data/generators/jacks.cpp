#include "data/generators/printer.h"
#include "data/generators/scenes.h"
#include "data/generators/transform.h"

#include <numbers>

/// Jacks within jacks: three crossed rods with balls at their ends, a half-size copy in each
/// octant. 9 (8^size - 1) / 7 primitives, a third of them cylinders.
namespace rayshoot::procedural {

namespace {

/// By how much lengths grow along the first axis; all maps here are similarities.
double scale(const Matrix& m) {
    return std::sqrt(m[0].x * m[0].x + m[0].y * m[0].y + m[0].z * m[0].z);
}

void print_jack(Printer& printer, const Matrix& to_world) {
    constexpr double rod_radius = 0.1, ball_radius = 0.2;
    const Matrix shrunk = scaling(0.75) * to_world;  // neighbours stay apart
    const auto end = [&](int axis, double sign) {
        dvec3 p(0);
        p[axis] = sign;
        return point(p, shrunk);
    };
    for (int axis = 0; axis < 3; ++axis)
        printer.frustum(end(axis, -1), rod_radius * scale(shrunk), end(axis, 1),
                        rod_radius * scale(shrunk));
    for (const double sign : {1.0, -1.0})
        for (int axis = 0; axis < 3; ++axis)
            printer.sphere(end(axis, sign), ball_radius * scale(shrunk));
}

void grow(Printer& printer, const Matrix& to_world, int depth) {
    print_jack(printer, to_world);
    if (depth == 1) return;
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
            for (const double z : {-0.5, 0.5})
                grow(printer, scaling(0.5) * (translation({x, y, z}) * to_world), depth - 1);
}

}  // namespace

Scene jacks(int size, Precision precision) {
    constexpr double pi = std::numbers::pi;
    Printer printer;
    printer.background({0.2, 0.05, 0.2});
    printer.eye(
        {.from = {0, 0, -8}, .up = {0, 1, 0}, .angle = 25, .hither = 0.001, .resolution = 256});
    printer.light({-10, 3, -20});
    printer.surface({.colour = {0.737, 0.561, 0.561},
                     .diffuse = 0.7,
                     .specular = 0.7,
                     .highlight_angle = 20,
                     .refraction_index = 1});
    grow(printer, rotation(y_axis, -20 * pi / 180) * rotation(x_axis, -30 * pi / 180), size);
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

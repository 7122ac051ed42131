#include "data/generators/printer.h"
#include "data/generators/scenes.h"
#include "data/generators/transform.h"

#include <numbers>

/// A binary tree after Aono & Kunii 1984: cones with a ball at each fork, on a field.
/// 2^(size+1) - 1 cones, as many spheres, and the field.
namespace rayshoot::procedural {

namespace {

constexpr double taper = 0.67;           // a branch's thin end in its thick one
constexpr double base_per_scale = 0.15;  // radius of the trunk

using Branching = std::array<Matrix, 2>;

/// From a branch to its child: degrees from the parent's axis, degrees round it, and length.
Matrix branching(double tilt, double turn, double contraction) {
    constexpr double pi = std::numbers::pi;
    Matrix to_tip = scaling(contraction);
    to_tip[3][2] = 1;
    return rotation(x_axis, tilt * pi / 180) * rotation(z_axis, turn * pi / 180) * to_tip;
}

void grow(Printer& printer, const Branching& children, const Matrix& to_world, double scale,
          int depth) {
    const dvec3 base = point({0, 0, 0}, to_world), tip = point({0, 0, 1}, to_world);
    const double radius = scale * base_per_scale;
    printer.frustum(base, radius, tip, radius * taper);
    printer.sphere(tip, radius * taper);
    if (depth == 0) return;
    for (const Matrix& child : children)
        grow(printer, children, child * to_world, scale * taper, depth - 1);
}

}  // namespace

Scene tree(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {4.5, 0.4, 2}, .at = {0, 0, 1.5}, .up = {0, 0, 1}, .hither = 1});
    for (const dvec3 light :
         {dvec3(-5, 5, 50), dvec3(30, -30, 30), dvec3(-40, -30, 20), dvec3(10, 30, 40),
          dvec3(-30, 40, 10), dvec3(50, 25, 20), dvec3(-10, -60, 30)})
        printer.light(light);

    printer.surface({.colour = {0.2, 0.7, 0.2}});
    printer.polygon(
        std::array{dvec3(50, 50, 0), dvec3(-50, 50, 0), dvec3(-50, -50, 0), dvec3(50, -50, 0)});

    printer.surface({.colour = {0.55, 0.4, 0.2}});
    const Branching children{branching(40, 90, 0.65), branching(25, 230, 0.7)};
    grow(printer, children, {}, 1, size);
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

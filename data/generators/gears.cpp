#include "data/generators/printer.h"
#include "data/generators/scenes.h"
#include "data/generators/transform.h"

#include <algorithm>
#include <numbers>

/// A block of meshing gears, some of glass. Each has two concave faces of 144 corners and 144
/// rectangles along its rim. 146 size^3 polygons and the ground.
namespace rayshoot::procedural {

namespace {

constexpr int teeth = 36;
constexpr int corners = 4 * teeth;  // of a face
constexpr double foot = 0.9;        // radius between the teeth, of the full radius
constexpr double tooth_depth = 1 - foot;
constexpr double clearance = 0.995;  // outer radius, so that meshing teeth do not touch
constexpr double thickest = 0.1;

using Outline = std::array<dvec3, corners>;

struct Gear {
    dvec3 centre;  ///< of the top face
    double phase;  ///< of the first tooth, radians
    double outer_radius, inner_radius, thickness;
};

/// The corners of a face at height `z` below the centre; `sense` -1 runs the other way round, so
/// that the bottom faces down.
Outline face(const Gear& gear, double z, double sense) {
    // Two corners of a tooth's tip, then two at its foot, in shares of a tooth's angle.
    constexpr std::array shares{-0.19, 0.19, 0.3, 0.7};
    const double tooth_angle = sense * (2 * std::numbers::pi / teeth);
    Outline outline;
    for (std::size_t corner = 0; corner < corners; ++corner) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(corner / 4) / teeth;
        const double angle = gear.phase + sense * turn + shares[corner % 4] * tooth_angle;
        const double radius = corner % 4 < 2 ? gear.outer_radius : gear.inner_radius;
        outline[corner] = direction({radius, 0, z}, rotation(z_axis, angle)) + gear.centre;
    }
    return outline;
}

void print(Printer& printer, const Gear& gear) {
    const Outline top = face(gear, 0, 1);
    printer.polygon(top);
    const dvec3 down(0, 0, gear.thickness);
    for (std::size_t side = 0; side < corners; ++side) {
        const dvec3 &left = top[side], &right = top[(side + 1) % corners];
        printer.polygon(std::array{left, left - down, right - down, right});
    }
    printer.polygon(face(gear, -gear.thickness, -1));
}

double fraction(double x) { return x - std::trunc(x); }

Surface surface(int x, int y, int z) {
    const auto shade = [](int a, int b, int c, double sevenths) {
        return 0.01 + fraction((a * 3 + b * 2 + c + 1) * sevenths / 7);
    };
    const dvec3 colour(shade(x, y, z, 5), shade(y, z, x, 3), shade(z, x, y, 2));
    const dvec3 bright = colour / std::max({colour.x, colour.y, colour.z});
    if ((x * 4 + y * 2 + z) % 5 == 0)
        return {.colour = bright, .diffuse = 0.2, .transmittance = 0.8, .refraction_index = 1.1};
    return {.colour = bright};
}

void print_block(Printer& printer, int size) {
    const double radius = 1 / (size - (size - 1) * tooth_depth / 2);
    const dvec3 first(-1 + radius, -1 + radius, 1);
    const dvec3 offset(radius * (2 - tooth_depth), radius * (2 - tooth_depth), -1.0 / size);
    for (int z = 0; z < size; ++z)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                printer.surface(surface(x, y, z));
                print(printer, {.centre = first + dvec3(x, y, z) * offset,
                                .phase = std::numbers::pi * ((x + y + z) % 2) / teeth,
                                .outer_radius = clearance * radius,
                                .inner_radius = (1 - tooth_depth) * radius,
                                .thickness = std::min(thickest, 1 / (2.0 * size))});
            }
}

}  // namespace

Scene gears(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {-1.1, -2.1, 2.6}, .up = {0, 0, 1}, .hither = 1});
    for (const dvec3 light : {dvec3(2, 4, 4), dvec3(-2, 4, 3), dvec3(2, -2.5, 2.5),
                              dvec3(-1, -4, 2), dvec3(-1.111, -2.121, 2.626)})
        printer.light(light);

    printer.surface(
        {.colour = {1, 0.85, 0.7}, .diffuse = 0.3, .specular = 0.6, .highlight_angle = 37});
    printer.polygon(std::array{dvec3(2, 2, 0), dvec3(-2, 2, 0), dvec3(-2, -2, 0), dvec3(2, -2, 0)});
    print_block(printer, size);
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

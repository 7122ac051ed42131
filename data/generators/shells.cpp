#include "data/generators/printer.h"
#include "data/generators/scenes.h"

#include <cmath>
#include <numbers>

/// A sea shell of overlapping balls after Pickover 1989: along the spiral r = e^(0.15 angle), from
/// tiny to huge. 180 * 2^size + 1 spheres. Many boxes overlap: hard for every structure.
namespace rayshoot::procedural {

Scene shells(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {-6, -60, 35}, .at = {0, 8, -15}, .up = {0, 0, 1}, .hither = 0.5});
    printer.light({-100, -100, 100});
    printer.surface({.colour = {1, 0.8, 0.4},
                     .diffuse = 0.8,
                     .specular = 0.2,
                     .highlight_angle = 10,
                     .refraction_index = 1});

    constexpr double growth = 0.15;  // per radian
    constexpr double slope = -2;     // of the cone that the spiral winds round
    const int steps = 180 << size;   // in nine turns, six of them inward
    for (int i = -steps * 2 / 3; i <= steps / 3; ++i) {
        const double angle = 18 * std::numbers::pi * i / steps;
        const double r = std::exp(growth * angle);
        printer.sphere({r * std::sin(angle), r * std::cos(angle), slope * r}, r);
    }
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

#include "data/generators/printer.h"
#include "data/generators/scenes.h"

#include <array>
#include <cmath>

/// A height field cos(2 pi r) e^-r over a square. 2 (32 * 2^(size-1) - 1)^2 triangles.
namespace rayshoot::procedural {

namespace {

constexpr double reach = 4;  // of the square from the centre

struct Field {
    int columns;  ///< samples along a side

    /// Sampled at spacing 8 / columns but drawn at 8 / (columns - 1), as the original does.
    double height(int row, int column) const {
        const double x = -reach + column * (2 * reach / columns);
        const double y = -reach + row * (2 * reach / columns);
        const double r = std::sqrt(x * x + y * y);
        constexpr double two_pi = 2 * 3.14159265358;  // the original's digits
        return static_cast<float>(3 * std::cos(two_pi * r) * std::exp(-r) / 3);
    }

    dvec3 vertex(int row, int column) const {
        const double spacing = 2 * reach / (columns - 1);
        return {-reach + column * spacing, -3 + height(row, column), -reach + row * spacing};
    }
};

}  // namespace

Scene sombrero(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {0, 5, -8}, .up = {0, 0, 1}, .angle = 40, .hither = 0.01});
    printer.light({10, 10, -10});
    printer.surface(
        {.colour = {1, 0.1, 0.1}, .diffuse = 0.8, .highlight_angle = 40, .refraction_index = 1});

    const Field field{16 << size};
    for (int row = 0; row + 1 < field.columns; ++row)
        for (int column = 0; column + 1 < field.columns; ++column) {
            const dvec3 near = field.vertex(row, column), far = field.vertex(row + 1, column + 1);
            printer.polygon(std::array{near, far, field.vertex(row, column + 1)});
            printer.polygon(std::array{near, field.vertex(row + 1, column), far});
        }
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

#include "data/generators/printer.h"
#include "data/generators/scenes.h"
#include "data/generators/transform.h"

#include <cstdint>
#include <numbers>

/// A fractal mountain by midpoint displacement, with a pyramid of four glass balls before it.
/// 2 * 4^size triangles and 4 spheres.
namespace rayshoot::procedural {

namespace {

constexpr double width = 2, corner = -1;  // of the square it stands on
constexpr double fractal_dimension = 2.2;
constexpr int mountain_number = 21;  // another number is another mountain

/// A normal deviate by the polar method on a linear congruential generator (Press et al. 1988,
/// GASDEV), started afresh from a seed so that both quadrants beside an edge get the same.
double gaussian(std::int64_t seed) {
    constexpr std::int64_t modulus = 134456, factor = 8121, increment = 28411;
    std::int64_t state = seed;
    for (;;) {
        const std::int64_t first = (increment + state * factor) % modulus;
        state = (increment + first * factor) % modulus;
        const double x = static_cast<double>(first) * 2 / modulus - 1;
        const double y = static_cast<double>(state) * 2 / modulus - 1;
        const double r = x * x + y * y;
        if (r < 1) return x * std::sqrt(-2 * std::log(r) / r);
    }
}

struct Mountain {
    Printer& printer;
    int size;
    int cells;         ///< per side
    double roughness;  ///< rise per half side

    /// The suite's first, repetitive hash; kept because the published counts are of this mountain.
    /// The third shift is negative from size 8 on, where the reference files have no such term.
    std::int64_t seed(int x, int y) const {
        const auto shifted = [](int value, int places) {
            return places < 0 ? 0 : static_cast<std::uint64_t>(value) << places;
        };
        const std::uint64_t hash =
            shifted(x, 23 - size) + shifted(y, 15 - size) + shifted(x, 7 - size);
        return mountain_number + static_cast<std::int64_t>(hash & 0xffff);
    }

    dvec3 vertex(int x, int y, double height) const {
        return {corner + x * width / cells, corner + y * width / cells, height};
    }

    /// The quadrilateral with lower left cell corner (x, y); heights counterclockwise from there.
    void grow(int side, int x, int y, const std::array<double, 4>& heights) const {
        if (side == 1) return print(x, y, heights);
        const int half = side / 2;
        const double rise = half * width / cells * roughness;
        const auto [a, b, c, d] = heights;
        const auto middle = [&](double p, double q, int right, int up) {
            return (p + q) / 2 + rise * gaussian(seed(x + right, y + up));
        };
        const double lower = middle(a, b, half, 0);
        const double right = middle(b, c, side, half);
        const double upper = middle(c, d, half, side);
        const double left = middle(d, a, 0, half);
        constexpr double root_two = 1.4142136;
        const double centre =
            (a + b + c + d) / 4 + root_two * rise * gaussian(seed(x + half, y + half));
        grow(half, x, y, {a, lower, centre, left});
        grow(half, x + half, y, {lower, b, right, centre});
        grow(half, x + half, y + half, {centre, right, c, upper});
        grow(half, x, y + half, {left, centre, upper, d});
    }

    void print(int x, int y, const std::array<double, 4>& heights) const {
        const std::array corners{vertex(x, y, heights[0]), vertex(x + 1, y, heights[1]),
                                 vertex(x + 1, y + 1, heights[2]), vertex(x, y + 1, heights[3])};
        printer.polygon(std::array{corners[0], corners[1], corners[2]});
        printer.polygon(std::array{corners[2], corners[3], corners[0]});
    }
};

void print_pyramid(Printer& printer, const dvec3& centre, double radius) {
    const dvec3 top(0, 0, radius * std::sqrt(3.0 / 2.0));
    printer.sphere(centre + top, radius);
    const dvec3 foot = direction(top, rotation(unit({1, 1, 0}), std::acos(-1.0 / 3.0)));
    for (int i = 0; i < 3; ++i)
        printer.sphere(direction(foot, rotation(z_axis, i * 2.0 * std::numbers::pi / 3)) + centre,
                       radius);
}

}  // namespace

Scene mount(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {-1.6, 1.6, 1.7}, .up = {0, 0, 1}, .hither = 0.01});
    printer.light({-100, -100, 100});

    printer.surface({.diffuse = 0.1,
                     .specular = 0.1,
                     .highlight_angle = 6.7,
                     .transmittance = 0.9,
                     .refraction_index = 1.5});
    print_pyramid(printer, {-0.8, 0.8, 1}, 0.17);

    printer.surface({.colour = {0.5, 0.45, 0.35}});
    const double ratio = 2 / std::exp(std::log(2.0) / (fractal_dimension - 1));
    const Mountain mountain{printer, size, 1 << size, std::sqrt(ratio * ratio - 1)};
    mountain.grow(mountain.cells, 0, 0, {0, 0, 0, 0});
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

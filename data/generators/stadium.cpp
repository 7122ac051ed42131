#include "data/generators/newell.h"
#include "data/generators/scenes.h"

#include <numbers>

/// "A teapot in a stadium": 6 wide among stands 24000 wide, so that one cell of a uniform grid
/// holds the whole pot. 64 size^2 - 8 size triangles of teapot and 1088 of stadium.
namespace rayshoot::procedural {

namespace {

constexpr int segments = 64;  // of each ellipse
constexpr int tiers = 4;      // a tread and a riser each
constexpr dvec3 tier(1000, 1000, 600);

/// Point `i` of the ellipse round z with these half axes at this height.
dvec3 at(const dvec3& half_axes, int i) {
    const double angle = 2 * std::numbers::pi * (i % segments) / segments;
    return {half_axes.x * std::cos(angle), half_axes.y * std::sin(angle), half_axes.z};
}

void print_band(Printer& printer, const dvec3& inner, const dvec3& outer) {
    for (int i = 0; i < segments; ++i) {
        const dvec3 a = at(inner, i), b = at(outer, i), c = at(outer, i + 1), d = at(inner, i + 1);
        printer.polygon(std::array{a, b, c});
        printer.polygon(std::array{c, d, a});
    }
}

void print_stadium(Printer& printer) {
    dvec3 edge(8000, 5000, 0);
    printer.surface({.colour = {0.3, 0.6, 0.3}});
    for (int i = 0; i < segments; ++i)
        printer.polygon(std::array{dvec3(0), at(edge, i), at(edge, i + 1)});
    for (int i = 0; i < tiers; ++i) {
        printer.surface({.colour = dvec3(i % 2 == 0 ? 0.75 : 0.55)});
        const dvec3 riser = edge + dvec3(0, 0, tier.z), tread = edge + tier;
        print_band(printer, edge, riser);
        print_band(printer, riser, tread);
        edge = tread;
    }
}

}  // namespace

Scene stadium(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {5, 8, 3}, .at = {0, 0, 1.8}, .up = {0, 0, 1}, .hither = 1});
    printer.light({-3000, 5000, 9000});
    printer.light({11.3, 5.1, 8.8});
    print_stadium(printer);
    printer.surface(
        {.colour = {1, 0.5, 0.1}, .diffuse = 0.75, .specular = 0.25, .highlight_angle = 37});
    print_teapot(printer, size);
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

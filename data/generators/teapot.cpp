#include "data/generators/newell.h"
#include "data/generators/scenes.h"

/// Newell's teapot on a chequered floor of size^2 squares. 65 size^2 - 8 size polygons.
namespace rayshoot::procedural {

namespace {

void print_squares(Printer& printer, int size, int parity) {
    const auto place = [size](int i) { return 4 * (2.0 * i / size - 1); };
    for (int x = 0; x < size; ++x)
        for (int y = 0; y < size; ++y) {
            if ((x + y) % 2 != parity) continue;
            const double left = place(x), right = place(x + 1);
            const double near = place(y), far = place(y + 1);
            printer.polygon(std::array{dvec3(left, near, 0), dvec3(right, near, 0),
                                       dvec3(right, far, 0), dvec3(left, far, 0)});
        }
}

}  // namespace

Scene teapot(int size, Precision precision) {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {4.86, 7.2, 5.4}, .up = {0, 0, 1}, .hither = 1});
    printer.light({-3.1, 9.8, 12.1});
    printer.light({11.3, 5.1, 8.8});

    const Surface floor{.diffuse = 0.5, .specular = 0.5, .highlight_angle = 30};
    for (const int parity : {1, 0}) {
        Surface square = floor;
        square.colour = dvec3(parity == 1 ? 1.0 : 0.5);
        printer.surface(square);
        print_squares(printer, size, parity);
    }
    printer.surface(
        {.colour = {1, 0.5, 0.1}, .diffuse = 0.75, .specular = 0.25, .highlight_angle = 37});
    print_teapot(printer, size);
    return std::move(printer).scene(precision);
}

}  // namespace rayshoot::procedural

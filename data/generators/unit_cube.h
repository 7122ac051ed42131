#pragma once

#include "data/generators/printer.h"

/// What the random scenes share: a grey heap in the unit cube, seen whole, one light.
namespace rayshoot::procedural {

inline Printer unit_cube_printer() {
    Printer printer;
    printer.background(sky_blue);
    printer.eye({.from = {1.9, -1.6, 1.4}, .at = {0.5, 0.5, 0.5}, .up = {0, 0, 1}});
    printer.light({3, -2, 4});
    printer.surface({.colour = {0.8, 0.75, 0.7}});
    return printer;
}

}  // namespace rayshoot::procedural

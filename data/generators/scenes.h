#pragma once

#include "data/scene.h"

/// The generators themselves; generators.h is the way in. README.md has formulas and counts.
namespace rayshoot::procedural {

Scene balls(int size, Precision precision);
Scene gears(int size, Precision precision);
Scene mount(int size, Precision precision);
Scene rings(int size, Precision precision);
Scene teapot(int size, Precision precision);
Scene tetra(int size, Precision precision);
Scene tree(int size, Precision precision);
Scene lattice(int size, Precision precision);
Scene shells(int size, Precision precision);
Scene jacks(int size, Precision precision);
Scene sombrero(int size, Precision precision);

Scene soup(int count, double length, int seed, Precision precision);
Scene needles(int count, double aspect, int seed, Precision precision);
Scene stadium(int size, Precision precision);
Scene chair(Precision precision);

}  // namespace rayshoot::procedural

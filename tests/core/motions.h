#pragma once

#include "tests/core/cases.h"

/// Random rigid motions, and where they take a point: by a matrix, on its own.
namespace rayshoot::cases {

Motion motion(Random& random);

/// From the rest frame to the world at a time, by the definition in motion.h.
dvec3 moved(const Motion& motion, double time, const dvec3& point);
/// And back.
dvec3 moved_back(const Motion& motion, double time, const dvec3& point);

}  // namespace rayshoot::cases

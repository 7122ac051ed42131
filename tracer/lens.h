#pragma once

#include "data/scene.h"
#include "tracer/sampling/pair.h"

/// The thin lens of a camera: 1/f = 1/s_o + 1/s_i, with s_o the distance in focus and s_i that of
/// its sharp image behind the lens (Potmesil & Chakravarty 1982; Cook, Porter & Carpenter 1984).
namespace rayshoot {

/// Throws std::invalid_argument, with the remedy, for lengths or an f-stop that are not positive
/// and finite, a focus within the focal length, and one or two blades.
void require_valid(const Lens& lens);

/// An f-number for a camera without a lens: one focused on what it looks at, of a focal length of
/// 1/40 of that distance (50 mm at 2 m).
Lens lens_for(const Camera& camera, float f_stop);

/// Of the aperture: focal length / (2 f-stop), scene units. A polygon has its corners there.
double lens_radius(const Lens& lens);

/// s_i, scene units.
double image_distance(const Lens& lens);

/// Diameter of the disc on the image plane that a point `depth` in front of the lens is blurred to:
/// 2a |z - s_o| / z * f / (s_o - f), scene units; of a polygonal aperture that of the circle round
/// it. The image is 2 s_i tan(angle / 2) high.
double circle_of_confusion(const Lens& lens, double depth);

/// A point of the aperture, uniformly distributed for uniform pairs: its distances from the lens's
/// middle along the view's right and up, scene units.
struct AperturePoint {
    double right = 0, up = 0;
};
AperturePoint on_aperture(const Lens& lens, Pair pair);

}  // namespace rayshoot

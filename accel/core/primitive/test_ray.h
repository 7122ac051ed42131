#pragma once

#include "accel/core/box.h"

/// A ray with everything that box and primitive tests need of it, computed once.
namespace rayshoot::inline RAYSHOOT_ISA {

/// standard (`precision=default`): float Moeller-Trumbore. watertight: Woop et al. 2013, with
/// bounds padded so that no ray that starts within four scene diagonals slips between adjacent
/// triangles.
enum class Precision : std::uint8_t { standard, watertight };

/// Woop et al. 2013: the shear that maps the ray onto the unit z axis; z is the dominant axis.
struct Shear {
    int x = 0, y = 1, z = 2;
    float along_x = 0,
          along_y = 0;  ///< direction[x] / direction[z] and direction[y] / direction[z]

    Shear() = default;
    explicit Shear(const vec3& d) {
        const float ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
        z = az >= ax && az >= ay ? 2 : ay >= ax ? 1 : 0;
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        along_x = d[x] / d[z];
        along_y = d[y] / d[z];
    }
};

struct TestRay : SlabRay {
    vec3 direction;
    float direction_size;  ///< taxicab length
    float t_min;
    float time;
    Shear shear;  ///< for Precision::watertight alone

    TestRay(const Ray& ray, Precision precision)
        : SlabRay(ray.origin, ray.direction),
          direction(ray.direction),
          direction_size(taxicab(ray.direction)),
          t_min(ray.t_min),
          time(ray.time) {
        if (precision == Precision::watertight) shear = Shear(ray.direction);
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

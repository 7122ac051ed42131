#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tracer/bsdf/bsdf.h"

/// Materials of every model, from where they are looked at, and their BSDFs.
namespace rayshoot::tracer_tests {

struct Surface {
    std::string name;
    Material material;
    bool sharp = false;     ///< has a delta
    bool lossless = false;  ///< what comes in goes out
    float index = 1;        ///< of the medium behind the front, where light passes; else 1
};

/// Every model at several roughnesses.
std::vector<Surface> surfaces();

/// Unit, in the xz-plane at `degrees` from the normal z; from behind it below.
inline vec3 looking(double degrees, bool from_front = true) {
    const double angle = degrees * std::numbers::pi / 180;
    const double z = std::cos(angle);
    return vec3(dvec3(std::sin(angle), 0, from_front ? z : -z));
}

inline Bsdf bsdf_at(const Material& material, const vec3& out) {
    return Bsdf(material, SurfacePoint{}, out);
}

}  // namespace rayshoot::tracer_tests

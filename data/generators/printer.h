#pragma once

#include "data/scene.h"

#include <span>
#include <string>

/// Collects a scene with every number as the SPD programs print it (C's %g: six significant
/// digits), so that a generated scene is, bit for bit, the scene that reading their file gives.
namespace rayshoot::procedural {

/// `value` after printing with %g and reading back.
float printed(double value);
vec3 printed(const dvec3& value);

struct Eye {
    dvec3 from{0}, at{0}, up{0};
    double angle = 45;  ///< degrees
    double hither = 0;
    int resolution = 512;  ///< of both sides
};

struct Surface {
    dvec3 colour{1};
    double diffuse = 1, specular = 0;
    double highlight_angle =
        0;  ///< degrees at which the highlight is half as bright; 0: no highlight
    double transmittance = 0, refraction_index = 0;
};

inline constexpr dvec3 sky_blue{0.078, 0.361, 0.753};

class Printer {
public:
    void background(const dvec3& colour) { scene_.background = printed(colour); }
    void eye(const Eye& eye);
    void light(const dvec3& position);
    /// The surface of all that follows, until the next.
    void surface(const Surface& surface);
    void polygon(std::span<const dvec3> corners, std::span<const dvec3> normals = {});
    void sphere(const dvec3& centre, double radius);
    /// Corners that are floats already stay as they are.
    void triangle(const vec3& a, const vec3& b, const vec3& c);
    void frustum(const dvec3& base, double base_radius, const dvec3& apex, double apex_radius);

    std::uint32_t count() const { return builder_.size(); }  ///< primitives so far
    /// The scene so far; the lights share the intensity that NFF gives them.
    Scene scene(Precision precision) &&;

private:
    void paint();

    Scene scene_;
    GeometryBuilder builder_;
};

}  // namespace rayshoot::procedural

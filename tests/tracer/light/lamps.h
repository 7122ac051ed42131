#pragma once

#include <memory>
#include <string>
#include <vector>

#include "accel/core/catalogue.h"
#include "tracer/light/lights.h"

/// Scenes with one light of each kind, and what is asked of them.
namespace rayshoot::tracer_tests {

/// One light, which shines from geometry; the scene must stay where it is.
struct Lamp {
    std::string name;
    Scene scene;
    double area = 0;
};

/// A rectangle as a polygon and as two triangles, a disc as a polygon of many corners, a sphere, a
/// pyramid without a base, a sliver, a needle; each about `size` large, its middle at `at`. No part
/// of one hides another from where it is lit.
std::vector<std::unique_ptr<Lamp>> lamps(float size, const vec3& at);

/// Lights as they are made by hand, with samples that enclose them.
Light rectangle_light(const vec3& corner, const vec3& u, const vec3& v);
Light disc_light(const vec3& centre, const vec3& normal, float radius);
Light sphere_light(const vec3& centre, float radius);
/// A scene of nothing but this light.
Scene lit_by(const Light& light);

/// Brute force, one ray at a time.
class Oracle {
public:
    explicit Oracle(const Scene& scene);
    Hit closest(const Ray& ray) const;
    bool occluded(const Ray& ray) const;

private:
    std::unique_ptr<Accel> accel_;
    std::unique_ptr<Session> session_;
};

}  // namespace rayshoot::tracer_tests

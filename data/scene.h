#pragma once

#include "accel/core/build_input.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A scene: geometry, materials, lights, camera and, where the source gives one, a hierarchy.
namespace rayshoot {

/// The surface model of NFF: `f red green blue Kd Ks Shine T index_of_refraction`.
struct Material {
    vec3 colour{1};           ///< linear RGB in [0, 1]
    float diffuse = 1;        ///< Kd
    float specular = 0;       ///< Ks: highlight and mirror reflection
    float shininess = 1;      ///< Phong cosine power
    float transmittance = 0;  ///< T
    float refraction_index = 1;
};

/// The camera as scene files give it; tracer/ makes the View of an image size from it.
struct Camera {
    vec3 from{0, 0, 1}, at{0}, up{0, 1, 0};
    float angle = 45;  ///< degrees, full angle across the image's height (NFF: a square image)
    float hither = 0;  ///< distance along the axis before which nothing is seen; not applied by SPD
    int width = 512, height = 512;  ///< the resolution the file asks for
};

struct Scene {
    std::string name;  ///< the scene string that made it
    Geometry geometry;
    std::vector<Material> materials;
    std::vector<std::uint32_t> material_of;  ///< per primitive: index into materials
    std::vector<Light> lights;
    Camera camera;
    vec3 background{0};
    std::optional<Hierarchy> hierarchy;

    const Material& material(std::uint32_t primitive) const {
        return materials[material_of[primitive]];
    }
};

/// SHA-256 (hex) of everything above but the name: equal scenes have equal digests on every
/// machine.
std::string digest(const Scene& scene);

}  // namespace rayshoot

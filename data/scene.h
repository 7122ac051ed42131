#pragma once

#include "accel/core/build_input.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A scene: geometry, materials, lights, camera and, where the source gives one, a hierarchy.
namespace rayshoot {

/// How a surface scatters light; tracer/bsdf/README.md has the formulas. Each names the fields of
/// Material that it reads besides `emission`; the others have no effect.
enum class SurfaceModel : std::uint8_t {
    nff,         ///< colour, diffuse, specular, shininess, transmittance, refraction_index, gloss
    lambert,     ///< colour, diffuse
    oren_nayar,  ///< colour, diffuse, roughness
    phong,       ///< colour, diffuse, specular, shininess: normalised, no mirror reflection
    cook_torrance,  ///< colour, diffuse, specular, roughness, refraction_index: a coated diffuser
    conductor,      ///< colour (times Fresnel), roughness, eta, absorption
    dielectric,     ///< colour (times what passes), roughness, refraction_index
};

/// The surface model of NFF, `f red green blue Kd Ks Shine T index_of_refraction`, and beyond.
struct Material {
    vec3 colour{1};           ///< linear RGB in [0, 1]
    float diffuse = 1;        ///< Kd
    float specular = 0;       ///< Ks: highlight and mirror reflection
    float shininess = 1;      ///< Phong cosine power
    float transmittance = 0;  ///< T
    float refraction_index = 1;

    SurfaceModel model = SurfaceModel::nff;
    float roughness = 0;  ///< alpha of GGX in [0, 1], 0: smooth; Oren-Nayar: sigma, radians
    float gloss = 0;      ///< cosine power of blurred reflection and refraction; 0: sharp
    /// Of a conductor: its complex refraction index eta + i absorption. Here gold's at 630, 532 and
    /// 465 nm (Johnson & Christy 1972, rounded).
    vec3 eta{0.19f, 0.54f, 1.33f}, absorption{3.4f, 2.2f, 1.9f};
    /// Radiance, W/(m^2 sr), to the side that the stored normal faces; of spheres to both sides.
    vec3 emission{0};
};

/// A thin lens; lengths in scene units. Its image of what is `focus_distance` away is sharp.
struct Lens {
    float focal_length = 0;    ///< > 0 and less than focus_distance
    float f_stop = 0;          ///< > 0: focal length / diameter of the aperture
    float focus_distance = 0;  ///< from the lens to the plane in focus, along the viewing axis
    int blades = 0;            ///< of the aperture: 0 round, else a polygon of 3 or more corners
    float blade_angle = 0;     ///< degrees from the right to its first corner, towards up

    bool operator==(const Lens&) const = default;
};

/// The camera as scene files give it; tracer/ makes the View of an image size from it.
struct Camera {
    vec3 from{0, 0, 1}, at{0}, up{0, 1, 0};
    float angle = 45;  ///< degrees, full angle across the image's height (NFF: a square image)
    float hither = 0;  ///< distance along the axis before which nothing is seen; not applied by SPD
    int width = 512, height = 512;  ///< the resolution the file asks for
    std::optional<Lens> lens;       ///< none: a pinhole
    std::optional<Motion> motion;   ///< of the whole camera; the pose above is its rest frame
    /// Ray times between which the shutter is open, in [0, 1]; equal: an instant. Readers evaluate
    /// motions where the frame's shutter opens and closes, which then are times 0 and 1.
    float shutter_open = 0, shutter_close = 1;
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
    std::vector<std::string> notes;  ///< what the source asks for and this scene leaves out

    const Material& material(std::uint32_t primitive) const {
        return materials[material_of[primitive]];
    }
};

/// SHA-256 (hex) of everything above but the name and the notes: equal scenes have equal digests on
/// every machine.
std::string digest(const Scene& scene);

}  // namespace rayshoot

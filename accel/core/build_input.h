#pragma once

#include "accel/core/geometry.h"

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// What a structure is built from: plain structs, filled by `data` and `tracer`.
/// A structure keeps references only to these; anything absent makes a partial structure decline.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The camera: cell (x, y) of the raster is the closed unit square [x, x+1] x [y, y+1] of raster
/// points, y downward. Raster point (x, y) lies in direction to_corner + x * across + y * down,
/// whose forward component is 1; a camera ray leaves the lens disc round `eye` and meets that
/// direction's line through `eye` on the plane at focus_distance along `forward`.
struct View {
    vec3 eye{0};
    vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  ///< orthonormal
    vec3 to_corner{-1, 1, -1}, across{0}, down{0};
    int width = 0, height = 0;     ///< cells
    int border = 0;                ///< cells that may be asked for outside the image, on each side
    float lens_radius = 0;         ///< scene units; 0 is a pinhole
    float focus_distance = 1;      ///< scene units along forward
    float near_distance = 0;       ///< scene units along forward; rays start there ("hither")
    std::optional<Motion> motion;  ///< of the whole camera over the shutter

    vec3 direction(float x, float y) const { return to_corner + x * across + y * down; }
};

enum class LightKind : std::uint8_t {
    point,
    directional,
    spot,
    rectangle,
    disc,
    sphere,
    triangles
};

/// How the irradiance of point and spot lights depends on distance.
enum class Falloff : std::uint8_t {
    none,           ///< Phong 1975: a white diffuser that faces the light has radiance `intensity`
    inverse_square  ///< physical: `intensity` is the radiant intensity
};

/// Rectangle, disc and triangles shine to the side of their normal, a sphere to both sides.
struct Light {
    LightKind kind = LightKind::point;
    vec3 position{0};           ///< point, spot, disc, sphere: centre; rectangle: one corner
    vec3 direction{0, 0, -1};   ///< unit; directional, spot: of the light's travel; disc: normal
    vec3 edge_u{0}, edge_v{0};  ///< rectangle: the two sides from `position`
    float radius = 0;           ///< disc, sphere; scene units
    float cos_inner = 1, cos_outer = 1;  ///< spot: full inside the first, dark outside the second
    /// Numbers of the emitting primitives. triangles: the triangles; rectangle, disc and sphere:
    /// what is in its place, if anything is, facing as it does and moving as one. They shine with
    /// `intensity`, whatever the emission of their materials.
    std::vector<std::uint32_t> primitives;
    /// RGB, linear. Rectangle, disc, sphere, triangles: radiance, W/(m^2 sr); point, spot: radiant
    /// intensity, W/sr; directional: irradiance where it falls at right angles, W/m^2. The last
    /// three mean that with Falloff::inverse_square only.
    vec3 intensity{1};
    Box samples;  ///< encloses every point a shadow ray may aim at; empty: directional
    int strata_u = 1, strata_v = 1;
    Falloff falloff = Falloff::none;  ///< of point and spot; directional: the unit of intensity
};

/// Groups and bounding volumes as the scene gives them (Rubin & Whitted 1980). Group 0 is the root.
struct Hierarchy {
    struct Group {
        std::variant<std::monostate, Box, Sphere> bound;  ///< monostate: none was given
        std::vector<std::uint32_t> groups;
        std::vector<std::uint32_t> primitives;
    };
    std::vector<Group> groups;
};

struct BuildInput {
    const Geometry& geometry;
    std::optional<View> view = std::nullopt;
    std::span<const Light> lights = {};
    const Hierarchy* given = nullptr;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

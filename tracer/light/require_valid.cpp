#include "tracer/light/require_valid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace rayshoot {
namespace {

/// How far a light's primitives may be off it, from rounding or a disc's corners.
constexpr double placement_slack = 1e-2;  // of the light's size
constexpr float unit_slack = 1e-3f;       // of a direction's length
/// What shadow rays may miss the samples by (accel/core/promise.h).
constexpr float samples_slack = 0x1p-18f;  // of taxicab(lo) + taxicab(hi)

void require(bool holds, const char* complaint) {
    if (!holds) throw std::invalid_argument(complaint);
}

bool is_flat(const Light& light) {
    return light.kind == LightKind::rectangle || light.kind == LightKind::disc;
}

void require_numbers(const Light& light) {
    const vec3& i = light.intensity;
    require(finite(i) && std::min({i.x, i.y, i.z}) >= 0,
            "a light's intensity is negative or not finite; give three numbers of at least 0");
    require(finite(light.position), "a light's position is not finite");
    if (light.kind == LightKind::directional || light.kind == LightKind::spot ||
        light.kind == LightKind::disc) {
        require(std::abs(length(light.direction) - 1) < unit_slack,
                "a light's direction is not a unit vector; normalise it");
    }
    if (light.kind == LightKind::spot)
        require(light.cos_inner >= light.cos_outer,
                "a spot is full in a wider cone than the one it is dark outside of; exchange them");
}

void require_extent(const Light& light) {
    if (light.kind == LightKind::rectangle) {
        const vec3 area = cross(light.edge_u, light.edge_v);
        require(finite(area) && length(dvec3(area)) > 0,
                "a rectangular light has no area; give two sides that are not parallel");
    }
    if (light.kind == LightKind::disc || light.kind == LightKind::sphere)
        require(light.radius > 0 && std::isfinite(light.radius),
                "a light's radius is not positive; give one, or make it a point light");
    if (light.kind == LightKind::triangles)
        require(!light.primitives.empty(), "a light of triangles has none; give their numbers");
}

std::vector<dvec3> corners_of(const Geometry& geometry, const PrimitiveRef& ref) {
    if (ref.kind == PrimitiveKind::triangle) {
        const Triangle triangle = geometry.triangle(ref.index);
        return {dvec3(triangle.a), dvec3(triangle.b), dvec3(triangle.c)};
    }
    std::vector<dvec3> corners;
    for (const vec3& corner : geometry.polygon(ref.index).corners) corners.emplace_back(corner);
    return corners;
}

/// Right-handed, as long as twice the area (Newell).
dvec3 area_vector(const std::vector<dvec3>& corners) {
    dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

/// In the plane of a rectangle or disc, within its outline, facing as it does, and all of it.
void require_cover(const Light& light, const Geometry& geometry) {
    const bool rectangle = light.kind == LightKind::rectangle;
    const dvec3 u(light.edge_u), v(light.edge_v), origin(light.position);
    const dvec3 facing = rectangle ? normalised(cross(u, v)) : dvec3(light.direction);
    const double size = rectangle ? std::max(length(u), length(v)) : double{light.radius};
    const double reach = rectangle ? length(u + v) / 2 : size;
    const dvec3 centre = rectangle ? origin + (u + v) * 0.5 : origin;
    double area = 0;
    for (const std::uint32_t primitive : light.primitives) {
        const std::vector<dvec3> corners = corners_of(geometry, geometry.ref(primitive));
        area += dot(area_vector(corners), facing) / 2;
        for (const dvec3& corner : corners) {
            const double off = std::abs(dot(corner - centre, facing));
            require(off <= placement_slack * size &&
                        length(corner - centre) <= (1 + placement_slack) * reach,
                    "a light's primitive is not where the light is; leave it out, or move it");
        }
    }
    const double whole = rectangle ? length(cross(u, v)) : std::numbers::pi * size * size;
    require(std::abs(area - whole) <= 5 * placement_slack * whole,
            "a light's primitives do not cover it, or face the other way; give all of them, and "
            "their corners counter-clockwise as seen from the lit side");
}

void require_same_sphere(const Light& light, const Geometry& geometry) {
    require(light.primitives.size() == 1, "a spherical light shines from one sphere; give one");
    const Sphere& sphere = geometry.sphere(geometry.ref(light.primitives.front()).index);
    const float slack = unit_slack * light.radius;
    require(std::abs(sphere.radius - light.radius) <= slack &&
                length(sphere.centre - light.position) <= slack,
            "a spherical light is not where its sphere is; give both the same centre and radius");
}

bool may_shine(LightKind kind, PrimitiveKind primitive) {
    if (kind == LightKind::sphere) return primitive == PrimitiveKind::sphere;
    if (kind == LightKind::triangles) return primitive == PrimitiveKind::triangle;
    return primitive == PrimitiveKind::triangle || primitive == PrimitiveKind::polygon;
}

void require_primitives(const Light& light, const Geometry& geometry) {
    if (light.primitives.empty()) return;
    const bool extended =
        is_flat(light) || light.kind == LightKind::sphere || light.kind == LightKind::triangles;
    require(extended, "a light without extent has primitives; leave them out, or give it an area");
    for (const std::uint32_t primitive : light.primitives) {
        require(primitive < geometry.size(), "a light shines from a primitive that does not exist");
        require(may_shine(light.kind, geometry.ref(primitive).kind),
                "a light shines from a primitive of the wrong kind; give triangles to a light of "
                "triangles, a sphere to a sphere, triangles or polygons to rectangles and discs");
        require(geometry.ref(primitive).motion == geometry.ref(light.primitives.front()).motion,
                "a light's primitives move differently; make several lights of it");
    }
    if (is_flat(light)) require_cover(light, geometry);
    if (light.kind == LightKind::sphere) require_same_sphere(light, geometry);
}

/// Some of the points that enclose the light, at rest.
std::vector<vec3> outline(const Light& light) {
    const vec3 &p = light.position, &u = light.edge_u, &v = light.edge_v;
    if (light.kind == LightKind::rectangle) return {p, p + u, p + v, p + u + v};
    return {p};
}

void require_samples(const Light& light, const Geometry& geometry) {
    if (light.kind == LightKind::directional) return;
    const Box& box = light.samples;
    const char* complaint =
        "a light's samples do not enclose it; include each of its points, over all of the shutter";
    require(!box.empty(), complaint);
    const Box grown = box.grown(samples_slack * (taxicab(box.lo) + taxicab(box.hi)));
    for (const std::uint32_t primitive : light.primitives) {
        const vec3 centre = geometry.bounds(primitive).centre();
        require(grown.contains(centre), complaint);
    }
    if (!light.primitives.empty()) return;  // it may move
    for (const vec3& point : outline(light)) require(grown.contains(point), complaint);
}

}  // namespace

void require_valid(const Light& light, const Scene& scene) {
    require_numbers(light);
    require_extent(light);
    require_primitives(light, scene.geometry);
    require_samples(light, scene.geometry);
}

}  // namespace rayshoot

#include "data/emitters.h"

#include <map>
#include <stdexcept>
#include <utility>

namespace rayshoot {
namespace {

bool emits(const Material& material) { return material.emission != vec3(0); }

std::vector<bool> owned_by_lights(const Scene& scene) {
    std::vector<bool> owned(scene.geometry.size());
    for (const Light& light : scene.lights)
        for (const std::uint32_t primitive : light.primitives) owned.at(primitive) = true;
    return owned;
}

Light light_of(const Scene& scene, std::uint32_t primitive) {
    const PrimitiveRef& ref = scene.geometry.ref(primitive);
    Light light;
    light.falloff = Falloff::inverse_square;
    light.intensity = scene.material(primitive).emission;
    if (ref.kind == PrimitiveKind::sphere) {
        light.kind = LightKind::sphere;
        light.position = scene.geometry.sphere(ref.index).centre;
        light.radius = scene.geometry.sphere(ref.index).radius;
    } else if (ref.kind == PrimitiveKind::polygon) {
        const std::vector<vec3>& corners = scene.geometry.polygon(ref.index).corners;
        light.kind = LightKind::rectangle;
        light.position = corners[0];
        light.edge_u = corners[1] - corners[0];
        light.edge_v = corners[3] - corners[0];
    } else {
        light.kind = LightKind::triangles;
    }
    return light;
}

}  // namespace

bool is_rectangle(std::span<const vec3> corners) {
    if (corners.size() != 4) return false;
    constexpr double slack = 1e-4;  // share of the sides: corners are printed and rounded
    const dvec3 origin(corners[0]), u = dvec3(corners[1]) - origin, v = dvec3(corners[3]) - origin;
    const double across = length(u), down = length(v);
    const dvec3 off = dvec3(corners[2]) - origin - u - v;
    return across > 0 && down > 0 && std::abs(dot(u, v)) <= slack * across * down &&
           length(off) <= slack * std::min(across, down);
}

std::string not_a_light(const Geometry& geometry, std::uint32_t primitive) {
    const PrimitiveRef& ref = geometry.ref(primitive);
    if (ref.kind == PrimitiveKind::frustum) return "a cone cannot emit light; make it of triangles";
    if (ref.kind == PrimitiveKind::polygon && !is_rectangle(geometry.polygon(ref.index).corners))
        return "a polygon that emits light must be a rectangle; cut it into triangles";
    return {};
}

void occupy(Light& light, const Geometry& geometry, std::vector<std::uint32_t> primitives) {
    light.primitives = std::move(primitives);
    light.samples = {};
    for (const std::uint32_t primitive : light.primitives)
        light.samples.include(geometry.bounds(primitive));
}

void add_emitters(Scene& scene) {
    const std::vector<bool> owned = owned_by_lights(scene);
    using Mesh = std::pair<std::uint32_t, std::uint32_t>;  // material and motion
    std::map<Mesh, std::vector<std::uint32_t>> meshes;
    for (std::uint32_t i = 0; i < scene.geometry.size(); ++i) {
        if (owned[i] || !emits(scene.material(i))) continue;
        if (const std::string why = not_a_light(scene.geometry, i); !why.empty())
            throw std::invalid_argument("primitive " + std::to_string(i) + ": " + why);
        const PrimitiveRef& ref = scene.geometry.ref(i);
        if (ref.kind == PrimitiveKind::triangle) {
            meshes[{scene.material_of[i], ref.motion}].push_back(i);
            continue;
        }
        occupy(scene.lights.emplace_back(light_of(scene, i)), scene.geometry, {i});
    }
    for (auto& [mesh, triangles] : meshes) {
        Light light = light_of(scene, triangles.front());
        occupy(light, scene.geometry, std::move(triangles));
        scene.lights.push_back(std::move(light));
    }
}

}  // namespace rayshoot

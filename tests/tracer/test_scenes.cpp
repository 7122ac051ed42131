#include "tests/tracer/test_scenes.h"

#include <array>

namespace rayshoot::tracer_tests {
namespace {

Light point_light(const vec3& position, float intensity) {
    Light light;
    light.position = position;
    light.samples.include(position);
    light.intensity = vec3(intensity);
    return light;
}

vec3 shading_normal(const Geometry& geometry, std::uint32_t primitive, float u, float v) {
    return geometry.normal(Ray{}, Hit{1, primitive, u, v}).shading;
}

std::uint32_t add_scaled(const Geometry& from, std::uint32_t primitive, float factor,
                         GeometryBuilder& to) {
    const PrimitiveRef& ref = from.ref(primitive);
    switch (ref.kind) {
        case PrimitiveKind::triangle: {
            const Triangle triangle = from.triangle(ref.index);
            const std::array corners{triangle.a * factor, triangle.b * factor, triangle.c * factor};
            const std::array normals{shading_normal(from, primitive, 0, 0),
                                     shading_normal(from, primitive, 1, 0),
                                     shading_normal(from, primitive, 0, 1)};
            return to.add_polygon(corners, normals);
        }
        case PrimitiveKind::sphere: {
            const Sphere& sphere = from.sphere(ref.index);
            return to.add_sphere({sphere.centre * factor, sphere.radius * factor});
        }
        case PrimitiveKind::frustum: {
            const Frustum& frustum = from.frustum(ref.index);
            return to.add_frustum({frustum.base * factor, frustum.base_radius * factor,
                                   frustum.apex * factor, frustum.apex_radius * factor});
        }
        case PrimitiveKind::polygon:
            break;
    }
    const Polygon& polygon = from.polygon(ref.index);
    std::vector<vec3> corners = polygon.corners;
    for (vec3& corner : corners) corner *= factor;
    return to.add_polygon(corners, polygon.normals);
}

}  // namespace

Scene small_scene() {
    GeometryBuilder builder;
    Scene scene;
    const auto add = [&](std::uint32_t, const Material& material) {
        scene.material_of.push_back(static_cast<std::uint32_t>(scene.materials.size()));
        scene.materials.push_back(material);
    };
    const std::array<vec3, 4> floor{vec3(-4, -4, 0), {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
    add(builder.add_polygon(floor), {.colour = {0.8f, 0.7f, 0.5f}, .diffuse = 0.8f});
    add(builder.add_sphere({{-0.8f, 0, 0.7f}, 0.7f}),
        {.diffuse = 0.2f, .specular = 0.7f, .shininess = 30});
    add(builder.add_sphere({{0.7f, -0.9f, 0.5f}, 0.5f}), {.diffuse = 0.1f,
                                                          .specular = 0.1f,
                                                          .shininess = 9.5f,
                                                          .transmittance = 0.8f,
                                                          .refraction_index = 1.5f});
    add(builder.add_frustum({{1, 1, 0}, 0.6f, {1, 1, 1.5f}, 0.1f}),
        {.colour = {0.2f, 0.9f, 0.3f}, .specular = 0.2f, .shininess = 3});
    add(builder.add_triangle({-2, 2, 0}, {2, 2.5f, 0}, {0, 2.2f, 2.5f}),
        {.colour = {0.3f, 0.3f, 1}});
    scene.name = "small";
    scene.geometry = std::move(builder).build();
    scene.lights = {point_light({3, -3, 5}, 0.6f), point_light({-4, -2, 3}, 0.5f)};
    scene.camera.from = {0.5f, -5, 2};
    scene.camera.at = {0, 0, 0.6f};
    scene.camera.up = {0, 0, 1};
    scene.background = {0.1f, 0.3f, 0.7f};
    return scene;
}

Scene scaled(const Scene& scene, float factor) {
    Scene result;
    result.name = scene.name;
    GeometryBuilder builder;
    for (std::uint32_t i = 0; i < scene.geometry.size(); ++i) {
        add_scaled(scene.geometry, i, factor, builder);
    }
    result.geometry = std::move(builder).build();
    result.materials = scene.materials;
    result.material_of = scene.material_of;
    for (const Light& light : scene.lights) {
        result.lights.push_back(light);
        result.lights.back().position *= factor;
        result.lights.back().samples = {light.samples.lo * factor, light.samples.hi * factor};
    }
    result.camera = scene.camera;
    result.camera.from *= factor;
    result.camera.at *= factor;
    result.background = scene.background;
    return result;
}

std::unique_ptr<Accel> build(const Scene& scene, const std::string& spec,
                             const ImageFormat& format) {
    return rayshoot::build(built_in_catalogue(), spec, build_input(scene, format));
}

RenderResult render(const Scene& scene, const std::string& spec, const RenderSettings& settings) {
    return rayshoot::render(scene, *build(scene, spec, settings.format), settings);
}

}  // namespace rayshoot::tracer_tests

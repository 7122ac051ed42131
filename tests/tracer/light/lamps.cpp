#include "tests/tracer/light/lamps.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace rayshoot::tracer_tests {
namespace {

constexpr double pi_ = std::numbers::pi;

/// Everything in it emits.
std::unique_ptr<Lamp> finished(std::string name, GeometryBuilder&& builder, Light light,
                               double area) {
    auto lamp = std::make_unique<Lamp>();
    lamp->name = std::move(name);
    lamp->area = area;
    lamp->scene.geometry = std::move(builder).build();
    for (std::uint32_t i = 0; i < lamp->scene.geometry.size(); ++i) light.primitives.push_back(i);
    light.samples.include(lamp->scene.geometry.bounds());
    lamp->scene.materials.emplace_back();
    lamp->scene.material_of.assign(lamp->scene.geometry.size(), 0);
    lamp->scene.lights.push_back(std::move(light));
    return lamp;
}

std::unique_ptr<Lamp> of_polygon(float size, const vec3& at) {
    const vec3 u = size * vec3(1, 0.5f, 0), v = size * vec3(-0.25f, 0.5f, 0.5f);
    const vec3 corner = at - 0.5f * (u + v);
    const std::array<vec3, 4> corners{corner, corner + u, corner + u + v, corner + v};
    GeometryBuilder builder;
    builder.add_polygon(corners);
    return finished("polygon", std::move(builder), rectangle_light(corner, u, v),
                    length(dvec3(cross(u, v))));
}

std::unique_ptr<Lamp> of_two_triangles(float size, const vec3& at) {
    const vec3 u = size * vec3(0.5f, 0, 0.25f), v = size * vec3(0, 1, 0);
    const vec3 corner = at - 0.5f * (u + v);
    GeometryBuilder builder;
    builder.add_triangle(corner, corner + u, corner + u + v);
    builder.add_triangle(corner, corner + u + v, corner + v);
    return finished("two triangles", std::move(builder), rectangle_light(corner, u, v),
                    length(dvec3(cross(u, v))));
}

std::unique_ptr<Lamp> of_disc(float size, const vec3& at) {
    constexpr int corner_count = 96;
    std::vector<vec3> corners;
    for (int i = 0; i < corner_count; ++i) {
        const double turn = 2 * pi_ * i / corner_count;
        corners.push_back(at + vec3(dvec3(std::cos(turn), 0, -std::sin(turn)) * double{size}));
    }
    GeometryBuilder builder;
    builder.add_polygon(corners);
    return finished("disc", std::move(builder), disc_light(at, {0, 1, 0}, size), pi_ * size * size);
}

std::unique_ptr<Lamp> of_sphere(float size, const vec3& at) {
    GeometryBuilder builder;
    builder.add_sphere({at, size});
    return finished("sphere", std::move(builder), sphere_light(at, size), 4 * pi_ * size * size);
}

std::unique_ptr<Lamp> of_mesh(std::string name, std::span<const std::array<vec3, 3>> triangles,
                              float size, const vec3& at) {
    GeometryBuilder builder;
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
        builder.add_triangle(at + size * a, at + size * b, at + size * c);
        area += size * size * length(cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a))) / 2;
    }
    Light light;
    light.kind = LightKind::triangles;
    return finished(std::move(name), std::move(builder), light, area);
}

std::unique_ptr<Lamp> of_pyramid(float size, const vec3& at) {
    const std::array<vec3, 4> base{vec3(1, 0, 1), vec3(1, 0, -1), vec3(-1, 0, -1), vec3(-1, 0, 1)};
    std::vector<std::array<vec3, 3>> faces;
    for (std::size_t i = 0; i < 4; ++i)
        faces.push_back({base[i], base[(i + 1) % 4], vec3(0.2f, 0.8f, 0.1f)});
    return of_mesh("pyramid", faces, size, at);
}

/// Twelve times as long as wide: its test is as bad as a float test is let be.
std::unique_ptr<Lamp> of_sliver(float size, const vec3& at) {
    const std::array<std::array<vec3, 3>, 1> sliver{
        {{vec3(-2, -1, -2), vec3(2, 1.1f, 2), vec3(2.1f, 0.8f, 1.8f)}}};
    return of_mesh("sliver", sliver, size, at);
}

/// A hundred times as long as wide.
std::unique_ptr<Lamp> of_needle(float size, const vec3& at) {
    const std::array<std::array<vec3, 3>, 1> needle{
        {{vec3(-3, 0, 0), vec3(3, 0.1f, 0.2f), vec3(3, 0.1f, 0.14f)}}};
    return of_mesh("needle", needle, size, at);
}

}  // namespace

std::vector<std::unique_ptr<Lamp>> lamps(float size, const vec3& at) {
    std::vector<std::unique_ptr<Lamp>> all;
    for (const auto make :
         {of_polygon, of_two_triangles, of_disc, of_sphere, of_pyramid, of_sliver, of_needle})
        all.push_back(make(size, at));
    return all;
}

Light rectangle_light(const vec3& corner, const vec3& u, const vec3& v) {
    Light light;
    light.kind = LightKind::rectangle;
    light.position = corner;
    light.edge_u = u;
    light.edge_v = v;
    for (const vec3& to : {vec3(0), u, v, u + v}) light.samples.include(corner + to);
    return light;
}

Light disc_light(const vec3& centre, const vec3& normal, float radius) {
    Light light;
    light.kind = LightKind::disc;
    light.position = centre;
    light.direction = normal;
    light.radius = radius;
    light.samples.include(centre - vec3(radius));
    light.samples.include(centre + vec3(radius));
    return light;
}

Light sphere_light(const vec3& centre, float radius) {
    Light light = disc_light(centre, {0, 0, 1}, radius);
    light.kind = LightKind::sphere;
    return light;
}

Scene lit_by(const Light& light) {
    Scene scene;
    scene.lights.push_back(light);
    return scene;
}

Oracle::Oracle(const Scene& scene)
    : accel_(build(built_in_catalogue(), "brute_force", BuildInput{scene.geometry})),
      session_(accel_->open(Mode::timing)) {}

Hit Oracle::closest(const Ray& ray) const {
    Hit hit;
    session_->closest({RayKind::secondary, 1, {&ray, 1}, {}}, {&hit, 1});
    return hit;
}

bool Oracle::occluded(const Ray& ray) const {
    std::uint8_t occluded = 0;
    session_->occluded({RayKind::secondary, 1, {&ray, 1}, {}}, {&occluded, 1});
    return occluded != 0;
}

}  // namespace rayshoot::tracer_tests

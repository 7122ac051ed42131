#include "data/generators/printer.h"

#include "data/nff.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>
#include <vector>

namespace rayshoot::procedural {

namespace {

/// NFF's `shine`: the cosine power that halves the highlight at `angle` degrees off its middle.
double shininess(double angle) {
    constexpr double invisible = 100000;
    if (angle <= 0) return invisible;
    return std::log(0.5) / std::log(std::cos(std::numbers::pi * angle / 180));
}

std::vector<vec3> all_printed(std::span<const dvec3> values) {
    std::vector<vec3> result;
    result.reserve(values.size());
    for (const dvec3& value : values) result.push_back(printed(value));
    return result;
}

}  // namespace

float printed(double value) {
    constexpr int significant_digits = 6;
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::general, significant_digits)
                         .ptr;
    float result = 0;
    // Far below the smallest float there is nothing to read back: a zero of the same sign.
    if (std::from_chars(text.data(), end, result).ec != std::errc{})
        result = std::copysign(0.0f, static_cast<float>(value));
    return result;
}

vec3 printed(const dvec3& value) { return {printed(value.x), printed(value.y), printed(value.z)}; }

void Printer::eye(const Eye& eye) {
    scene_.camera = {.from = printed(eye.from),
                     .at = printed(eye.at),
                     .up = printed(eye.up),
                     .angle = printed(eye.angle),
                     .hither = printed(eye.hither),
                     .width = eye.resolution,
                     .height = eye.resolution};
}

void Printer::light(const dvec3& position) {
    Light light;
    light.position = printed(position);
    light.samples.include(light.position);
    scene_.lights.push_back(light);
}

void Printer::surface(const Surface& surface) {
    scene_.materials.push_back({.colour = printed(surface.colour),
                                .diffuse = printed(surface.diffuse),
                                .specular = printed(surface.specular),
                                .shininess = printed(shininess(surface.highlight_angle)),
                                .transmittance = printed(surface.transmittance),
                                .refraction_index = printed(surface.refraction_index)});
}

void Printer::polygon(std::span<const dvec3> corners, std::span<const dvec3> normals) {
    builder_.add_polygon(all_printed(corners), all_printed(normals));
    paint();
}

void Printer::sphere(const dvec3& centre, double radius) {
    builder_.add_sphere({.centre = printed(centre), .radius = printed(radius)});
    paint();
}

void Printer::triangle(const vec3& a, const vec3& b, const vec3& c) {
    builder_.add_triangle(a, b, c);
    paint();
}

void Printer::frustum(const dvec3& base, double base_radius, const dvec3& apex,
                      double apex_radius) {
    builder_.add_frustum({.base = printed(base),
                          .base_radius = printed(base_radius),
                          .apex = printed(apex),
                          .apex_radius = printed(apex_radius)});
    paint();
}

void Printer::paint() {
    scene_.material_of.push_back(static_cast<std::uint32_t>(scene_.materials.size() - 1));
}

Scene Printer::scene(Precision precision) && {
    for (Light& light : scene_.lights)
        light.intensity = vec3(nff_light_intensity(scene_.lights.size()));
    scene_.geometry = std::move(builder_).build(precision);
    return std::move(scene_);
}

}  // namespace rayshoot::procedural

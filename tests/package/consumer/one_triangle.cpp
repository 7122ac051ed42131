#include "accel/core/catalogue.h"

#include <array>
#include <cstdio>

using namespace rayshoot;

int main() {
    GeometryBuilder builder;
    builder.add_triangle(vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{0, 1, 0});
    const Geometry geometry = std::move(builder).build();
    const BuildInput input{.geometry = geometry};
    const auto accel = build(built_in_catalogue(), "bvh", input);
    const auto session = accel->open(Mode::timing);

    const std::array rays{Ray{.origin = {0.25f, 0.25f, 2}, .direction = {0, 0, -1}}};
    std::array<Hit, 1> hits;
    session->closest({.rays = rays}, hits);
    std::printf("t = %g, primitive %u, u = %g, v = %g\n", double{hits[0].t}, hits[0].primitive,
                double{hits[0].u}, double{hits[0].v});
    return hits[0] == Hit{2, 0, 0.25f, 0.25f} ? 0 : 1;
}

#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

/// Nothing, one thing, and the few scenes that should be easy.
namespace rayshoot::contract {
namespace {

void empty(GeometryBuilder&) {}

void one_triangle(GeometryBuilder& builder) {
    builder.add_triangle(vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0));
}

void one_slanted_triangle(GeometryBuilder& builder) {
    builder.add_triangle(vec3(0.1f, 0.2f, 0.3f), vec3(1.3f, 0.7f, -0.4f), vec3(-0.2f, 1.1f, 0.9f));
}

void degenerate_triangles(GeometryBuilder& builder) {
    builder.add_triangle(vec3(0.5f), vec3(0.5f), vec3(0.5f));
    builder.add_triangle(vec3(0), vec3(1), vec3(0));
    builder.add_triangle(vec3(0), vec3(1), vec3(2));
    builder.add_triangle(vec3(0, 0, 1), vec3(1, 0, 1), vec3(3, 0, 1));
    builder.add_triangle(vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0));
}

void two_triangles(GeometryBuilder& builder) {
    add_quad(builder, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0));
}

void cube(GeometryBuilder& builder) { add_cube(builder, vec3(-1), vec3(1)); }

void soup(GeometryBuilder& builder) {
    Random random(0x50757);
    add_soup(builder, random, Box{vec3(-1), vec3(1)}, 0.2f, 300);
}

}  // namespace

std::vector<Recipe> plain_scenes() {
    return {{"empty", empty},
            {"one_triangle", one_triangle},
            {"one_slanted_triangle", one_slanted_triangle},
            {"degenerate_triangles", degenerate_triangles},
            {"two_triangles", two_triangles},
            {"cube", cube},
            {"soup", soup}};
}

}  // namespace rayshoot::contract

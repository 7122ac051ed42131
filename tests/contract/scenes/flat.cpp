#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

/// Scenes without extent along one, two or three axes.
namespace rayshoot::contract {
namespace {

/// A sheet of `cells` x `cells` quads across `axis`, at height `at`.
void add_sheet(GeometryBuilder& builder, int axis, float at, int cells) {
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k) {
            vec3 corner(0), u(0), v(0);
            corner[axis] = at;
            corner[(axis + 1) % 3] = static_cast<float>(i) / static_cast<float>(cells);
            corner[(axis + 2) % 3] = static_cast<float>(k) / static_cast<float>(cells);
            u[(axis + 1) % 3] = 1 / static_cast<float>(cells);
            v[(axis + 2) % 3] = 1 / static_cast<float>(cells);
            add_quad(builder, corner, u, v);
        }
}

void flat_x(GeometryBuilder& builder) { add_sheet(builder, 0, 0, 10); }
void flat_y(GeometryBuilder& builder) { add_sheet(builder, 1, -2.5f, 9); }
void flat_z(GeometryBuilder& builder) { add_sheet(builder, 2, 0.1f, 8); }

void layers(GeometryBuilder& builder) {
    float at = 0;
    for (int i = 0; i < 12; ++i) {
        add_sheet(builder, 2, at, 3);
        at = i % 3 == 0 ? std::nextafter(at, infinity) : at + 0.1f;  // neighbours an ulp apart
    }
}

/// Triangles without area on one line: bounds without extent along two axes.
void on_a_line(GeometryBuilder& builder) {
    for (int i = 0; i < 40; ++i)
        builder.add_triangle(vec3(i, 0, 0), vec3(i + 2, 0, 0), vec3(i + 1, 0, 0));
}

void in_a_point(GeometryBuilder& builder) {
    for (int i = 0; i < 40; ++i) builder.add_triangle(vec3(1, 2, 3), vec3(1, 2, 3), vec3(1, 2, 3));
    for (int i = 0; i < 10; ++i) builder.add_sphere({vec3(1, 2, 3), 0});
}

void flat_polygons(GeometryBuilder& builder) {
    for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 6; ++k) {
            const vec3 at(i, k, 0);
            const std::array<vec3, 6> ell{at,
                                          at + vec3(1, 0, 0),
                                          at + vec3(1, 0.5f, 0),
                                          at + vec3(0.5f, 0.5f, 0),
                                          at + vec3(0.5f, 1, 0),
                                          at + vec3(0, 1, 0)};
            builder.add_polygon(ell);
        }
}

}  // namespace

std::vector<Recipe> flat_scenes() {
    return {{"flat_x", flat_x},
            {"flat_y", flat_y},
            {"flat_z", flat_z},
            {"layers", layers},
            {"on_a_line", on_a_line},
            {"in_a_point", in_a_point},
            {"flat_polygons", flat_polygons}};
}

}  // namespace rayshoot::contract

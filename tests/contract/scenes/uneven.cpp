#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

/// Much detail in a small part of the scene.
namespace rayshoot::contract {
namespace {

/// Radius of the pot's outline at height h in [0, 1]: a foot, a belly and a narrow mouth.
float outline(float h) { return 0.3f + 1.6f * h * (1 - h) * (1.2f - 0.5f * h); }

vec3 pot_point(int ring, int spoke, int rings, int spokes) {
    const float h = static_cast<float>(ring) / static_cast<float>(rings);
    const auto [x, y] = circle(4 * static_cast<float>(spoke % spokes) / static_cast<float>(spokes));
    return {outline(h) * x, outline(h) * y, h};
}

void add_pot(GeometryBuilder& builder, const vec3& at, float size, int rings, int spokes) {
    for (int ring = 0; ring < rings; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const vec3 a = at + size * pot_point(ring, spoke, rings, spokes);
            const vec3 b = at + size * pot_point(ring, spoke + 1, rings, spokes);
            const vec3 c = at + size * pot_point(ring + 1, spoke + 1, rings, spokes);
            const vec3 d = at + size * pot_point(ring + 1, spoke, rings, spokes);
            builder.add_triangle(a, b, c);
            builder.add_triangle(a, c, d);
        }
}

/// A pot of one unit on the ground of a stadium of two thousand.
void pot_in_stadium(GeometryBuilder& builder) {
    add_quad(builder, vec3(-1000, -1000, 0), vec3(2000, 0, 0), vec3(0, 2000, 0));
    for (int i = 0; i < 40; ++i) {
        const auto [x, y] = circle(0.1f * static_cast<float>(i));
        const vec3 seat(900 * x, 900 * y, 10);
        builder.add_triangle(seat, seat + vec3(60 * x, 60 * y, 40),
                             seat + vec3(-90 * y, 90 * x, 5));
    }
    add_pot(builder, vec3(0.25f, -0.5f, 0), 1, 12, 16);
}

/// Each cube a thousandth of the one before, in its corner.
void nested_corners(GeometryBuilder& builder) {
    float size = 1e6f;
    for (int level = 0; level < 5; ++level, size *= 1e-3f) {
        add_cube(builder, vec3(0), vec3(size));
        builder.add_sphere({vec3(0.5f * size), 0.25f * size});
    }
}

void large_over_small(GeometryBuilder& builder) {
    Random random(0x1a56e);
    add_soup(builder, random, Box{vec3(-0.01f), vec3(0.01f)}, 0.002f, 150);
    add_soup(builder, random, Box{vec3(-10), vec3(10)}, 20, 20);
    builder.add_sphere({vec3(0), 30});
    builder.add_sphere({vec3(0, 0, -1000), 999.9f});
}

}  // namespace

std::vector<Recipe> uneven_scenes() {
    return {{"pot_in_stadium", pot_in_stadium},
            {"nested_corners", nested_corners},
            {"large_over_small", large_over_small}};
}

}  // namespace rayshoot::contract

#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

/// Coordinates near both ends of what a float holds.
namespace rayshoot::contract {
namespace {

/// A cube, a soup and a sphere, `size` large round `centre`.
void add_scaled(GeometryBuilder& builder, const vec3& centre, float size) {
    Random random(0x5ca1e);
    const Box box{centre - vec3(size), centre + vec3(size)};
    add_cube(builder, centre - vec3(0.5f * size), centre + vec3(0.5f * size));
    add_soup(builder, random, box, 0.5f * size, 100);
    for (int i = 0; i < 10; ++i) {
        const vec3 at = random.inside(box);
        builder.add_sphere({at, size * random.between(0.01f, 0.3f)});
    }
}

void huge_1e30(GeometryBuilder& builder) { add_scaled(builder, vec3(0), 1e30f); }
void huge_1e30_aside(GeometryBuilder& builder) { add_scaled(builder, vec3(3e30f), 1e30f); }
void large_1e15(GeometryBuilder& builder) { add_scaled(builder, vec3(0), 1e15f); }
void small_1e15(GeometryBuilder& builder) { add_scaled(builder, vec3(0), 1e-15f); }
void tiny_1e20(GeometryBuilder& builder) { add_scaled(builder, vec3(0), 1e-20f); }
void tiny_1e30(GeometryBuilder& builder) { add_scaled(builder, vec3(0), 1e-30f); }
/// Edges of a few denormal steps.
void denormal(GeometryBuilder& builder) { add_scaled(builder, vec3(0), 1e-41f); }
/// Size 100 at distance 1e8: neighbouring floats there are 8 apart.
void aside_1e8(GeometryBuilder& builder) { add_scaled(builder, vec3(1e8f, -1e8f, 1e8f), 100); }

void all_scales(GeometryBuilder& builder) {
    for (const float size : {1e-30f, 1e-20f, 1e-10f, 1.0f, 1e10f, 1e20f, 1e30f}) {
        add_cube(builder, vec3(-size), vec3(size));
        builder.add_sphere({vec3(2 * size, 0, 0), 0.5f * size});
    }
}

}  // namespace

std::vector<Recipe> extreme_scenes() {
    return {{"huge_1e30", huge_1e30},   {"huge_1e30_aside", huge_1e30_aside},
            {"large_1e15", large_1e15}, {"small_1e-15", small_1e15},
            {"tiny_1e-20", tiny_1e20},  {"tiny_1e-30", tiny_1e30},
            {"denormal", denormal},     {"aside_1e8", aside_1e8},
            {"all_scales", all_scales}};
}

}  // namespace rayshoot::contract

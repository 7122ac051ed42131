#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

#include <cmath>

/// The primitives that are not triangles, alone and together.
namespace rayshoot::contract {
namespace {

const Box unit_cube{vec3(-1), vec3(1)};

void one_sphere(GeometryBuilder& builder) { builder.add_sphere({vec3(0.1f, 0.2f, 0.3f), 1}); }

void one_frustum(GeometryBuilder& builder) {
    builder.add_frustum({vec3(0, 0, -1), 1, vec3(0.5f, 0.25f, 1), 0.25f});
}

/// A cylinder along an axis, a cone with a tip, a slanted frustum, a flat one and two without area.
void one_frustum_of_each_kind(GeometryBuilder& builder) {
    builder.add_frustum({vec3(0, 0, 0), 0.5f, vec3(0, 0, 2), 0.5f});
    builder.add_frustum({vec3(2, 0, 0), 0.5f, vec3(2, 2, 0), 0});
    builder.add_frustum({vec3(0, 3, 0), 0.1f, vec3(1, 4, 2), 0.7f});
    builder.add_frustum({vec3(3, 3, 0), 0.5f, vec3(3, 3, 1e-6f), 0.4f});
    builder.add_frustum({vec3(1), 0.5f, vec3(1), 0.5f});
    builder.add_frustum({vec3(1), 0, vec3(2), 0});
}

/// A star with `points` points in the plane through `at` spanned by u and v: concave.
void add_star(GeometryBuilder& builder, const vec3& at, const vec3& u, const vec3& v, int points,
              std::uint32_t motion = no_motion) {
    std::vector<vec3> corners;
    for (int i = 0; i < 2 * points; ++i) {
        const auto [x, y] = circle(2 * static_cast<float>(i) / static_cast<float>(points));
        const float radius = i % 2 == 0 ? 1.0f : 0.4f;
        corners.push_back(at + radius * x * u + radius * y * v);
    }
    builder.add_polygon(corners, {}, motion);
}

void one_polygon(GeometryBuilder& builder) {
    add_star(builder, vec3(0), vec3(1, 0, 0.2f), vec3(0, 1, 0.1f), 5);
}

/// A comb: many crossings per line, corners above one another.
void comb(GeometryBuilder& builder) {
    std::vector<vec3> corners{vec3(0, -1, 0)};
    for (int tooth = 0; tooth < 20; ++tooth) {
        const float x = static_cast<float>(tooth);
        corners.insert(corners.end(),
                       {vec3(x, 0, 0), vec3(x, 2, 0), vec3(x + 0.5f, 2, 0), vec3(x + 0.5f, 0, 0)});
    }
    corners.push_back(vec3(20, -1, 0));
    builder.add_polygon(corners);
}

void spheres(GeometryBuilder& builder) {
    Random random(0x5b4e4e5);
    for (int i = 0; i < 200; ++i) {
        const vec3 at = random.inside(unit_cube);
        builder.add_sphere({at, random.between(0.0f, 0.2f)});
    }
}

void add_random_frustum(GeometryBuilder& builder, Random& random) {
    const vec3 base = random.inside(unit_cube);
    const vec3 apex = base + 0.4f * random.direction();
    const float base_radius = random.between(0, 0.15f);
    builder.add_frustum({base, base_radius, apex, random.coin() ? base_radius : 0.05f});
}

void frusta(GeometryBuilder& builder) {
    Random random(0xf4057a);
    for (int i = 0; i < 120; ++i) add_random_frustum(builder, random);
}

void add_random_star(GeometryBuilder& builder, Random& random) {
    const vec3 at = random.inside(unit_cube);
    const vec3 u = 0.3f * random.direction();
    const vec3 v = 0.3f * random.direction();
    add_star(builder, at, u, v, 3 + static_cast<int>(random.below(6)));
}

void polygons(GeometryBuilder& builder) {
    Random random(0x9017);
    for (int i = 0; i < 120; ++i) add_random_star(builder, random);
}

void mixed(GeometryBuilder& builder) {
    Random random(0x313ed);
    for (int i = 0; i < 40; ++i) {
        add_soup(builder, random, unit_cube, 0.4f, 1);
        add_random_frustum(builder, random);
        builder.add_sphere({random.inside(unit_cube), 0.1f});
        add_random_star(builder, random);
    }
}

/// Equal hits of different kinds: a triangle, a polygon, and a sphere and a frustum that touch
/// them.
void mixed_ties(GeometryBuilder& builder) {
    const std::array<vec3, 4> square{vec3(-1, -1, 1), vec3(1, -1, 1), vec3(1, 1, 1),
                                     vec3(-1, 1, 1)};
    for (int i = 0; i < 3; ++i) {
        builder.add_polygon(square);
        builder.add_sphere({vec3(0), 1});
        builder.add_triangle(square[0], square[1], square[2]);
        builder.add_frustum({vec3(0, 0, -1), 1, vec3(0, 0, 1), 1});
        builder.add_triangle(square[0], square[2], square[3]);
    }
}

}  // namespace

std::vector<Recipe> curved_scenes() {
    return {{"one_sphere", one_sphere},
            {"one_frustum", one_frustum},
            {"one_frustum_of_each_kind", one_frustum_of_each_kind},
            {"one_polygon", one_polygon},
            {"comb", comb},
            {"spheres", spheres},
            {"frusta", frusta},
            {"polygons", polygons},
            {"mixed", mixed},
            {"mixed_ties", mixed_ties}};
}

}  // namespace rayshoot::contract

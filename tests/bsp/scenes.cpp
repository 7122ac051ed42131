#include "tests/bsp/scenes.h"

#include <random>

namespace rayshoot::bsp_test {
namespace {

class Random {
public:
    explicit Random(unsigned seed) : random_(seed) {}
    vec3 in_cube(float half) {
        std::uniform_real_distribution<float> place(-half, half);
        const float x = place(random_), y = place(random_), z = place(random_);
        return {x, y, z};
    }

private:
    std::mt19937 random_;
};

Geometry coincident(std::size_t count) {
    GeometryBuilder builder;
    for (std::size_t i = 0; i < count; ++i)
        builder.add_triangle(vec3(0), vec3(1, 0, 0), vec3(0, 1, 1));
    return std::move(builder).build();
}

/// Long thin triangles through the whole cube, whose boxes are nearly all of it.
Geometry needles(std::size_t count) {
    GeometryBuilder builder;
    Random random(3);
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 a = random.in_cube(1), b = random.in_cube(1);
        builder.add_triangle(a, b, b + random.in_cube(0.001f));
    }
    return std::move(builder).build();
}

/// In the planes x = 0, 1, 2, ...: where planes that divide cells want to be.
Geometry walls() {
    GeometryBuilder builder;
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j) {
            const vec3 corner(static_cast<float>(i), static_cast<float>(j), 0);
            builder.add_triangle(corner, corner + vec3(0, 1, 0), corner + vec3(0, 0, 1));
        }
    return std::move(builder).build();
}

Geometry spheres() {
    GeometryBuilder builder;
    Random random(4);
    for (int i = 0; i < 300; ++i)
        builder.add_sphere({random.in_cube(1), 0.01f + 0.001f * static_cast<float>(i % 50)});
    return std::move(builder).build();
}

}  // namespace

Geometry random_triangles(std::size_t count, float size, unsigned seed) {
    GeometryBuilder builder;
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 centre = vec3(0.5f) + random.in_cube(0.5f);
        const vec3 a = random.in_cube(size / 2), b = random.in_cube(size / 2);
        builder.add_triangle(centre, centre + a, centre + b);
    }
    return std::move(builder).build(Precision::watertight);
}

std::vector<NamedGeometry> hard_scenes() {
    std::vector<NamedGeometry> scenes;
    scenes.push_back({"none", random_triangles(0, 0, 0)});
    scenes.push_back({"one", random_triangles(1, 0.5f, 1)});
    scenes.push_back({"small ones", random_triangles(3000, 0.03f, 2)});
    scenes.push_back({"large ones", random_triangles(500, 1, 3)});
    scenes.push_back({"coincident", coincident(700)});
    scenes.push_back({"needles", needles(500)});
    scenes.push_back({"walls", walls()});
    scenes.push_back({"spheres", spheres()});
    return scenes;
}

}  // namespace rayshoot::bsp_test

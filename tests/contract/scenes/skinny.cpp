#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

/// Long thin primitives, whose boxes are mostly empty and whose t is badly conditioned.
namespace rayshoot::contract {
namespace {

/// `count` triangles of length 2 and width 2 * `ratio`, anywhere in the unit cube.
void add_slivers(GeometryBuilder& builder, std::uint64_t seed, int count, float ratio) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const vec3 a = random.inside(Box{vec3(-1), vec3(1)});
        const vec3 b = a + 2.0f * random.direction();
        const vec3 c = b + 2.0f * ratio * random.direction();
        builder.add_triangle(a, b, c);
    }
}

void slivers_1e2(GeometryBuilder& builder) { add_slivers(builder, 0x511, 200, 1e-2f); }
void slivers_1e4(GeometryBuilder& builder) { add_slivers(builder, 0x512, 200, 1e-4f); }
void slivers_1e6(GeometryBuilder& builder) { add_slivers(builder, 0x513, 100, 1e-6f); }

void fan(GeometryBuilder& builder) {
    for (int i = 0; i < 120; ++i) {
        const auto [x, y] = circle(static_cast<float>(i) / 30);
        const auto [next_x, next_y] = circle(static_cast<float>(i + 1) / 30);
        builder.add_triangle(vec3(0), vec3(x, y, 0.01f * x), vec3(next_x, next_y, 0.01f * next_x));
    }
}

/// Triangles 1 : 1e4, all parallel to a space diagonal.
void needles(GeometryBuilder& builder) {
    Random random(0x4eed1e);
    for (int i = 0; i < 200; ++i) {
        const vec3 a = random.inside(Box{vec3(-1), vec3(1)});
        builder.add_triangle(a, a + vec3(1), a + vec3(2e-4f, -2e-4f, 1e-4f) * random.unit());
    }
}

void thin_frusta(GeometryBuilder& builder) {
    Random random(0x741);
    for (int i = 0; i < 80; ++i) {
        const vec3 base = random.inside(Box{vec3(-1), vec3(1)});
        const vec3 apex = base + 2.0f * random.direction();
        builder.add_frustum({base, 1e-3f, apex, random.coin() ? 0 : 1e-3f});
    }
}

}  // namespace

std::vector<Recipe> skinny_scenes() {
    return {{"slivers_1e2", slivers_1e2}, {"slivers_1e4", slivers_1e4},
            {"slivers_1e6", slivers_1e6}, {"fan", fan},
            {"needles", needles},         {"thin_frusta", thin_frusta}};
}

}  // namespace rayshoot::contract

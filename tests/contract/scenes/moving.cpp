#include "tests/contract/scenes.h"
#include "tests/contract/scenes/shapes.h"

/// Movers: translated, turned, both, and next to things that stand still.
namespace rayshoot::contract {
namespace {

constexpr float half_root = 0.70710678f;

Motion shift(const vec3& from, const vec3& to) { return {.translation = {from, to}}; }

/// A quarter turn about the axis (1, 2, 2) / 3 and a shift.
Motion turn(const vec3& pivot, const vec3& to) {
    const float share = half_root / 3;
    return {.pivot = pivot,
            .translation = {vec3(0), to},
            .rotation = {Motion::Quaternion{0, 0, 0, 1},
                         Motion::Quaternion{share, 2 * share, 2 * share, half_root}}};
}

/// 160 degrees about z: the arc reaches far beyond both ends. (sin, cos of 80 degrees)
Motion swing(const vec3& pivot) {
    return {.pivot = pivot,
            .rotation = {Motion::Quaternion{0, 0, 0, 1},
                         Motion::Quaternion{0, 0, 0.98480775f, 0.17364818f}}};
}

/// One of each kind near `at`.
void add_each_kind(GeometryBuilder& builder, const vec3& at, std::uint32_t motion) {
    builder.add_triangle(at, at + vec3(0.8f, 0.1f, 0), at + vec3(0, 0.7f, 0.3f), motion);
    builder.add_sphere({at + vec3(0.5f), 0.3f}, motion);
    builder.add_frustum({at, 0.2f, at + vec3(0.3f, 0.9f, 0.2f), 0.1f}, motion);
    const std::array<vec3, 5> arrow{at, at + vec3(1, 0, 0), at + vec3(0.5f, 0, 0.3f),
                                    at + vec3(1, 0, 1), at + vec3(0, 0, 1)};
    builder.add_polygon(arrow, {}, motion);
}

void moving_triangle(GeometryBuilder& builder) {
    const std::uint32_t motion = builder.add_motion(shift(vec3(0), vec3(2, 1, 0)));
    builder.add_triangle(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), motion);
}

void translated(GeometryBuilder& builder) {
    for (int i = 0; i < 8; ++i) {
        const vec3 at(i % 2 * 2, i / 2 % 2 * 2, i / 4 * 2);
        add_each_kind(builder, at, builder.add_motion(shift(vec3(0), vec3(i % 3, 1, -1))));
    }
}

void turned(GeometryBuilder& builder) {
    for (int i = 0; i < 8; ++i) {
        const vec3 at(i % 2 * 2, i / 2 % 2 * 2, i / 4 * 2);
        add_each_kind(builder, at, builder.add_motion(turn(at, vec3(0))));
    }
}

/// All of them move through the same place at time 1/2, some of them as one.
void meeting(GeometryBuilder& builder) {
    const std::uint32_t right = builder.add_motion(shift(vec3(-2, 0, 0), vec3(2, 0, 0)));
    const std::uint32_t left = builder.add_motion(shift(vec3(2, 0, 0), vec3(-2, 0, 0)));
    for (int i = 0; i < 5; ++i) {
        add_each_kind(builder, vec3(0), right);
        add_each_kind(builder, vec3(0), left);
    }
}

void moving_among_still(GeometryBuilder& builder) {
    Random random(0x30f1e);
    const std::uint32_t spin = builder.add_motion(turn(vec3(0.5f), vec3(1, 0, 1)));
    const std::uint32_t fly = builder.add_motion(shift(vec3(0), vec3(5, 0, 0)));
    const std::uint32_t arc = builder.add_motion(swing(vec3(-1, 0, 0)));
    for (int i = 0; i < 6; ++i) {
        add_soup(builder, random, Box{vec3(-1), vec3(1)}, 0.5f, 12);
        add_soup(builder, random, Box{vec3(-1), vec3(1)}, 0.3f, 6, spin);
        add_each_kind(builder, random.inside(Box{vec3(-1), vec3(1)}), fly);
        add_each_kind(builder, random.inside(Box{vec3(-1), vec3(1)}), no_motion);
        add_each_kind(builder, random.inside(Box{vec3(-1), vec3(1)}), arc);
    }
}

/// A motion that does not move: the answers of the rest frame, by way of the moved ray.
void standing_movers(GeometryBuilder& builder) {
    const std::uint32_t motion = builder.add_motion(Motion{});
    add_cube(builder, vec3(-1), vec3(1), motion);
    add_cube(builder, vec3(-1), vec3(1));
    builder.add_sphere({vec3(0), 1}, motion);
}

void fast_needles(GeometryBuilder& builder) {
    Random random(0xfa57);
    const std::uint32_t motion = builder.add_motion(turn(vec3(0), vec3(1000, 0, 0)));
    for (int i = 0; i < 60; ++i) {
        const vec3 a = random.inside(Box{vec3(-1), vec3(1)});
        const vec3 b = a + 2.0f * random.direction();
        builder.add_triangle(a, b, b + vec3(2e-4f), motion);
    }
}

}  // namespace

std::vector<Recipe> moving_scenes() {
    return {{"moving_triangle", moving_triangle},
            {"translated", translated},
            {"turned", turned},
            {"meeting", meeting},
            {"moving_among_still", moving_among_still},
            {"standing_movers", standing_movers},
            {"fast_needles", fast_needles}};
}

}  // namespace rayshoot::contract

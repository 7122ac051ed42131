#pragma once

#include "accel/core/leaves.h"
#include "accel/simd/lanes.h"
#include "tests/core/cases.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

/// Leaves and rays on which vector code could differ from the scalar test, were it to differ.
namespace rayshoot::cases {

/// What a leaf is made of.
enum class Mixture { triangles, spheres, both, anything };

/// A scene of one leaf: apart, coincident, sharing corners; of one size between 2^-70 and 2^70.
struct HardLeaf {
    Geometry geometry;
    std::vector<std::uint32_t> members;

    HardLeaf(Mixture mixture, Precision precision, Random& random);
};

/// Through or past a primitive that is not a Mover: at corners and edges, tangent, from its planes,
/// along the axes and diagonals, from 3e6 sizes away, with a direction of any length and zeros of
/// either sign.
Ray hard_ray(const Geometry& geometry, std::uint32_t primitive, Random& random);

/// Rays that go nearly the same way, through spots of a primitive that is not a Mover and past it:
/// from near or far, at corners and edges, grazing, nearly along an axis.
std::vector<Ray> hard_packet(const Geometry& geometry, std::uint32_t primitive, std::size_t size,
                             Random& random);

/// The same ray whose interval ends at, just before or just behind a hit, or starts there.
Ray ending_near(const Ray& ray, float t, Random& random);

struct Answer {
    Hit hit;
    Counters counts;
};

/// test(ray, hit, count) from scratch.
template <class Test>
Answer ask(const Ray& ray, Test&& test) {
    Answer answer{nothing_yet(ray), {}};
    Tally tally{&answer.counts};
    test(ray, answer.hit, tally);
    return answer;
}

/// Hard rays at a geometry's first primitive, side by side.
template <std::size_t Width>
struct SideBySide {
    using V = simd::Floats<Width>;
    using Row = std::array<float, Width>;

    std::array<Ray, Width> rays;
    simd::Vectors<V> origin, direction, inverse;
    V direction_size;

    SideBySide(const Geometry& geometry, Random& random) {
        std::array<Row, 10> rows;
        for (std::size_t i = 0; i < Width; ++i) {
            rays[i] = hard_ray(geometry, 0, random);
            const TestRay ray(rays[i], Precision::standard);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int j = static_cast<int>(axis);
                rows[axis][i] = ray.origin[j];
                rows[axis + 3][i] = ray.direction[j];
                rows[axis + 6][i] = ray.inverse[j];
            }
            rows[9][i] = ray.direction_size;
        }
        origin = {load(rows[0]), load(rows[1]), load(rows[2])};
        direction = {load(rows[3]), load(rows[4]), load(rows[5])};
        inverse = {load(rows[6]), load(rows[7]), load(rows[8])};
        direction_size = load(rows[9]);
    }
    static V load(const Row& row) { return simd::hn::LoadU(simd::floats<Width>, row.data()); }
    static Row store(V v) {
        Row row;
        simd::hn::StoreU(v, simd::floats<Width>, row.data());
        return row;
    }
};

inline bool same_bits(const Hit& a, const Hit& b) { return std::memcmp(&a, &b, sizeof(Hit)) == 0; }

}  // namespace rayshoot::cases

#pragma once

#include "accel/core/leaves.h"
#include "tests/core/cases.h"

#include <gtest/gtest.h>

#include <cstring>

/// Leaves and rays on which vector code could differ from the scalar test, were it to differ.
namespace rayshoot::cases {

/// What a leaf is made of.
enum class Mixture { triangles, spheres, both, anything };

/// A scene of one leaf: apart, coincident, sharing corners; of one size between 2^-50 and 2^50.
struct HardLeaf {
    Geometry geometry;
    std::vector<std::uint32_t> members;

    HardLeaf(Mixture mixture, Precision precision, Random& random);
};

/// Through or past a primitive that is not a Mover: at corners and edges, tangent, from its planes,
/// along the axes, from 3e6 sizes away, with a direction of any length and zeros of either sign.
Ray hard_ray(const Geometry& geometry, std::uint32_t primitive, Random& random);

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

inline bool same_bits(const Hit& a, const Hit& b) { return std::memcmp(&a, &b, sizeof(Hit)) == 0; }

}  // namespace rayshoot::cases

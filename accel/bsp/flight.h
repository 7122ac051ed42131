#pragma once

#include "accel/bsp/node.h"
#include "accel/bsp/sketch.h"

/// A ray on its way through a BSP tree.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A cell that a ray has still to visit, and the part of the ray inside it.
struct alignas(16) BspHalt {
    std::uint32_t node;
    float entry, exit;
};

/// Which children of a node the ray meets: the cases of Sung & Shirley (1992), without the singular
/// ones that Havran et al. (1997) sort out. Where the plane is met at either end of the ray's part
/// in the cell, both are: a tie may lie in the other one. NaN, of a ray inside the plane, is past
/// neither end: both again.
struct BspCrossing {
    float t;  ///< where the plane is met
    bool near, far;

    BspCrossing(float at, float entry, float exit)
        : t(at), near(!(at < entry)), far(!(at > exit)) {}
    /// Of the part in the near child, or in the far one; NaN bounds nothing.
    float near_exit(float exit) const { return t < exit ? t : exit; }
    float far_entry(float entry) const { return t > entry ? t : entry; }
};

/// Its size is an odd multiple of a cache line, so that the same parts of many flights do not meet
/// in the same places of the cache.
struct alignas(64) BspFlight {
    static constexpr std::uint32_t nowhere = 1;  ///< a node that is an empty leaf

    TestRay ray{Ray{}, Precision::standard};
    std::array<float, 4> origin, inverse;    ///< the last of each is never used
    std::array<std::uint32_t, 4> near_side;  ///< 1: the near child is the one above the plane
    Hit hit;
    std::uint32_t node = nowhere;                 ///< of the cell that is visited
    float entry = 0, exit = 0;                    ///< the ray's part in it
    std::uint32_t next_block = 0, end_block = 0;  ///< of a leaf that is tested block by block
    std::uint32_t number = 0;                     ///< of the ray in its batch
    std::uint32_t top = 0;                        ///< place of the last halt
    /// Below the first one lies one that is never reached.
    std::array<BspHalt, deepest_bsp + 2> halts{BspHalt{nowhere, infinity, infinity}};

    void start(const Ray& from, std::size_t n, Precision precision, const Box& space) {
        std::construct_at(&ray, from, precision);  // in place: a copy would wait for its stores
        for (std::size_t axis = 0; axis < 3; ++axis) {
            origin[axis] = ray.origin[static_cast<int>(axis)];
            inverse[axis] = ray.inverse[static_cast<int>(axis)];
            near_side[axis] = ray.descending[axis];
        }
        hit = nothing_yet(from);
        number = static_cast<std::uint32_t>(n);
        const Interval inside = clip(ray, space, {from.t_min, hit.t});
        entry = inside.entry;
        exit = inside.exit;
        node = inside.empty() ? nowhere : 0;
        top = 0;
    }
    /// Goes on to the nearest cell that is left; false where there is none, or none before the hit.
    /// Closed: what begins exactly at the hit may hold a tie with a smaller number.
    bool pop() {
        const BspHalt& halt = halts[top];
        if (halt.entry > hit.t) return false;
        node = halt.node;
        entry = halt.entry;
        exit = halt.exit < hit.t ? halt.exit : hit.t;
        --top;
        return true;
    }
    template <Query Q>
    bool over() const {
        return Q == Query::occluded && hit.primitive != no_primitive;
    }
};
static_assert(sizeof(BspFlight) / 64 % 2 == 1);

}  // namespace rayshoot::inline RAYSHOOT_ISA

#pragma once

#include "accel/bsp/flight.h"
#include "accel/simd/lanes.h"

/// Rays on their way through a BSP tree side by side, each at a node of its own.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Some lanes of a fleet, a bit each.
using FleetLanes = std::uint32_t;

struct alignas(64) Fleet {
    static constexpr std::size_t lanes = simd::widest;
    static constexpr FleetLanes all = static_cast<FleetLanes>((std::uint64_t{1} << lanes) - 1);
    using Row = std::array<float, lanes>;
    using WordRow = std::array<std::uint32_t, lanes>;
    using V = simd::Floats<lanes>;
    using W = simd::Words<lanes>;
    static constexpr auto tag = simd::floats<lanes>;
    static constexpr auto word = simd::words<lanes>;

    /// What a lane's leaves need.
    struct Passenger {
        TestRay ray{Ray{}, Precision::standard};
        Hit hit;
        std::uint32_t number = 0;  ///< of the ray in its batch
        std::uint32_t next_block = 0, end_block = 0;
    };
    /// Below the first one lies one that is never reached.
    struct Halts {
        std::array<BspHalt, deepest_bsp + 2> at{BspHalt{BspFlight::nowhere, infinity, infinity}};
    };

    std::array<Row, 3> origin{}, inverse{};
    std::array<WordRow, 3> near_side{};  ///< 1: the near child is the one above the plane
    WordRow node;                        ///< of the cell that a lane is in
    Row entry{}, exit{};                 ///< its ray's part of it
    WordRow top{};                       ///< place of its last halt
    FleetLanes idle = all;               ///< lanes without a ray
    FleetLanes waiting = 0;              ///< lanes whose leaf is still to be tested
    FleetLanes to_triangles = 0, to_spheres = 0,
               to_mixed = 0;  ///< of these, by what the leaf holds
    std::array<Passenger, lanes> passengers;
    std::array<Halts, lanes> halts;

    Fleet() { node.fill(BspFlight::nowhere); }

    void start(std::size_t lane, const Ray& from, std::size_t n, Precision precision,
               const Box& space);
    /// Goes on to the nearest cell that is left; false where there is none before the hit.
    bool pop(std::size_t lane);
    /// One step of every lane that is not at a leaf. Returns those that are at one now.
    FleetLanes step(const BspNode* nodes);

private:
    V of_axis(const std::array<Row, 3>& rows, W axis) const;
    W of_axis(const std::array<WordRow, 3>& rows, W axis) const;
    void push(W node, V from, V to, W places);
};

inline void Fleet::start(std::size_t lane, const Ray& from, std::size_t n, Precision precision,
                         const Box& space) {
    Passenger& passenger = passengers[lane];
    const TestRay& ray = *std::construct_at(&passenger.ray, from, precision);
    passenger.hit = nothing_yet(from);
    passenger.number = static_cast<std::uint32_t>(n);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        origin[axis][lane] = ray.origin[static_cast<int>(axis)];
        inverse[axis][lane] = ray.inverse[static_cast<int>(axis)];
        near_side[axis][lane] = ray.descending[axis];
    }
    const Interval inside = clip(ray, space, {from.t_min, passenger.hit.t});
    entry[lane] = inside.entry;
    exit[lane] = inside.exit;
    node[lane] = inside.empty() ? BspFlight::nowhere : 0;
    top[lane] = 0;
    idle &= ~(1u << lane);
}

inline bool Fleet::pop(std::size_t lane) {
    const BspHalt halt = halts[lane].at[top[lane]];
    const float nearest = passengers[lane].hit.t;
    node[lane] = halt.node;
    entry[lane] = halt.entry;
    exit[lane] = halt.exit < nearest ? halt.exit : nearest;
    const bool goes_on = !(halt.entry > nearest);
    top[lane] -= goes_on;  // the lowest one stays
    return goes_on;
}

inline Fleet::V Fleet::of_axis(const std::array<Row, 3>& rows, W axis) const {
    using namespace simd;
    const auto is = [&](std::uint32_t i) {
        return hn::RebindMask(tag, hn::Eq(axis, hn::Set(word, i)));
    };
    return hn::IfThenElse(
        is(2), hn::Load(tag, rows[2].data()),
        hn::IfThenElse(is(1), hn::Load(tag, rows[1].data()), hn::Load(tag, rows[0].data())));
}

inline Fleet::W Fleet::of_axis(const std::array<WordRow, 3>& rows, W axis) const {
    using namespace simd;
    const auto is = [&](std::uint32_t i) { return hn::Eq(axis, hn::Set(word, i)); };
    return hn::IfThenElse(
        is(2), hn::Load(word, rows[2].data()),
        hn::IfThenElse(is(1), hn::Load(word, rows[1].data()), hn::Load(word, rows[0].data())));
}

/// Above the last halt of each lane; whether it counts is the caller's to say. Without a branch:
/// which lanes push cannot be foretold.
inline void Fleet::push(W far, V from, V to, W places) {
    using namespace simd;
    static_assert(sizeof(BspHalt) == 16);
    constexpr hn::Repartition<std::uint64_t, decltype(tag)> pairs;
    const V place = hn::BitCast(tag, far);
    const auto low = hn::BitCast(pairs, hn::InterleaveLower(tag, place, from)),
               high = hn::BitCast(pairs, hn::InterleaveUpper(tag, place, from)),
               low_end = hn::BitCast(pairs, hn::InterleaveLower(tag, to, to)),
               high_end = hn::BitCast(pairs, hn::InterleaveUpper(tag, to, to));
    alignas(64) std::array<std::array<BspHalt, lanes / 4>, 4> rows;
    const auto store = [&](auto row, std::size_t i) {
        hn::Store(hn::BitCast(tag, row), tag, reinterpret_cast<float*>(&rows[i]));
    };
    store(hn::InterleaveLower(pairs, low, low_end), 0);
    store(hn::InterleaveUpper(pairs, low, low_end), 1);
    store(hn::InterleaveLower(pairs, high, high_end), 2);
    store(hn::InterleaveUpper(pairs, high, high_end), 3);
    alignas(64) WordRow next;
    hn::Store(places, word, next.data());
    for (std::size_t lane = 0; lane < lanes; ++lane)
        halts[lane].at[next[lane]] = rows[lane % 4][lane / 4];
}

inline FleetLanes Fleet::step(const BspNode* nodes) {
    using namespace simd;
    constexpr hn::RebindToSigned<decltype(word)> index;
    static_assert(sizeof(BspNode) == 2 * sizeof(float));
    const W here = hn::Load(word, node.data());
    const auto place = hn::BitCast(index, hn::Add(here, here));
    const V plane = hn::GatherIndex(tag, reinterpret_cast<const float*>(nodes), place);
    const W bits_of =
        hn::GatherIndex(word, reinterpret_cast<const std::uint32_t*>(nodes) + 1, place);
    const auto interior = hn::Gt(hn::BitCast(index, bits_of), hn::Set(index, -1));
    const W axis = hn::And(bits_of, hn::Set(word, 3));
    const V t = hn::Mul(hn::Sub(plane, of_axis(origin, axis)), of_axis(inverse, axis));
    const V from = hn::Load(tag, entry.data()), to = hn::Load(tag, exit.data());
    // BspCrossing in every lane; but an empty leaf is visited only where there is nothing else.
    const auto moves = hn::RebindMask(tag, interior);
    const auto near = hn::AndNot(hn::Lt(t, from), moves), far = hn::AndNot(hn::Gt(t, to), moves);
    const W side = of_axis(near_side, axis), one = hn::Set(word, 1);
    const auto holds = [&](W of_side) {
        const W empty = hn::Shr(hn::ShiftRight<2>(bits_of), of_side);
        return hn::RebindMask(tag, hn::Eq(hn::And(empty, one), hn::Zero(word)));
    };
    const auto to_near = hn::And(near, holds(side)),
               to_far = hn::And(far, holds(hn::Xor(side, one)));
    const W first = hn::Add(hn::ShiftLeft<1>(hn::ShiftRight<4>(bits_of)), side);
    const W other = hn::Xor(first, one);
    const W top_place = hn::Load(word, top.data()), next_place = hn::Add(top_place, one);
    const V far_entry = larger(t, from);
    push(other, far_entry, to, next_place);
    const auto pushes = hn::RebindMask(word, hn::And(to_near, to_far));
    hn::Store(hn::IfThenElse(pushes, next_place, top_place), word, top.data());
    const auto goes_near = hn::Or(to_near, hn::AndNot(to_far, near));
    const W child = hn::IfThenElse(hn::RebindMask(word, goes_near), first, other);
    hn::Store(hn::IfThenElse(hn::RebindMask(word, moves), child, here), word, node.data());
    hn::Store(hn::IfThenElse(goes_near, smaller(t, to), to), tag, exit.data());
    hn::Store(hn::IfThenElse(hn::AndNot(goes_near, near), far_entry, from), tag, entry.data());
    return all & ~bits(tag, moves);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

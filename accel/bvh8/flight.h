#pragma once

#include "accel/bvh8/node.h"
#include "accel/core/leaves.h"
#include "accel/simd/lanes.h"

/// A ray on its way through the tree.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Some of the children of a node.
template <std::size_t Width>
using Places = decltype(simd::hn::Le(simd::Floats<Width>{}, simd::Floats<Width>{}));

/// The place of the least of some values, by its bits with the place instead of the last two or
/// three; the last place where there is none. Negative values are not told apart rightly: it is for
/// an order alone.
template <class V, class Mask>
inline std::uint32_t nearest_of(Mask met, V entries) {
    using namespace simd;
    constexpr hn::RebindToSigned<hn::DFromV<V>> key;
    constexpr std::int32_t last = hn::MaxLanes(key) - 1;
    const auto keys = hn::OrAnd(hn::Iota(key, 0), hn::Set(key, ~last), hn::BitCast(key, entries));
    const auto open = hn::IfThenElse(hn::RebindMask(key, met), keys, hn::Set(key, 0x7fffffff));
    return static_cast<std::uint32_t>(hn::GetLane(hn::MinOfLanes(key, open)) & last);
}

/// Children that are still to be visited, and where the ray enters them.
class Stack {
public:
    static constexpr std::size_t deepest = 64;  ///< levels of the tree

    void clear() { top_ = lowest; }
    WideChild top() const { return WideChild::from(children_[top_ - 1]); }
    /// Writes whole vectors, of which the first `count` lanes count.
    template <class Words, class V>
    void push(std::size_t count, Words children, V entries) {
        simd::hn::StoreU(children, simd::hn::DFromV<Words>(), &children_[top_]);
        simd::hn::StoreU(entries, simd::hn::DFromV<V>(), &entries_[top_]);
        top_ += count;
    }
    void push(WideChild child, float entry) {
        children_[top_] = child.bits();
        entries_[top_++] = entry;
    }
    void drop() { --top_; }
    /// Drops what begins behind `nearest` among the last eight, and returns the last one of the
    /// others. Closed: what begins exactly at the hit may hold a tie with a smaller number.
    WideChild cull(float nearest) {
        using namespace simd;
        const std::size_t first = top_ - 8;
        const auto children = hn::LoadU(words<8>, &children_[first]);
        const auto entries = hn::LoadU(floats<8>, &entries_[first]);
        const std::uint32_t kept = bits(floats<8>, hn::Le(entries, hn::Set(floats<8>, nearest)));
        // Read before it is written: a value that has just been stored would have to be waited for.
        const auto last = static_cast<std::size_t>(std::bit_width(kept));
        const WideChild next = WideChild::from(children_[first + last - 1]);
        top_ = first;
        push(static_cast<std::size_t>(std::popcount(kept)), compress(children, kept),
             compress(entries, kept));
        return next;
    }

private:
    /// Below the first entry lie as many that are no children, so that nothing asks whether one is
    /// left.
    static constexpr std::size_t lowest = 9,
                                 size = lowest + (most_children - 1) * deepest + most_children;
    static constexpr auto nobody = [] {
        std::array<std::uint32_t, size> children{};
        children.fill(0xffffffff);
        return children;
    }();
    static constexpr auto nowhere = [] {
        std::array<float, size> entries{};
        entries.fill(-infinity);
        return entries;
    }();

    std::size_t top_ = lowest;
    std::array<std::uint32_t, size> children_ = nobody;
    std::array<float, size> entries_ = nowhere;
};

template <class Node>
struct alignas(64) Flight {
    /// What a step finds out before another decides where to go.
    struct Crossing {
        alignas(32) std::array<float, Node::width> entries;  ///< into each child
        const Node* node;
        std::uint32_t places;   ///< of the children that are met, a bit each
        std::uint32_t nearest;  ///< place of the one that is met first, if any
    } crossing;
    vec3 origin;
    vec3 towards;                            ///< - 1 / direction
    std::array<std::uint32_t, 3> near, far;  ///< first floats of the planes that the ray meets
    TestRay ray{Ray{}, Precision::standard};
    Hit hit;
    WideChild next = WideChild::none();  ///< what is visited next
    std::uint32_t number = 0;            ///< of the ray in its batch
    Stack stack;

    void start(const Ray& from, std::size_t n, Precision precision) {
        std::construct_at(&ray, from, precision);  // in place: a copy would wait for its stores
        origin = ray.origin;
        towards = -ray.inverse;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            near[axis] = static_cast<std::uint32_t>(ray.near[axis] * Node::width);
            far[axis] = static_cast<std::uint32_t>(ray.far[axis] * Node::width);
        }
        hit = nothing_yet(from);
        next = WideChild::node(0);
        number = static_cast<std::uint32_t>(n);
        stack.clear();
    }
    void pop() {
        next = stack.cull(hit.t);
        stack.drop();
    }
    /// For a ray that is over once it hits anything: until then nothing is out of its reach.
    void pop_any() {
        next = stack.top();
        stack.drop();
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

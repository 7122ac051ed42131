#pragma once

#include "accel/simd/transpose.h"
#include "accel/simd/triangle_block.h"

#include <tuple>

/// Rays that go nearly the same way, side by side, a register to a group; and the beam around them
/// all.
namespace rayshoot::inline RAYSHOOT_ISA {

/// What bounds all rays of a packet in the slab form of box.h. Rounding is monotone, so whatever
/// box the beam misses, every ray of it misses, exactly.
struct Beam {
    vec3 origin_lo{infinity}, origin_hi{-infinity};
    vec3 inverse_lo{infinity}, inverse_hi{-infinity};
    std::array<std::size_t, 3> near, far;  ///< as in SlabRay: the same for all rays
    float t_min = infinity;                ///< least of all
    float nearest = -infinity;             ///< farthest of the nearest hits so far

    /// The least entry and the largest exit of any ray for each box.
    template <std::size_t Width>
    auto clip(const Boxes<Width>& boxes) const {
        using namespace simd;
        constexpr auto tag = floats<Width>;
        auto entry = hn::Set(tag, t_min), exit = hn::Set(tag, nearest);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int i = static_cast<int>(axis);
            const bool descending = near[axis] > far[axis];
            const auto lo = hn::Set(tag, inverse_lo[i]), hi = hn::Set(tag, inverse_hi[i]);
            // The origin from which a plane is met first, and the one from which it is met last.
            const auto first = hn::Set(tag, descending ? origin_lo[i] : origin_hi[i]);
            const auto last = hn::Set(tag, descending ? origin_hi[i] : origin_lo[i]);
            const auto to_near = hn::Sub(hn::Load(tag, boxes.planes[near[axis]].data()), first);
            const auto to_far = hn::Sub(hn::Load(tag, boxes.planes[far[axis]].data()), last);
            entry = larger(least(hn::Mul(to_near, lo), hn::Mul(to_near, hi)), entry);
            exit = smaller(most(hn::Mul(to_far, lo), hn::Mul(to_far, hi)), exit);
        }
        return std::pair(entry, exit);
    }

private:
    /// NaN where one of the two is: it bounds nothing.
    template <class V>
    static V least(V a, V b) {
        using namespace simd;
        return hn::IfThenElse(hn::Lt(a, b), a, hn::IfThenElse(hn::Ge(a, b), b, hn::Add(a, b)));
    }
    template <class V>
    static V most(V a, V b) {
        using namespace simd;
        return hn::IfThenElse(hn::Gt(a, b), a, hn::IfThenElse(hn::Le(a, b), b, hn::Add(a, b)));
    }
};

class Packet {
public:
    static constexpr std::size_t group = simd::widest, most = 64;
    using V = simd::Floats<group>;
    using Mask = decltype(simd::hn::Lt(V{}, V{}));

    /// Some of the groups, one after the other.
    struct Section {
        std::size_t first, count;
        std::size_t end() const { return first + count; }
        std::size_t first_ray() const { return first * group; }
        std::size_t end_ray() const { return end() * group; }
    };

    /// Whole groups, 64 rays at most. False, and no packet, where they do not go nearly the same
    /// way.
    bool load(std::span<const Ray> rays);

    std::size_t size() const { return size_; }
    Section all() const { return {0, size_ / group}; }
    Hit hit(std::size_t ray) const { return {t_[ray], primitive_[ray], u_[ray], v_[ray]}; }

    Beam beam(Section section) const;
    /// The farthest of a section's nearest hits so far.
    float reach(Section section) const;
    /// The rays of a group that meet one of several boxes before their nearest hit.
    template <std::size_t Width>
    Mask meets(std::size_t group, const Boxes<Width>& boxes, std::size_t box) const;
    /// Tests the rays of a group against every triangle of a block.
    template <Query Q, Counter C>
    void test(std::size_t group, Mask active, const TriangleBlock& block, float padding, C& count);

private:
    using Rows = std::array<float, most>;
    struct alignas(64) Places {
        Rows x, y, z;
        simd::Vectors<V> from(std::size_t first) const {
            using namespace simd;
            constexpr auto tag = floats<group>;
            return {hn::Load(tag, &x[first]), hn::Load(tag, &y[first]), hn::Load(tag, &z[first])};
        }
    };
    /// The least and the largest coordinates.
    static std::pair<vec3, vec3> ends(const Places& places, Section section);
    static V row(const Rows& rows, std::size_t first) {
        return simd::hn::Load(simd::floats<group>, &rows[first]);
    }
    static void put(V value, Rows& rows, std::size_t first) {
        simd::hn::Store(value, simd::floats<group>, &rows[first]);
    }
    template <Counter C>
    void offer(std::size_t first, Mask inside, const WideSums<V>& sums, std::uint32_t primitive,
               const Triangle& triangle, float padding, C& count);
    template <Counter C>
    void test_alone(std::size_t ray, const Triangle& triangle, std::uint32_t primitive,
                    float padding, C& count);

    Places origin_, direction_, inverse_;
    alignas(64) Rows direction_size_, t_min_, t_, u_, v_;
    alignas(64) std::array<std::uint32_t, most> primitive_;
    std::size_t size_ = 0;
    std::array<std::size_t, 3> near_, far_;  ///< the same for all rays
};

inline bool Packet::load(std::span<const Ray> rays) {
    using namespace simd;
    constexpr auto tag = floats<group>;
    constexpr float most_spread = 0.25f;  // of directions, in units of the longest component
    size_ = rays.size();
    // Most rays that do not belong together are found out by three of them.
    for (const Ray& ray : {rays[size_ / 2], rays.back()})
        for (int axis = 0; axis < 3; ++axis)
            if (!(ray.direction[axis] * rays.front().direction[axis] > 0)) return false;
    static_assert(offsetof(Ray, t_min) == 12 && offsetof(Ray, direction) == 16 &&
                  offsetof(Ray, t_max) == 28);
    for (std::size_t i = 0; i < size_; i += 8)
        transpose_8x8(reinterpret_cast<const std::byte*>(&rays[i]), sizeof(Ray),
                      {&origin_.x[i], &origin_.y[i], &origin_.z[i], &t_min_[i], &direction_.x[i],
                       &direction_.y[i], &direction_.z[i], &t_[i]});
    const auto [lo, hi] = ends(direction_, all());
    const float longest = std::max({std::abs(lo.x), std::abs(lo.y), std::abs(lo.z), std::abs(hi.x),
                                    std::abs(hi.y), std::abs(hi.z)});
    for (int axis = 0; axis < 3; ++axis) {
        // Zeros would need care with their signs, and nearly the same way is enough.
        const bool one_sign = lo[axis] > 0 || hi[axis] < 0;
        if (!one_sign || !(hi[axis] - lo[axis] < most_spread * longest)) return false;
    }
    const SlabRay first(rays.front().origin, rays.front().direction);
    near_ = first.near;
    far_ = first.far;
    for (std::size_t i = 0; i < size_; i += group) {
        const auto direction = direction_.from(i);
        const V one = hn::Set(tag, 1.0f);
        put(hn::Div(one, direction.x), inverse_.x, i);
        put(hn::Div(one, direction.y), inverse_.y, i);
        put(hn::Div(one, direction.z), inverse_.z, i);
        put(taxicab(direction), direction_size_, i);
        put(below(row(t_, i)), t_, i);
        put(hn::Zero(tag), u_, i);
        put(hn::Zero(tag), v_, i);
        hn::Store(hn::Set(words<group>, no_primitive), words<group>, &primitive_[i]);
    }
    return true;
}

inline std::pair<vec3, vec3> Packet::ends(const Places& places, Section section) {
    using namespace simd;
    constexpr auto tag = floats<group>;
    auto lo = places.from(section.first * group), hi = lo;
    for (std::size_t i = section.first + 1; i < section.end(); ++i) {
        const auto next = places.from(i * group);
        lo = {hn::Min(lo.x, next.x), hn::Min(lo.y, next.y), hn::Min(lo.z, next.z)};
        hi = {hn::Max(hi.x, next.x), hn::Max(hi.y, next.y), hn::Max(hi.z, next.z)};
    }
    const auto least = [&](V v) { return hn::GetLane(hn::MinOfLanes(tag, v)); };
    const auto most_of = [&](V v) { return hn::GetLane(hn::MaxOfLanes(tag, v)); };
    return {{least(lo.x), least(lo.y), least(lo.z)}, {most_of(hi.x), most_of(hi.y), most_of(hi.z)}};
}

inline Beam Packet::beam(Section section) const {
    using namespace simd;
    Beam beam;
    std::tie(beam.origin_lo, beam.origin_hi) = ends(origin_, section);
    std::tie(beam.inverse_lo, beam.inverse_hi) = ends(inverse_, section);
    beam.near = near_;
    beam.far = far_;
    V earliest = row(t_min_, section.first * group);
    for (std::size_t i = section.first + 1; i < section.end(); ++i)
        earliest = hn::Min(earliest, row(t_min_, i * group));
    beam.t_min = hn::GetLane(hn::MinOfLanes(floats<group>, earliest));
    beam.nearest = reach(section);
    return beam;
}

inline float Packet::reach(Section section) const {
    V farthest = row(t_, section.first * group);
    for (std::size_t i = section.first + 1; i < section.end(); ++i)
        farthest = simd::hn::Max(farthest, row(t_, i * group));
    return simd::hn::GetLane(simd::hn::MaxOfLanes(simd::floats<group>, farthest));
}

template <std::size_t Width>
inline Packet::Mask Packet::meets(std::size_t g, const Boxes<Width>& boxes, std::size_t box) const {
    using namespace simd;
    const std::size_t first = g * group;
    const auto origin = origin_.from(first), inverse = inverse_.from(first);
    V entry = row(t_min_, first), exit = row(t_, first);
    const auto narrow = [&](std::size_t axis, V from, V scale) {
        const auto plane = [&](std::size_t i) {
            return hn::Set(floats<group>, boxes.planes[i][box]);
        };
        entry = larger(hn::Mul(hn::Sub(plane(near_[axis]), from), scale), entry);
        exit = smaller(hn::Mul(hn::Sub(plane(far_[axis]), from), scale), exit);
    };
    narrow(0, origin.x, inverse.x);
    narrow(1, origin.y, inverse.y);
    narrow(2, origin.z, inverse.z);
    return hn::Le(entry, exit);
}

template <Query Q, Counter C>
inline void Packet::test(std::size_t g, Mask active, const TriangleBlock& block, float padding,
                         C& count) {
    using namespace simd;
    constexpr auto tag = floats<group>;
    const std::size_t first = g * group;
    const auto origin = origin_.from(first), direction = direction_.from(first);
    for (std::size_t lane = 0; lane < TriangleBlock::width; ++lane) {
        const std::uint32_t primitive = block.primitive[lane];
        if (primitive == no_primitive) return;
        if constexpr (C::counts) count(Event::object_test, hn::CountTrue(tag, active));
        const Triangle triangle = block.triangle(lane);
        const vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
        const WideSums<V> sums(everywhere<group>(triangle.a), everywhere<group>(e1),
                               everywhere<group>(e2), origin, direction);
        const auto trusted = sums.trusted(
            hn::Mul(hn::Set(tag, taxicab(e1) * taxicab(e2)), row(direction_size_, first)));
        const auto inside = hn::And(active, hn::And(trusted, sums.inside()));
        const std::uint32_t untrusted = bits(tag, hn::AndNot(trusted, active));
        if (hn::AllFalse(tag, inside) && untrusted == 0) continue;
        offer(first, inside, sums, primitive, triangle, padding, count);
        for (std::uint32_t rest = untrusted; rest != 0; rest &= rest - 1)
            test_alone(first + static_cast<std::size_t>(std::countr_zero(rest)), triangle,
                       primitive, padding, count);
        if constexpr (Q == Query::occluded) {  // one hit is enough: met by nothing from now on
            const auto lit = hn::Eq(hn::Load(words<group>, &primitive_[first]),
                                    hn::Set(words<group>, no_primitive));
            put(hn::IfThenElse(hn::RebindMask(tag, lit), row(t_, first), hn::Set(tag, -infinity)),
                t_, first);
        }
    }
}

/// rayshoot::offer of leaves.h in every lane.
template <Counter C>
inline void Packet::offer(std::size_t first, Mask inside, const WideSums<V>& sums,
                          std::uint32_t primitive, const Triangle& triangle, float padding,
                          C& count) {
    using namespace simd;
    constexpr auto tag = floats<group>;
    constexpr auto word = words<group>;
    const Box box = bounds(triangle);
    const auto lo = everywhere<group>(box.lo), hi = everywhere<group>(box.hi);
    const auto [t, met] = clamped<V>({hn::Div(sums.t, sums.det), inside},
                                     everywhere<group>(triangle.a),
                                     {lo.x, lo.y, lo.z, hi.x, hi.y, hi.z}, origin_.from(first),
                                     inverse_.from(first), padding);
    if constexpr (C::counts) count(Event::object_hit, hn::CountTrue(tag, met));
    const V best = row(t_, first);
    const auto number = hn::Set(word, primitive), holder = hn::Load(word, &primitive_[first]);
    const auto earlier = hn::RebindMask(tag, hn::Lt(number, holder));
    const auto better = hn::And(hn::And(met, hn::Gt(t, row(t_min_, first))),
                                hn::Or(hn::Lt(t, best), hn::And(hn::Eq(t, best), earlier)));
    put(hn::IfThenElse(better, t, best), t_, first);
    put(hn::IfThenElse(better, hn::Div(sums.u, sums.det), row(u_, first)), u_, first);
    put(hn::IfThenElse(better, hn::Div(sums.v, sums.det), row(v_, first)), v_, first);
    hn::Store(hn::IfThenElse(hn::RebindMask(word, better), number, holder), word,
              &primitive_[first]);
}

template <Counter C>
inline void Packet::test_alone(std::size_t i, const Triangle& triangle, std::uint32_t primitive,
                               float padding, C& count) {
    const TestRay ray({{origin_.x[i], origin_.y[i], origin_.z[i]},
                       t_min_[i],
                       {direction_.x[i], direction_.y[i], direction_.z[i]}},
                      Precision::standard);
    Hit best = hit(i);
    bool met = false;
    intersect_in_double(triangle, ray, [&](float t, float u, float v) {
        met |= rayshoot::offer(t, u, v, primitive, padded(bounds(triangle), padding), ray,
                                best);
    });
    if constexpr (C::counts) count(Event::object_hit, met);
    t_[i] = best.t;
    u_[i] = best.u;
    v_[i] = best.v;
    primitive_[i] = best.primitive;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

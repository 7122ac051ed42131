#pragma once

#include "accel/simd/sphere_block.h"
#include "accel/simd/transpose.h"
#include "accel/simd/watertight_block.h"

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
    template <class Bounds>
    auto clip(const Bounds& boxes) const {
        using namespace simd;
        constexpr auto tag = floats<Bounds::width>;
        auto entry = hn::Set(tag, t_min), exit = limit(boxes, nearest);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int i = static_cast<int>(axis);
            const bool descending = near[axis] > far[axis];
            const auto lo = hn::Set(tag, inverse_lo[i]), hi = hn::Set(tag, inverse_hi[i]);
            // The origin from which a plane is met first, and the one from which it is met last.
            const auto first = hn::Set(tag, descending ? origin_lo[i] : origin_hi[i]);
            const auto last = hn::Set(tag, descending ? origin_hi[i] : origin_lo[i]);
            const auto to_near = hn::Sub(row(boxes, axis, near[axis] * Bounds::width), first);
            const auto to_far = hn::Sub(row(boxes, axis, far[axis] * Bounds::width), last);
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

    /// Whole groups, 64 rays at most, which stay where they are while the packet is in use. False,
    /// and no packet, where they do not go nearly the same way or, in Precision::watertight, have
    /// not all the same dominant axis.
    bool load(std::span<const Ray> rays, Precision precision);

    Section all() const { return {0, rays_.size() / group}; }
    Hit hit(std::size_t ray) const { return {t_[ray], primitive_[ray], u_[ray], v_[ray]}; }

    Beam beam(Section section) const;
    /// The farthest of a section's nearest hits so far.
    float reach(Section section) const;
    /// The rays of a group that meet one of several boxes before their nearest hit.
    template <class Bounds>
    Mask meets(std::size_t group, const Bounds& boxes, std::size_t box) const;
    /// Tests the rays of a group against every triangle of a block; P: the packet's precision.
    template <Query Q, Precision P, Counter C>
    void test(std::size_t group, Mask active, const TriangleBlock& block, float padding, C& count);
    /// Or against every sphere.
    template <Query Q, Counter C>
    void test(std::size_t group, Mask active, const SphereBlock& block, float padding, C& count);
    /// Calls test(ray, hit) for one ray of a group after the other.
    template <Query Q, class Test>
    void test_each(std::size_t group, Mask active, Test&& test);

private:
    using Rows = std::array<float, most>;
    struct alignas(64) Places {
        std::array<Rows, 3> rows;
        simd::Vectors<V> from(std::size_t first) const {
            return {row(rows[0], first), row(rows[1], first), row(rows[2], first)};
        }
    };
    /// What a group's rays and a triangle or a sphere have in common.
    struct Lines {
        simd::Vectors<V> origin, direction, inverse;
        V direction_size;
    };
    Lines lines(std::size_t first) const {
        return {origin_.from(first), direction_.from(first), inverse_.from(first),
                row(direction_size_, first)};
    }
    /// The least and the largest coordinates.
    static std::pair<vec3, vec3> ends(const Places& places, Section section);
    static V row(const Rows& rows, std::size_t first) {
        return simd::hn::Load(simd::floats<group>, &rows[first]);
    }
    static void put(V value, Rows& rows, std::size_t first) {
        simd::hn::Store(value, simd::floats<group>, &rows[first]);
    }
    bool share_an_axis(const vec3& lo, const vec3& hi);

    template <Query Q>
    void accept(std::size_t first, const WideHit<V>& at, V u, V v, std::uint32_t primitive);
    template <class Test>
    void test_alone(std::size_t first, std::uint32_t rays, Test&& test);
    /// For Query::occluded one hit is enough: such rays meet nothing from now on.
    template <Query Q>
    void retire(std::size_t first);

    Places origin_, direction_, inverse_;
    alignas(64) Rows direction_size_, t_min_, t_, u_, v_;
    alignas(64) Rows along_x_, along_y_;  ///< as in Shear
    alignas(64) std::array<std::uint32_t, most> primitive_;
    std::span<const Ray> rays_;
    Precision precision_ = Precision::standard;
    // The same for all rays:
    std::array<std::size_t, 3> near_, far_;
    std::array<std::size_t, 3> axes_;  ///< of the shear; the last one is dominant
};

inline bool Packet::load(std::span<const Ray> rays, Precision precision) {
    using namespace simd;
    constexpr auto tag = floats<group>;
    constexpr float most_spread = 0.25f;  // of directions, in units of the longest component
    rays_ = rays;
    precision_ = precision;
    // Most rays that do not belong together are found out by three of them.
    for (const Ray& ray : {rays[rays.size() / 2], rays.back()})
        for (int axis = 0; axis < 3; ++axis)
            if (!(ray.direction[axis] * rays.front().direction[axis] > 0)) return false;
    static_assert(offsetof(Ray, t_min) == 12 && offsetof(Ray, direction) == 16 &&
                  offsetof(Ray, t_max) == 28);
    auto& origin = origin_.rows;
    auto& direction = direction_.rows;
    for (std::size_t i = 0; i < rays.size(); i += 8)
        transpose_8x8(reinterpret_cast<const std::byte*>(&rays[i]), sizeof(Ray),
                      {&origin[0][i], &origin[1][i], &origin[2][i], &t_min_[i], &direction[0][i],
                       &direction[1][i], &direction[2][i], &t_[i]});
    const auto [lo, hi] = ends(direction_, all());
    const float longest = std::max({std::abs(lo.x), std::abs(lo.y), std::abs(lo.z), std::abs(hi.x),
                                    std::abs(hi.y), std::abs(hi.z)});
    for (int axis = 0; axis < 3; ++axis) {
        // Zeros would need care with their signs, and nearly the same way is enough.
        const bool one_sign = lo[axis] > 0 || hi[axis] < 0;
        if (!one_sign || !(hi[axis] - lo[axis] < most_spread * longest)) return false;
    }
    if (precision == Precision::watertight && !share_an_axis(lo, hi)) return false;
    const SlabRay first(rays.front().origin, rays.front().direction);
    near_ = first.near;
    far_ = first.far;
    for (std::size_t i = 0; i < rays.size(); i += group) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            put(hn::Div(hn::Set(tag, 1.0f), row(direction[axis], i)), inverse_.rows[axis], i);
        put(taxicab(direction_.from(i)), direction_size_, i);
        put(below(row(t_, i)), t_, i);
        put(hn::Zero(tag), u_, i);
        put(hn::Zero(tag), v_, i);
        hn::Store(hn::Set(words<group>, no_primitive), words<group>, &primitive_[i]);
    }
    return true;
}

/// Given the ends of their directions, whose signs are the same. If so, computes their shears.
inline bool Packet::share_an_axis(const vec3& lo, const vec3& hi) {
    const Shear shear(lo);
    for (const int other : {shear.x, shear.y})
        if (!(std::min(std::abs(lo[shear.z]), std::abs(hi[shear.z])) >
              std::max(std::abs(lo[other]), std::abs(hi[other]))))
            return false;
    axes_ = {static_cast<std::size_t>(shear.x), static_cast<std::size_t>(shear.y),
             static_cast<std::size_t>(shear.z)};
    const auto& direction = direction_.rows;
    for (std::size_t i = 0; i < rays_.size(); i += group) {
        const V along_z = row(direction[axes_[2]], i);
        put(simd::hn::Div(row(direction[axes_[0]], i), along_z), along_x_, i);
        put(simd::hn::Div(row(direction[axes_[1]], i), along_z), along_y_, i);
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

template <class Bounds>
inline Packet::Mask Packet::meets(std::size_t g, const Bounds& boxes, std::size_t box) const {
    using namespace simd;
    const std::size_t first = g * group;
    const auto origin = origin_.from(first), inverse = inverse_.from(first);
    V entry = row(t_min_, first), exit = row(t_, first);
    const auto narrow = [&](std::size_t axis, V from, V scale) {
        const auto at = [&](std::size_t place) {
            return hn::Set(floats<group>, plane(boxes, axis, place, box));
        };
        entry = larger(hn::Mul(hn::Sub(at(near_[axis]), from), scale), entry);
        exit = smaller(hn::Mul(hn::Sub(at(far_[axis]), from), scale), exit);
    };
    narrow(0, origin.x, inverse.x);
    narrow(1, origin.y, inverse.y);
    narrow(2, origin.z, inverse.z);
    return hn::Le(entry, exit);
}

template <Query Q, Precision P, Counter C>
[[gnu::always_inline]] inline void Packet::test(std::size_t g, Mask active,
                                                const TriangleBlock& block, float padding,
                                                C& count) {
    using namespace simd;
    constexpr auto tag = floats<group>;
    const std::size_t first = g * group;
    const auto origin = origin_.from(first), direction = direction_.from(first);
    for (std::size_t lane = 0; lane < TriangleBlock::width; ++lane) {
        const std::uint32_t primitive = block.primitive[lane];
        if (primitive == no_primitive) break;
        if constexpr (C::counts) count(Event::object_test, hn::CountTrue(tag, active));
        const Triangle triangle = block.triangle(lane);
        const auto offer = [&](V t, V u, V v, Mask inside) {
            const Box box = bounds(triangle);
            const auto lo = everywhere<group>(box.lo), hi = everywhere<group>(box.hi);
            const auto at = clamped<V>({t, inside}, everywhere<group>(triangle.a),
                                       {lo.x, lo.y, lo.z, hi.x, hi.y, hi.z}, origin,
                                       inverse_.from(first), padding);
            if constexpr (C::counts) count(Event::object_hit, hn::CountTrue(tag, at.met));
            accept<Q>(first, at, u, v, primitive);
        };
        if constexpr (P == Precision::standard) {
            const vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
            const WideSums<V> sums(everywhere<group>(triangle.a), everywhere<group>(e1),
                                   everywhere<group>(e2), origin, direction);
            const auto trusted = sums.trusted(
                hn::Mul(hn::Set(tag, taxicab(e1) * taxicab(e2)), row(direction_size_, first)));
            const auto inside = hn::And(active, hn::And(trusted, sums.inside()));
            const std::uint32_t untrusted = bits(tag, hn::AndNot(trusted, active));
            if (hn::AllFalse(tag, inside) && untrusted == 0) continue;
            offer(hn::Div(sums.t, sums.det), hn::Div(sums.u, sums.det), hn::Div(sums.v, sums.det),
                  inside);
            test_alone(first, untrusted, [&](const TestRay& ray, Hit& hit) {
                test_in_double(block, lane, ray, padding, hit, count);
            });
        } else {
            const auto seen = [&](std::size_t corner) {
                const auto component = [&](std::size_t axis) {
                    return hn::Sub(hn::Set(tag, block.corner[3 * corner + axis][lane]),
                                   row(origin_.rows[axis], first));
                };
                return Vectors<V>{component(axes_[0]), component(axes_[1]), component(axes_[2])};
            };
            const WideEdges<V> edges(seen(0), seen(1), seen(2), row(along_x_, first),
                                     row(along_y_, first));
            const auto left = hn::AndNot(edges.outside(), active);
            if (hn::AllFalse(tag, left)) continue;
            const auto at = edges.exact(row(direction_.rows[axes_[2]], first));
            offer(at.t, at.u, at.v, hn::And(left, hn::Eq(at.t, at.t)));
        }
    }
    retire<Q>(first);
}

template <Query Q, Counter C>
inline void Packet::test(std::size_t g, Mask active, const SphereBlock& block, float padding,
                         C& count) {
    using namespace simd;
    constexpr auto tag = floats<group>;
    const std::size_t first = g * group;
    const Lines rays = lines(first);
    for (std::size_t lane = 0; lane < SphereBlock::width; ++lane) {
        const std::uint32_t primitive = block.primitive[lane];
        if (primitive == no_primitive) break;
        if constexpr (C::counts) count(Event::object_test, hn::CountTrue(tag, active));
        const auto centre = everywhere<group>(block.sphere(lane).centre);
        const V radius = hn::Set(tag, block.radius[lane]);
        const WideRoots<V> sphere(centre, radius, rays.origin, rays.direction);
        const auto trusted = sphere.trusted(rays.direction_size);
        const auto inside = hn::And(active, hn::And(trusted, sphere.met()));
        const std::uint32_t untrusted = bits(tag, hn::AndNot(trusted, active));
        if (hn::AllFalse(tag, inside) && untrusted == 0) continue;
        const auto [t, met] = clamped<V>({sphere.roots(), inside}, centre, radius, rays.origin,
                                         rays.inverse, padding);
        if constexpr (C::counts) count(Event::object_hit, hn::CountTrue(tag, met));
        // A root that does not exist is NaN, and no NaN is accepted.
        for (const V root : t)
            accept<Q>(first, {root, met}, hn::Zero(tag), hn::Zero(tag), primitive);
        test_alone(first, untrusted, [&](const TestRay& ray, Hit& hit) {
            test_untrusted(block, 1u << lane, ray, padding, hit, count);
        });
    }
    retire<Q>(first);
}

template <Query Q, class Test>
inline void Packet::test_each(std::size_t g, Mask active, Test&& test) {
    test_alone(g * group, simd::bits(simd::floats<group>, active), test);
    retire<Q>(g * group);
}

/// accept() of leaves.h in every lane.
template <Query Q>
inline void Packet::accept(std::size_t first, const WideHit<V>& at, V u, V v,
                           std::uint32_t primitive) {
    using namespace simd;
    constexpr auto word = words<group>;
    const auto [t, met] = at;
    const V best = row(t_, first);
    const auto number = hn::Set(word, primitive), holder = hn::Load(word, &primitive_[first]);
    const auto earlier = hn::RebindMask(floats<group>, hn::Lt(number, holder));
    const auto better = hn::And(hn::And(met, hn::Gt(t, row(t_min_, first))),
                                hn::Or(hn::Lt(t, best), hn::And(hn::Eq(t, best), earlier)));
    put(hn::IfThenElse(better, t, best), t_, first);
    hn::Store(hn::IfThenElse(hn::RebindMask(word, better), number, holder), word,
              &primitive_[first]);
    if constexpr (Q == Query::closest) {
        put(hn::IfThenElse(better, u, row(u_, first)), u_, first);
        put(hn::IfThenElse(better, v, row(v_, first)), v_, first);
    }
}

/// One ray after the other, a bit each.
template <class Test>
inline void Packet::test_alone(std::size_t first, std::uint32_t rays, Test&& test) {
    for (; rays != 0; rays &= rays - 1) {
        const std::size_t i = first + static_cast<std::size_t>(std::countr_zero(rays));
        const TestRay ray(rays_[i], precision_);
        Hit best = hit(i);
        test(ray, best);
        t_[i] = best.t;
        u_[i] = best.u;
        v_[i] = best.v;
        primitive_[i] = best.primitive;
    }
}

template <Query Q>
inline void Packet::retire(std::size_t first) {
    using namespace simd;
    if constexpr (Q == Query::occluded) {
        const auto lit =
            hn::Eq(hn::Load(words<group>, &primitive_[first]), hn::Set(words<group>, no_primitive));
        put(hn::IfThenElse(hn::RebindMask(floats<group>, lit), row(t_, first),
                           hn::Set(floats<group>, -infinity)),
            t_, first);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

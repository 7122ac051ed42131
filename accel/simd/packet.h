#pragma once

#include "accel/simd/beam.h"
#include "accel/simd/rays_by_blocks.h"
#include "accel/simd/transpose.h"

#include <tuple>

/// Rays that go nearly the same way, side by side.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Some rays of a packet or of one of its groups, a bit each, the first one's lowest.
using RaySet = std::uint64_t;

class Packet {
public:
    /// A group is one register or two, so that what is counted does not depend on the machine.
    static constexpr std::size_t lanes = simd::widest, group = 16, most = 64;
    static constexpr RaySet everyone = (RaySet{1} << group) - 1;  ///< of a group
    using V = simd::Floats<lanes>;

    /// The rays of some groups, one after the other.
    struct Section {
        std::size_t first, end;
    };

    /// Whole groups, 64 rays at most, which stay where they are while the packet is in use. False,
    /// and no packet, where they do not go nearly the same way, or begin all over the place:
    /// farther than `most_apart` along any axis.
    bool load(std::span<const Ray> rays, Precision precision, float most_apart);

    std::size_t groups() const { return rays_.size() / group; }
    Section all() const { return {0, rays_.size()}; }
    static Section one(std::size_t g) { return {g * group, (g + 1) * group}; }
    const Hit& hit(std::size_t ray) const { return hits_[ray]; }

    // For those who clip the rays themselves: of the rays from `first` on, as many as fill a
    // register.
    bool descending(std::size_t axis) const { return near_[axis] > far_[axis]; }
    V origin(std::size_t axis, std::size_t first) const { return row(origin_.rows[axis], first); }
    V inverse(std::size_t axis, std::size_t first) const { return row(inverse_.rows[axis], first); }
    V t_min(std::size_t first) const { return row(t_min_, first); }
    /// The nearest hits so far.
    V nearest(std::size_t first) const { return row(t_, first); }

    Beam beam(Section section) const;
    /// The farthest of a section's nearest hits so far.
    float reach(Section section) const;
    /// The least and the largest coordinate along `axis` where the lines of all rays meet a plane
    /// across the axis `over`; rounded.
    std::pair<float, float> span(std::size_t axis, std::size_t over, float plane) const;
    /// Whether the nearest hit of some ray so far is not before a plane.
    bool any_reaches(std::size_t axis, float plane) const;
    /// The rays of a group that enter one of several boxes before their nearest hit.
    template <class Bounds>
    RaySet enter(std::size_t group, const Bounds& boxes, std::size_t box) const;
    /// Tests some rays of the packet against every triangle of a block; P: the packet's precision.
    template <Query Q, Precision P, Counter C>
    void test(RaySet rays, const TriangleBlock& block, float padding, C& count);
    /// Or against every sphere.
    template <Query Q, Counter C>
    void test(RaySet rays, const SphereBlock& block, float padding, C& count);
    /// Calls test(ray, hit) for one ray after the other.
    template <Query Q, class Test>
    void test_each(RaySet rays, Test&& test);

private:
    using Rows = std::array<float, most>;
    struct alignas(64) VectorRows {
        std::array<Rows, 3> rows;
        simd::Vectors<V> from(std::size_t first) const {
            return {row(rows[0], first), row(rows[1], first), row(rows[2], first)};
        }
    };
    /// As many rays as are tested at once; some twice where there are not as many.
    struct Some {
        std::array<std::size_t, rays_by_blocks> numbers;
        std::size_t size = 0;  ///< of the numbers, those that are not repeated
    };

    /// The least and the largest coordinates.
    static std::pair<vec3, vec3> ends(const VectorRows& vectors, Section section);
    static V row(const Rows& rows, std::size_t first) {
        return simd::hn::Load(simd::floats<lanes>, &rows[first]);
    }
    static void put(V value, Rows& rows, std::size_t first) {
        simd::hn::Store(value, simd::floats<lanes>, &rows[first]);
    }
    /// Takes them out of the set.
    static Some take_some(RaySet& rays);
    QuadsOfRays quads_of(const Some& some) const;
    /// Calls test(rays, size, hit_of, ray_of) for as many at once as can be; it returns false if
    /// surely no hit has changed.
    template <Query Q, class Test>
    void test_some(RaySet rays, Test&& test);
    /// After its hit may have changed. For Query::occluded one hit is enough: such rays meet
    /// nothing from now on.
    template <Query Q>
    void update(std::size_t ray);

    VectorRows origin_, inverse_;
    alignas(64) Rows t_min_, t_;  ///< t_: of the nearest hits
    std::array<Hit, most> hits_;
    std::span<const Ray> rays_;
    Precision precision_ = Precision::standard;
    std::array<std::size_t, 3> near_, far_;  ///< the same for all rays
};

inline bool Packet::load(std::span<const Ray> rays, Precision precision, float most_apart) {
    using namespace simd;
    constexpr auto tag = floats<lanes>;
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
    auto& direction = inverse_.rows;  // until they are inverted
    for (std::size_t i = 0; i < rays.size(); i += 8)
        transpose_8x8(reinterpret_cast<const std::byte*>(&rays[i]), sizeof(Ray),
                      {&origin[0][i], &origin[1][i], &origin[2][i], &t_min_[i], &direction[0][i],
                       &direction[1][i], &direction[2][i], &t_[i]});
    const auto [lo, hi] = ends(inverse_, all());
    const float longest = std::max({std::abs(lo.x), std::abs(lo.y), std::abs(lo.z), std::abs(hi.x),
                                    std::abs(hi.y), std::abs(hi.z)});
    for (int axis = 0; axis < 3; ++axis) {
        // Zeros would need care with their signs, and nearly the same way is enough.
        const bool one_sign = lo[axis] > 0 || hi[axis] < 0;
        if (!one_sign || !(hi[axis] - lo[axis] < most_spread * longest)) return false;
    }
    const auto [from, to] = ends(origin_, all());
    const vec3 apart = to - from;
    if (std::max({apart.x, apart.y, apart.z}) > most_apart) return false;
    const SlabRay first(rays.front().origin, rays.front().direction);
    near_ = first.near;
    far_ = first.far;
    for (std::size_t i = 0; i < rays.size(); i += lanes) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            put(hn::Div(hn::Set(tag, 1.0f), row(direction[axis], i)), inverse_.rows[axis], i);
        put(below(row(t_, i)), t_, i);
    }
    for (std::size_t i = 0; i < rays.size(); ++i) hits_[i] = {t_[i], no_primitive, 0, 0};
    return true;
}

inline std::pair<vec3, vec3> Packet::ends(const VectorRows& vectors, Section section) {
    using namespace simd;
    constexpr auto tag = floats<lanes>;
    auto lo = vectors.from(section.first), hi = lo;
    for (std::size_t i = section.first + lanes; i < section.end; i += lanes) {
        const auto next = vectors.from(i);
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
    V earliest = row(t_min_, section.first);
    for (std::size_t i = section.first + lanes; i < section.end; i += lanes)
        earliest = hn::Min(earliest, row(t_min_, i));
    beam.t_min = hn::GetLane(hn::MinOfLanes(floats<lanes>, earliest));
    beam.nearest = reach(section);
    return beam;
}

inline float Packet::reach(Section section) const {
    V farthest = row(t_, section.first);
    for (std::size_t i = section.first + lanes; i < section.end; i += lanes)
        farthest = simd::hn::Max(farthest, row(t_, i));
    return simd::hn::GetLane(simd::hn::MaxOfLanes(simd::floats<lanes>, farthest));
}

inline std::pair<float, float> Packet::span(std::size_t axis, std::size_t over, float plane) const {
    using namespace simd;
    constexpr auto tag = floats<lanes>;
    V lo = hn::Set(tag, infinity), hi = hn::Set(tag, -infinity);
    for (std::size_t i = 0; i < rays_.size(); i += lanes) {
        const V t = hn::Mul(hn::Sub(hn::Set(tag, plane), row(origin_.rows[over], i)),
                            row(inverse_.rows[over], i));
        const V x = hn::Add(row(origin_.rows[axis], i), hn::Div(t, row(inverse_.rows[axis], i)));
        lo = hn::Min(lo, x);
        hi = hn::Max(hi, x);
    }
    return {hn::GetLane(hn::MinOfLanes(tag, lo)), hn::GetLane(hn::MaxOfLanes(tag, hi))};
}

inline bool Packet::any_reaches(std::size_t axis, float plane) const {
    using namespace simd;
    constexpr auto tag = floats<lanes>;
    auto any = hn::Lt(hn::Zero(tag), hn::Zero(tag));
    for (std::size_t i = 0; i < rays_.size(); i += lanes) {
        const V t = hn::Mul(hn::Sub(hn::Set(tag, plane), row(origin_.rows[axis], i)),
                            row(inverse_.rows[axis], i));
        any = hn::Or(any, hn::Not(hn::Lt(row(t_, i), t)));
    }
    return !hn::AllFalse(tag, any);
}

template <class Bounds>
[[gnu::always_inline]] inline RaySet Packet::enter(std::size_t g, const Bounds& boxes,
                                                   std::size_t box) const {
    using namespace simd;
    RaySet entering = 0;
    for (std::size_t i = 0; i < group; i += lanes) {
        const std::size_t first = g * group + i;
        const auto origin = origin_.from(first), inverse = inverse_.from(first);
        V entry = row(t_min_, first), exit = row(t_, first);
        const auto narrow = [&](std::size_t axis, V from, V scale) {
            const auto at = [&](std::size_t place) {
                return hn::Set(floats<lanes>, plane(boxes, axis, place, box));
            };
            entry = larger(hn::Mul(hn::Sub(at(near_[axis]), from), scale), entry);
            exit = smaller(hn::Mul(hn::Sub(at(far_[axis]), from), scale), exit);
        };
        narrow(0, origin.x, inverse.x);
        narrow(1, origin.y, inverse.y);
        narrow(2, origin.z, inverse.z);
        entering |= RaySet{bits(floats<lanes>, hn::Le(entry, exit))} << i;
    }
    return entering;
}

inline Packet::Some Packet::take_some(RaySet& rays) {
    Some some;
    RaySet left = rays;
    for (std::size_t& number : some.numbers) {
        left = rays != 0 ? rays : left;
        number = static_cast<std::size_t>(std::countr_zero(left));
        some.size += rays != 0;
        rays &= rays - 1;
    }
    return some;
}

inline QuadsOfRays Packet::quads_of(const Some& some) const {
    std::array<const Ray*, rays_by_blocks> rays;
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = &rays_[some.numbers[i]];
    return QuadsOfRays(rays);
}

template <Query Q, class Test>
[[gnu::always_inline]] inline void Packet::test_some(RaySet rays, Test&& test) {
    while (rays != 0) {
        const Some some = take_some(rays);
        const auto hit_of = [&](std::size_t i) -> Hit& { return hits_[some.numbers[i]]; };
        const auto ray_of = [&](std::size_t i) -> const Ray& { return rays_[some.numbers[i]]; };
        if (!test(quads_of(some), some.size, hit_of, ray_of)) continue;
        for (const std::size_t ray : some.numbers) update<Q>(ray);
    }
}

template <Query Q, Precision P, Counter C>
[[gnu::always_inline]] inline void Packet::test(RaySet rays, const TriangleBlock& block,
                                                float padding, C& count) {
    const QuadsOfTriangles triangles(block);
    const auto test = [&](const QuadsOfRays& some, std::size_t size, auto hit_of, auto ray_of)
        __attribute__((always_inline)) {
        const auto in_double = [&](std::size_t i, std::size_t lane) {
            test_in_double(block, lane, TestRay(ray_of(i), P), padding, hit_of(i), count);
        };
        return rayshoot::test<Q, P, Misses::leave>(triangles, some, size, hit_of, in_double,
                                                   padding, count);
    };
    test_some<Q>(rays, test);
}

template <Query Q, Counter C>
inline void Packet::test(RaySet rays, const SphereBlock& block, float padding, C& count) {
    for (std::size_t first = 0; first < block.width; first += 4) {
        if (block.primitive[first] == no_primitive) break;
        const QuadsOfSpheres spheres(block, first);
        const auto test = [&](const QuadsOfRays& some, std::size_t size, auto hit_of, auto ray_of)
            __attribute__((always_inline)) {
            const auto in_double = [&](std::size_t i, std::size_t lane) {
                test_untrusted(block, 1u << (first + lane), TestRay(ray_of(i), precision_), padding,
                               hit_of(i), count);
            };
            return rayshoot::test<Misses::leave>(spheres, some, size, hit_of, in_double, padding,
                                                 count);
        };
        test_some<Q>(rays, test);
    }
}

template <Query Q, class Test>
inline void Packet::test_each(RaySet rays, Test&& test) {
    simd::for_each(rays, [&](std::size_t ray) {
        test(TestRay(rays_[ray], precision_), hits_[ray]);
        update<Q>(ray);
    });
}

template <Query Q>
inline void Packet::update(std::size_t ray) {
    const bool over = Q == Query::occluded && hits_[ray].primitive != no_primitive;
    t_[ray] = over ? -infinity : hits_[ray].t;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

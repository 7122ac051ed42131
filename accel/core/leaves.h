#pragma once

#include "accel/core/counters.h"
#include "accel/core/geometry.h"
#include "accel/core/pages.h"
#include "accel/core/primitive/padding.h"

/// The packed leaf format that all structures share, and the one place where primitives are tested,
/// hits clamped and compared, and object tests counted.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Where the search for a ray's hit starts: one lexicographic compare (t, then primitive) against
/// it covers the interval's end too.
inline Hit nothing_yet(const Ray& ray) { return {float_below(ray.t_max), no_primitive, 0, 0}; }

/// Slots of one leaf, in a Leaves.
struct LeafRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Primitives in leaf order: within a leaf by kind, then motion, then number, so that neither the
/// switch on the kind nor the motion of the ray stands inside the loop over primitives.
class Leaves {
public:
    Leaves() = default;
    /// `order`: primitive numbers (repetitions allowed), `leaves`: ranges of it. Refers to
    /// `geometry`.
    Leaves(const Geometry& geometry, std::span<const std::uint32_t> order,
           std::span<const LeafRange> leaves);

    /// What test() needs of a ray, computed once.
    TestRay prepared(const Ray& ray) const { return {ray, geometry_->precision()}; }

    /// Tests the ray against every primitive of a leaf; for Query::occluded until one is hit.
    template <Query Q, Counter C>
    void test(LeafRange leaf, const TestRay& ray, Hit& hit, C& count) const;

    std::size_t bytes() const { return slots_.size() * sizeof(Slot); }
    std::size_t size() const { return slots_.size(); }

private:
    struct Slot {
        Triangle triangle;  ///< of a triangle; a sphere: centre in a, radius in b.x
        std::uint32_t primitive;
        std::uint32_t tag;  ///< motion * primitive_kinds + kind

        PrimitiveKind kind() const { return static_cast<PrimitiveKind>(tag % primitive_kinds); }
        std::uint32_t motion() const { return tag / primitive_kinds; }
    };

    Slot pack(std::uint32_t primitive) const;
    /// `run`: slots of one kind and motion; `ray`: as their rest frame sees it.
    template <Query Q, Counter C>
    void test_run(std::span<const Slot> run, const TestRay& world, const TestRay& ray, Hit& hit,
                  C& count) const;
    template <Query Q, Counter C, class Meet>
    void test_each(std::span<const Slot> run, const TestRay& world, Hit& hit, C& count,
                   Meet&& meet_slot) const;
    Box bounds_of(const Slot& slot) const;
    /// Whom a ray misses there it does not hit (README, rule 2). Asked before tests in double,
    /// which take several times as long; not inline, or the float tests beside them no longer are.
    bool misses_bounds(const Slot& slot, const TestRay& world) const;

    const Geometry* geometry_ = nullptr;
    PagedVector<Slot> slots_;
    bool plain_ = false;  ///< nothing but triangles that stand still, in the standard precision
};

/// Tests one primitive: the shared test without a structure around it.
template <Query Q, Counter C>
void test_primitive(const Geometry& geometry, std::uint32_t primitive, const Ray& ray, Hit& hit,
                    C& count) {
    const LeafRange all{0, 1};
    Leaves(geometry, std::span(&primitive, 1), std::span(&all, 1))
        .test<Q>(all, TestRay(ray, geometry.precision()), hit, count);
}

/// Rules 3 and 4 of the README, for a t that is clamped.
inline void accept(const Hit& candidate, float t_min, Hit& best) {
    if (candidate.t > t_min &&
        (candidate.t < best.t || (candidate.t == best.t && candidate.primitive < best.primitive)))
        best = candidate;
}

/// The definition of a hit (README, rules 2 to 4): clamped to its primitive's bounds, then
/// compared. `strays(clamped)`: whether the clamp takes it too far. Returns whether the primitive
/// was hit at all.
template <class Strays>
inline bool offer(float t, float u, float v, std::uint32_t primitive, const Box& bounds,
                  const TestRay& world, Hit& hit, Strays&& strays) {
    const Interval interval = clip(world, bounds);
    if (interval.empty() || std::isnan(t)) return false;
    const float clamped = interval.clamp(t);
    if (clamped != t && strays(clamped)) [[unlikely]]
        return false;
    accept({clamped, primitive, u, v}, world.t_min, hit);
    return true;
}

/// All but triangles in the standard precision: where they are reported, the line meets their
/// bounds (README, "After the clamp").
template <class Shape>
inline bool strays(const Shape&, const TestRay&, float /*t*/, float /*clamped*/) {
    return false;
}

/// Rule 1, and what rule 2 asks of the primitive: calls report(t, u, v, strays).
template <class Shape, class Report>
inline void meet(const Shape& shape, const TestRay& ray, Report&& report) {
    intersect(shape, ray, [&](float t, float u, float v) {
        report(t, u, v, [&](float clamped) { return strays(shape, ray, t, clamped); });
    });
}
template <class Report>
inline void meet_watertight(const Triangle& triangle, const TestRay& ray, Report&& report) {
    intersect_watertight(triangle, ray, [&](float t, float u, float v) {
        report(t, u, v, [](float) { return false; });
    });
}

/// Of a triangle that stands still: from the slot itself, which is at hand, not from memory far
/// away.
inline Box Leaves::bounds_of(const Slot& slot) const {
    if (slot.tag == static_cast<std::uint32_t>(PrimitiveKind::triangle))
        return padded(bounds(slot.triangle), geometry_->padding());
    return geometry_->bounds(slot.primitive);
}

template <Query Q, Counter C, class Meet>
inline void Leaves::test_each(std::span<const Slot> run, const TestRay& world, Hit& hit, C& count,
                              Meet&& meet_slot) const {
    for (const Slot& slot : run) {
        bool met = false;
        meet_slot(slot, [&](float t, float u, float v, auto&& strays) {
            met |= offer(t, u, v, slot.primitive, bounds_of(slot), world, hit, strays);
        });
        count(Event::object_test);
        if constexpr (C::counts) count(Event::object_hit, met);
        if constexpr (Q == Query::occluded)
            if (hit.primitive != no_primitive) return;
    }
}

template <Query Q, Counter C>
inline void Leaves::test_run(std::span<const Slot> run, const TestRay& world, const TestRay& ray,
                             Hit& hit, C& count) const {
    switch (run.front().kind()) {
        case PrimitiveKind::triangle:
            if (geometry_->precision() == Precision::standard)
                return test_each<Q>(run, world, hit, count, [&](const Slot& slot, auto&& report) {
                    meet(slot.triangle, ray, report);
                });
            return test_each<Q>(run, world, hit, count, [&](const Slot& slot, auto&& report) {
                meet_watertight(slot.triangle, ray, report);
            });
        case PrimitiveKind::sphere:
            return test_each<Q>(run, world, hit, count, [&](const Slot& slot, auto&& report) {
                meet(Sphere{slot.triangle.a, slot.triangle.b.x}, ray, report);
            });
        case PrimitiveKind::frustum:
            return test_each<Q>(run, world, hit, count, [&](const Slot& slot, auto&& report) {
                if (misses_bounds(slot, world)) return;
                meet(geometry_->frustum(geometry_->ref(slot.primitive).index), ray, report);
            });
        case PrimitiveKind::polygon:
            return test_each<Q>(run, world, hit, count, [&](const Slot& slot, auto&& report) {
                if (misses_bounds(slot, world)) return;
                meet(geometry_->polygon(geometry_->ref(slot.primitive).index), ray, report);
            });
    }
}

template <Query Q, Counter C>
inline void Leaves::test(LeafRange leaf, const TestRay& ray, Hit& hit, C& count) const {
    std::span<const Slot> rest(slots_.data() + leaf.first, leaf.count);
    if (plain_)  // the most common case, without the calls that the others need
        return test_each<Q>(rest, ray, hit, count, [&](const Slot& slot, auto&& report) {
            meet(slot.triangle, ray, report);
        });
    while (!rest.empty()) {
        const std::uint32_t tag = rest.front().tag;
        std::size_t length = 1;
        while (length < rest.size() && rest[length].tag == tag) ++length;
        if (const std::uint32_t motion = rest.front().motion(); motion == no_motion) [[likely]] {
            test_run<Q>(rest.first(length), ray, ray, hit, count);
        } else {
            const Ray moving{ray.origin, ray.t_min, ray.direction, infinity, ray.time};
            const TestRay at_rest = prepared(into_rest_frame(geometry_->motion(motion), moving));
            test_run<Q>(rest.first(length), ray, at_rest, hit, count);
        }
        if constexpr (Q == Query::occluded)
            if (hit.primitive != no_primitive) return;
        rest = rest.subspan(length);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

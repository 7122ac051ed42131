#pragma once

#include "accel/grid/cell_word.h"
#include "accel/grid/walk.h"
#include "accel/simd/rays_by_blocks.h"

/// Many rays on their way through one lattice, side by side: a lane of a register steps for each.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Some rays of a flock, a bit each.
using LaneSet = std::uint64_t;

/// Calls visit(lane) for each of a set.
inline void for_each_lane(LaneSet set, const auto& visit) {
    for (; set != 0; set &= set - 1) visit(static_cast<std::size_t>(std::countr_zero(set)));
}

class Flock {
public:
    static constexpr std::size_t width = simd::widest, size = 32;
    /// A ray is alone if it begins so many cells from a lattice that where it is at a t might be
    /// computed a whole cell off.
    static constexpr float most_cells_away = 0x1p14f;

    /// What has become of the rays that a step moved.
    struct Stepped {
        LaneSet moved = 0;    ///< came to another cell
        LaneSet arrived = 0;  ///< of those: one that is not empty
        LaneSet ended = 0;    ///< met nothing that could come before their hit
        LaneSet tied = 0;     ///< touch several cells at once, which a lane cannot follow
    };

    /// A ray that comes into the lattice at t: lane `i` is its own from now on.
    void start(std::size_t i, const Ray& ray, const TestRay& prepared, const Hit& hit,
               std::uint32_t number, const Lattice& lattice, float t, const CellWord* cells);
    /// One step for all rays of a set, which are among `width` lanes from the first one on.
    Stepped step(std::size_t first, LaneSet walking, const Lattice& lattice, const CellWord* cells);

    CellWord word(std::size_t i) const { return CellWord::from(word_[i]); }
    void set_word(std::size_t i, CellWord word) { word_[i] = word.bits(); }
    /// Where the ray came to its cell.
    float t(std::size_t i) const { return t_[i]; }
    TestRay& ray(std::size_t i) { return rays_[i]; }
    Hit& hit(std::size_t i) { return hits_[i]; }
    std::uint32_t number(std::size_t i) const { return numbers_[i]; }
    /// After the hit of a lane may have changed.
    void update(std::size_t i) { nearest_[i] = hits_[i].t; }

private:
    using V = simd::Floats<width>;
    using Row = std::array<float, size>;
    struct Axis {
        Row origin, direction, inverse;
        Row place;   ///< number of the plane by which the ray leaves its cell
        Row stride;  ///< to the next one: 1 or -1
        Row end;     ///< by which it leaves the lattice
    };
    struct Progress;

    static V load(const Row& row, std::size_t first) {
        return simd::hn::Load(simd::floats<width>, &row[first]);
    }
    static V all(float x) { return simd::hn::Set(simd::floats<width>, x); }

    alignas(64) std::array<Axis, 3> axes_;
    alignas(64) Row nearest_, t_;
    alignas(64) std::array<std::uint32_t, size> word_;
    std::array<TestRay, size> rays_ = filled(std::make_index_sequence<size>());
    std::array<Hit, size> hits_;
    std::array<std::uint32_t, size> numbers_;

    template <std::size_t... I>
    static std::array<TestRay, size> filled(std::index_sequence<I...>) {
        return {((void)I, TestRay(Ray{}, Precision::standard))...};
    }
};

inline void Flock::start(std::size_t i, const Ray& ray, const TestRay& prepared, const Hit& hit,
                         std::uint32_t number, const Lattice& lattice, float t,
                         const CellWord* cells) {
    const PlaneCrossings cross{lattice, prepared};
    Cell at;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        at[axis] = cross.first(a, t);
        const int leaving = 1 - cross.descending(a);
        Axis& own = axes_[axis];
        own.origin[i] = ray.origin[a];
        own.direction[i] = ray.direction[a];
        own.inverse[i] = prepared.inverse[a];
        own.place[i] = static_cast<float>(at[axis] + leaving);
        own.stride[i] = static_cast<float>(cross.stride(a));
        own.end[i] = static_cast<float>(leaving * lattice.cells()[axis]);
    }
    rays_[i] = prepared;
    hits_[i] = hit;
    nearest_[i] = hit.t;
    numbers_[i] = number;
    t_[i] = t;
    word_[i] = cells[lattice.number(at)].bits();
}

/// Along one axis.
struct Flock::Progress {
    V origin, inverse, stride, place;
    V most;  ///< cells to the last one that is empty for sure
    V lo, cell_size;

    Progress(const Axis& axis, std::size_t first, V clearance, const vec3& lo_of, const vec3& step,
             int a)
        : origin(load(axis.origin, first)),
          inverse(load(axis.inverse, first)),
          stride(load(axis.stride, first)),
          place(load(axis.place, first)),
          lo(all(lo_of[a])),
          cell_size(all(step[a])) {
        using namespace simd;
        const V to_end = hn::Mul(hn::Sub(load(axis.end, first), place), stride);
        most = smaller(clearance, to_end);
    }
    /// Where the ray meets the plane so many cells on: the slab form.
    V leave(V on) const {
        using namespace simd;
        const V plane = hn::MulAdd(hn::MulAdd(on, stride, place), cell_size, lo);
        return hn::Mul(hn::Sub(plane, origin), inverse);
    }
    /// To the first cell that the ray does not leave before t: how many cells.
    V settle(V t, V direction, V per_step) const {
        using namespace simd;
        const V from_lo = hn::Sub(hn::MulAdd(t, direction, origin), lo);
        const V upward = hn::IfThenElseZero(hn::Gt(stride, hn::Zero(floats<width>)), all(1));
        const V guess = hn::Add(hn::Floor(hn::Mul(from_lo, per_step)), upward);
        const V distance = hn::Mul(hn::Sub(guess, place), stride);
        // In this order NaN, of a ray that stands still along the axis, is no cell.
        V on = smaller(larger(distance, hn::Zero(floats<width>)), most);
        const auto before = hn::Lt(leave(on), t);
        const auto beyond = hn::Ge(leave(hn::Sub(on, all(1))), t);
        on = hn::Add(on, hn::IfThenElseZero(before, all(1)));
        on = hn::Sub(on, hn::IfThenElseZero(hn::AndNot(before, beyond), all(1)));
        return larger(on, hn::Zero(floats<width>));
    }
};

inline Flock::Stepped Flock::step(std::size_t first, LaneSet walking, const Lattice& lattice,
                                  const CellWord* cells) {
    using namespace simd;
    constexpr auto tag = floats<width>;
    constexpr auto word_tag = words<width>;
    constexpr hn::FixedTag<std::int32_t, width> number_tag;
    const auto words_here = hn::Load(word_tag, &word_[first]);
    const auto is_empty = hn::Gt(words_here, hn::Set(word_tag, CellWord::empty().bits() - 1));
    const auto clearances =
        hn::IfThenElseZero(is_empty, hn::And(words_here, hn::Set(word_tag, 0x3f)));
    const V clearance = hn::ConvertTo(tag, hn::BitCast(number_tag, clearances));
    std::array<Progress, 3> along{
        Progress(axes_[0], first, clearance, lattice.lo(), lattice.step(), 0),
        Progress(axes_[1], first, clearance, lattice.lo(), lattice.step(), 1),
        Progress(axes_[2], first, clearance, lattice.lo(), lattice.step(), 2)};
    const V x = along[0].leave(along[0].most), y = along[1].leave(along[1].most),
            z = along[2].leave(along[2].most);
    const V t = hn::Min(hn::Min(x, y), z);
    const std::array<V, 3> leave{x, y, z};
    auto ended = hn::Lt(load(nearest_, first), t);
    auto outside = hn::Lt(t, t);  // nobody
    auto touched = outside, tied = outside;
    std::array<V, 3> place;
    for (std::size_t a = 0; a < 3; ++a) {
        const Progress& own = along[a];
        const V settled = own.settle(t, load(axes_[a].direction, first),
                                     all(lattice.per_step()[static_cast<int>(a)]));
        const auto out = hn::Eq(leave[a], t);
        const V on = hn::IfThenElse(out, own.most, settled);
        const auto meets = hn::Or(out, hn::Eq(own.leave(settled), t));
        tied = hn::Or(tied, hn::And(touched, meets));
        touched = hn::Or(touched, meets);
        place[a] = hn::MulAdd(hn::Add(on, hn::IfThenElseZero(out, all(1))), own.stride, own.place);
        const V rim = hn::MulAdd(own.most, own.stride, own.place);
        outside = hn::Or(outside, hn::And(out, hn::Eq(rim, load(axes_[a].end, first))));
    }
    const auto set = [&](auto mask) { return (LaneSet{bits(tag, mask)} << first) & walking; };
    Stepped stepped;
    stepped.ended = set(ended);
    stepped.tied = set(tied) & ~stepped.ended;
    const LaneSet left = set(outside) & ~stepped.ended & ~stepped.tied;
    stepped.ended |= left;
    stepped.moved = walking & ~stepped.ended & ~stepped.tied;
    if (stepped.moved == 0) return stepped;
    const auto moved = mask_of(tag, static_cast<std::uint32_t>(stepped.moved >> first));
    auto cell = hn::Zero(number_tag);
    for (std::size_t a = 3; a-- > 0;) {
        hn::BlendedStore(place[a], moved, tag, &axes_[a].place[first]);
        const V upward = hn::IfThenElseZero(hn::Gt(along[a].stride, hn::Zero(tag)), all(1));
        const auto index = hn::ConvertTo(number_tag, hn::Sub(place[a], upward));
        cell = hn::Add(hn::Mul(cell, hn::Set(number_tag, lattice.cells()[a])), index);
    }
    // Lanes that stay read the first cell.
    cell = hn::IfThenElseZero(hn::RebindMask(number_tag, moved), cell);
    const auto found =
        hn::GatherIndex(word_tag, reinterpret_cast<const std::uint32_t*>(cells), cell);
    hn::BlendedStore(found, hn::RebindMask(word_tag, moved), word_tag, &word_[first]);
    hn::BlendedStore(t, moved, tag, &t_[first]);
    const auto empty = hn::Gt(found, hn::Set(word_tag, CellWord::empty().bits() - 1));
    stepped.arrived = stepped.moved & ~(LaneSet{bits(tag, hn::RebindMask(tag, empty))} << first);
    return stepped;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

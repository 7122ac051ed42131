#pragma once

#include "accel/grid/cell_word.h"
#include "accel/grid/walk.h"
#include "accel/simd/rays_by_blocks.h"

/// Many rays on their way through one lattice, side by side: a lane of a register steps for each.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Some rays of a flock, a bit each.
using LaneSet = std::uint64_t;

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
    using Mask = decltype(simd::hn::Lt(V{}, V{}));
    static constexpr simd::hn::FixedTag<std::int32_t, width> numbers{};
    using Row = std::array<float, size>;
    struct Axis {
        Row origin, direction, inverse;
        Row place;   ///< number of the plane by which the ray leaves its cell
        Row stride;  ///< to the next one: 1 or -1
        Row end;     ///< by which it leaves the lattice
    };
    struct Progress;
    struct Ahead;

    static V load(const Row& row, std::size_t first) {
        return simd::hn::Load(simd::floats<width>, &row[first]);
    }
    static V all(float x) { return simd::hn::Set(simd::floats<width>, x); }
    /// 1 for rays that ascend, else 0: a cell's upper plane has the number after the cell's.
    static V upward(V stride) {
        return simd::hn::IfThenElseZero(simd::hn::Gt(stride, all(0)), all(1));
    }
    static auto is_empty(simd::Words<width> words_of_cells) {
        const auto others = simd::hn::Set(simd::words<width>, CellWord::empty().bits() - 1);
        return simd::hn::Gt(words_of_cells, others);
    }
    V clearances(std::size_t first) const;
    Ahead look_ahead(std::size_t first, const Lattice& lattice) const;
    LaneSet move(std::size_t first, LaneSet moved, const Ahead& ahead, const Lattice& lattice,
                 const CellWord* cells);

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
    V origin, direction, inverse, stride, place;
    V to_end;  ///< cells to the last one of the lattice
    V most;    ///< cells to the last one that is empty for sure
    V lo, cell_size, per_size;

    Progress(const std::array<Axis, 3>& axes, std::size_t a, std::size_t first, V clearance,
             const Lattice& lattice)
        : origin(load(axes[a].origin, first)),
          direction(load(axes[a].direction, first)),
          inverse(load(axes[a].inverse, first)),
          stride(load(axes[a].stride, first)),
          place(load(axes[a].place, first)),
          to_end(simd::hn::Mul(simd::hn::Sub(load(axes[a].end, first), place), stride)),
          most(simd::smaller(clearance, to_end)),
          lo(all(lattice.lo()[static_cast<int>(a)])),
          cell_size(all(lattice.step()[static_cast<int>(a)])),
          per_size(all(lattice.per_step()[static_cast<int>(a)])) {}

    /// Where the ray meets the plane so many cells on: the slab form.
    V leave(V on) const {
        using namespace simd;
        const V plane = hn::MulAdd(hn::MulAdd(on, stride, place), cell_size, lo);
        return hn::Mul(hn::Sub(plane, origin), inverse);
    }
    /// To the first cell that the ray does not leave before t: how many cells. A guess, and since
    /// it is never a whole cell off, one correction.
    V settle(V t) const {
        using namespace simd;
        const V from_lo = hn::Sub(hn::MulAdd(t, direction, origin), lo);
        const V guess = hn::Add(hn::Floor(hn::Mul(from_lo, per_size)), upward(stride));
        const V distance = hn::Mul(hn::Sub(guess, place), stride);
        // In this order NaN, of a ray that stands still along the axis, is no cell.
        V on = smaller(larger(distance, all(0)), most);
        const Mask before = hn::Lt(leave(on), t);
        const Mask beyond = hn::Ge(leave(hn::Sub(on, all(1))), t);
        on = hn::Add(on, hn::IfThenElseZero(before, all(1)));
        on = hn::Sub(on, hn::IfThenElseZero(hn::AndNot(before, beyond), all(1)));
        return larger(on, all(0));
    }
};

/// Where a step would take the rays.
struct Flock::Ahead {
    V t;                     ///< where they come there
    std::array<V, 3> place;  ///< the planes by which they leave the next cell
    Mask tied, outside;      ///< several axes are left at t; the lattice is
};

inline auto Flock::clearances(std::size_t first) const -> V {
    using namespace simd;
    constexpr auto tag = words<width>;
    const auto here = hn::Load(tag, &word_[first]);
    const auto cells = hn::IfThenElseZero(
        is_empty(here), hn::And(here, hn::Set(tag, std::uint32_t{CellWord::most_clearance})));
    return hn::ConvertTo(floats<width>, hn::BitCast(numbers, cells));
}

/// Along the axes that are left first a ray goes to the next cell, along the others to where it is
/// then.
inline auto Flock::look_ahead(std::size_t first, const Lattice& lattice) const -> Ahead {
    using namespace simd;
    const V clearance = clearances(first);
    const std::array<Progress, 3> along{Progress(axes_, 0, first, clearance, lattice),
                                        Progress(axes_, 1, first, clearance, lattice),
                                        Progress(axes_, 2, first, clearance, lattice)};
    const std::array<V, 3> leave{along[0].leave(along[0].most), along[1].leave(along[1].most),
                                 along[2].leave(along[2].most)};
    Ahead ahead;
    ahead.t = hn::Min(hn::Min(leave[0], leave[1]), leave[2]);
    Mask touched = hn::Lt(ahead.t, ahead.t);  // nobody yet
    ahead.tied = ahead.outside = touched;
    for (std::size_t a = 0; a < 3; ++a) {
        const Progress& own = along[a];
        const V settled = own.settle(ahead.t);
        const Mask out = hn::Eq(leave[a], ahead.t);
        const Mask meets = hn::Or(out, hn::Eq(own.leave(settled), ahead.t));
        ahead.tied = hn::Or(ahead.tied, hn::And(touched, meets));
        touched = hn::Or(touched, meets);
        const V on = hn::IfThenElse(out, hn::Add(own.most, all(1)), settled);
        ahead.place[a] = hn::MulAdd(on, own.stride, own.place);
        ahead.outside = hn::Or(ahead.outside, hn::And(out, hn::Eq(own.most, own.to_end)));
    }
    return ahead;
}

/// Returns those that come to a cell that is not empty.
inline LaneSet Flock::move(std::size_t first, LaneSet moved, const Ahead& ahead,
                           const Lattice& lattice, const CellWord* cells) {
    using namespace simd;
    constexpr auto tag = floats<width>;
    const Mask mask = mask_of(tag, static_cast<std::uint32_t>(moved >> first));
    auto cell = hn::Zero(numbers);
    for (std::size_t a = 3; a-- > 0;) {
        hn::BlendedStore(ahead.place[a], mask, tag, &axes_[a].place[first]);
        const V index = hn::Sub(ahead.place[a], upward(load(axes_[a].stride, first)));
        cell = hn::Add(hn::Mul(cell, hn::Set(numbers, lattice.cells()[a])),
                       hn::ConvertTo(numbers, index));
    }
    // Lanes that stay read the first cell.
    cell = hn::IfThenElseZero(hn::RebindMask(numbers, mask), cell);
    const auto found =
        hn::GatherIndex(words<width>, reinterpret_cast<const std::uint32_t*>(cells), cell);
    hn::BlendedStore(found, hn::RebindMask(words<width>, mask), words<width>, &word_[first]);
    hn::BlendedStore(ahead.t, mask, tag, &t_[first]);
    return moved & ~(LaneSet{bits(tag, hn::RebindMask(tag, is_empty(found)))} << first);
}

[[gnu::flatten]] inline Flock::Stepped Flock::step(std::size_t first, LaneSet walking,
                                                   const Lattice& lattice, const CellWord* cells) {
    using namespace simd;
    const Ahead ahead = look_ahead(first, lattice);
    const auto set = [&](Mask mask) {
        return (LaneSet{bits(floats<width>, mask)} << first) & walking;
    };
    const LaneSet hit_before = set(hn::Lt(load(nearest_, first), ahead.t));
    Stepped stepped;
    stepped.tied = set(ahead.tied) & ~hit_before;
    stepped.ended = hit_before | (set(ahead.outside) & ~stepped.tied);
    stepped.moved = walking & ~(stepped.ended | stepped.tied);
    if (stepped.moved != 0) stepped.arrived = move(first, stepped.moved, ahead, lattice, cells);
    return stepped;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

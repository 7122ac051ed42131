#include "accel/bsp/kd_builder.h"
#include "accel/bsp/kd_sub_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr std::size_t references_per_part = 4096;

/// A face of a reference's box, or both where they coincide. At one plane boxes that end come
/// before those that lie in it, these before those that start (Wald & Havran 2006).
struct Event {
    enum class Kind : std::uint32_t { end, planar, start };

    float plane;
    std::uint32_t tag;  ///< the kind, then the reference's place

    Event(float at, Kind kind, std::uint32_t place)
        : plane(at), tag(static_cast<std::uint32_t>(kind) << 30 | place) {}
    Kind kind() const { return static_cast<Kind>(tag >> 30); }
    std::uint32_t place() const { return tag & (most_references - 1); }
    Event moved_to(std::uint32_t new_place) const { return {plane, kind(), new_place}; }
    bool operator<(const Event& other) const {
        return plane != other.plane ? plane < other.plane : tag < other.tag;
    }

    static constexpr std::uint32_t most_references = 1u << 30;
};
using Events = std::array<std::vector<Event>, 3>;

/// The references of a cell, and their events on each axis, sorted.
struct Content {
    References references;
    Events events;

    void add_events(std::size_t axis, std::uint32_t place) {
        const Reference& reference = references[place];
        const float lo = reference.lo[axis], hi = -reference.minus_hi[axis];
        if (lo == hi) {
            events[axis].emplace_back(lo, Event::Kind::planar, place);
        } else {
            events[axis].emplace_back(lo, Event::Kind::start, place);
            events[axis].emplace_back(hi, Event::Kind::end, place);
        }
    }
};

/// One sweep over the events of an axis.
void sweep(KdSplit& best, const Sah& sah, const Box& cell, int axis,
           const std::vector<Event>& events, std::size_t references) {
    const KdChances chances(cell, axis);
    std::uint32_t left = 0, right = static_cast<std::uint32_t>(references);
    for (std::size_t i = 0; i < events.size();) {
        const float plane = events[i].plane;
        std::array<std::uint32_t, 3> count{};
        for (; i < events.size() && events[i].plane == plane; ++i)
            ++count[static_cast<std::size_t>(events[i].kind())];
        const auto [ends, planar, starts] = count;
        right -= ends + planar;
        if (cell.lo[axis] < plane && plane < cell.hi[axis]) {
            const float below = chances.left(plane), above = chances.right(plane);
            for (const bool planar_left : {true, false}) {
                if (!planar_left && planar == 0) continue;
                const std::uint32_t in_left = planar_left ? planar : 0;
                const KdSplit split{
                    split_cost(sah, below, left + in_left, above, right + planar - in_left), axis,
                    plane, planar_left};
                if (split.better_than(best)) best = split;
            }
        }
        left += planar + starts;
    }
}

/// The content of a cell's halves; references keep their order, so events stay sorted.
class Splicing {
public:
    Splicing(const KdParting& parting, const Box& box, const KdSplit& split, Content& content) {
        Box left_box = box, right_box = box;
        left_box.hi[split.axis] = right_box.lo[split.axis] = split.plane;
        places_.resize(content.references.size());
        for (std::size_t i = 0; i < content.references.size(); ++i) {
            const Reference& reference = content.references[i];
            const bool in_left = split.in_left(reference), in_right = split.in_right(reference);
            if (!in_right) places_[i] = add(reference, left, left_side);
            else if (!in_left) places_[i] = add(reference, right, right_side);
            else {
                places_[i] = straddling;
                add_clipped(parting.clipped(reference, left_box), reference.number, left, 0);
                add_clipped(parting.clipped(reference, right_box), reference.number, right, 1);
            }
        }
        for (std::size_t axis = 0; axis < 3; ++axis) splice(content.events[axis], axis);
    }

    Content left, right;

private:
    static constexpr std::uint32_t left_side = 0, right_side = 0x80000000, straddling = 0xffffffff;

    static std::uint32_t add(const Reference& reference, Content& to, std::uint32_t side) {
        to.references.push_back(reference);
        return side | static_cast<std::uint32_t>(to.references.size() - 1);
    }
    void add_clipped(const Box& inside, std::uint32_t number, Content& to, std::size_t side) {
        if (inside.empty()) return;
        clipped_[side].push_back(static_cast<std::uint32_t>(to.references.size()));
        to.references.emplace_back(inside, number);
    }

    /// Events of references on one side go there; of the others there are new ones.
    void splice(const std::vector<Event>& events, std::size_t axis) {
        const std::array<Content*, 2> sides{&left, &right};
        for (Content* side : sides) side->events[axis].reserve(2 * side->references.size());
        for (const Event& event : events) {
            const std::uint32_t place = places_[event.place()];
            if (place == straddling) continue;
            Content& side = *sides[place >> 31];
            side.events[axis].push_back(event.moved_to(place & ~right_side));
        }
        for (std::size_t i = 0; i < 2; ++i) {
            auto& all = sides[i]->events[axis];
            const auto old = static_cast<std::ptrdiff_t>(all.size());
            for (const std::uint32_t place : clipped_[i]) sides[i]->add_events(axis, place);
            std::sort(all.begin() + old, all.end());
            std::inplace_merge(all.begin(), all.begin() + old, all.end());
        }
    }

    std::vector<std::uint32_t> places_;  ///< of each reference: its side and new place
    std::array<std::vector<std::uint32_t>, 2> clipped_;
};

class Builder {
public:
    Builder(const Geometry& geometry, const Membership& membership, const KdSettings& settings)
        : parting_(geometry, membership, settings) {}

    std::unique_ptr<BspSketch> build(const KdCell& cell, Content content) const {
        auto sketch = std::make_unique<BspSketch>();
        KdSubTree small(parting_, *sketch);
        subdivide(*sketch, small, 0, cell, std::move(content));
        return sketch;
    }

private:
    KdSplit best_split(const KdCell& cell, const Content& content) const {
        const std::size_t size = content.references.size();
        if (!parting_.divisible(cell, size)) return {};
        KdSplit best;
        for (int axis = 0; axis < 3; ++axis)
            sweep(best, parting_.sah(), cell.box, axis,
                  content.events[static_cast<std::size_t>(axis)], size);
        return parting_.unless_leaf_is_better(best, size);
    }

    void subdivide(BspSketch& sketch, KdSubTree& small, std::uint32_t node, const KdCell& cell,
                   Content content) const {
        const std::size_t size = content.references.size();
        if (size <= KdParting::few) return small.build(node, cell, content.references);
        sketch.depth = std::max(sketch.depth, cell.depth);
        const KdSplit split = best_split(cell, content);
        if (split.cost == infinity) return make_leaf(sketch, node, content.references);
        Splicing both(parting_, cell.box, split, content);
        const std::size_t left = both.left.references.size(), right = both.right.references.size();
        if (left + right > cell.most_references) {
            sketch.bounded = true;
            return make_leaf(sketch, node, content.references);
        }
        content = {};
        const KdCell::Halves halves = cell.halves(split, left, right);
        const std::uint32_t children = sketch.divide(node, split.axis, split.plane);
        if (size <= references_per_part) {
            subdivide(sketch, small, children, halves.left, std::move(both.left));
            subdivide(sketch, small, children + 1, halves.right, std::move(both.right));
            return;
        }
        std::unique_ptr<BspSketch> left_part, right_part;
        tbb::parallel_invoke([&] { left_part = build(halves.left, std::move(both.left)); },
                             [&] { right_part = build(halves.right, std::move(both.right)); });
        sketch.make_part(children, std::move(left_part));
        sketch.make_part(children + 1, std::move(right_part));
    }

    static void make_leaf(BspSketch& sketch, std::uint32_t node, const References& references) {
        std::vector<std::uint32_t> numbers;
        for (const Reference& reference : references) numbers.push_back(reference.number);
        std::sort(numbers.begin(), numbers.end());
        sketch.make_leaf(node, numbers);
    }

    KdParting parting_;
};

Content all_events(References references) {
    if (references.size() > Event::most_references)
        throw std::length_error("more than 2^30 primitives: build=binned takes them");
    Content content{std::move(references), {}};
    tbb::parallel_for(std::size_t{0}, std::size_t{3}, [&](std::size_t axis) {
        content.events[axis].reserve(2 * content.references.size());
        for (std::uint32_t i = 0; i < content.references.size(); ++i) content.add_events(axis, i);
        tbb::parallel_sort(content.events[axis].begin(), content.events[axis].end());
    });
    return content;
}

}  // namespace

BspSketch build_by_events(const Geometry& geometry, const Membership& membership,
                          const KdSettings& settings) {
    return std::move(*Builder(geometry, membership, settings)
                          .build({membership.space(), 0, settings.most_references},
                                 all_events(all_references(geometry, membership))));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

#pragma once

#include "accel/bsp/bsp.h"

/// A stack of a few halts (Horn, Sugerman, Houston & Hanrahan 2007): what does not fit is found
/// again from the root. Where they go on from the end of the last cell, which cannot tell tied
/// cells apart, we follow a trail of one bit a level (Laine 2010), which can.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Which children have been dealt with on the way to the present node. A level's bit is set where
/// its near child is done, or where there is only one child to visit.
class Trail {
public:
    void set(int level) { bits_ |= bit(level); }
    bool near_done(int level) const { return (bits_ & bit(level)) != 0; }
    /// After a leaf on a level: on to the deepest far child that is left. False where none is.
    bool advance(int level) {
        if (level == 0) return false;
        const std::uint64_t step = bit(level - 1);
        bits_ += step;
        return bits_ >= step;  // else it has carried over the top
    }

private:
    static_assert(deepest_bsp <= 64);
    static std::uint64_t bit(int level) { return std::uint64_t{1} << (63 - level); }
    std::uint64_t bits_ = 0;
};

/// The last few halts: the oldest makes room.
class FewHalts {
public:
    struct Halt {
        BspHalt at;
        int level;
    };

    bool empty() const { return size_ == 0; }
    void push(const BspHalt& halt, int level) {
        if (size_ == most) first_ = (first_ + 1) % most;
        else ++size_;
        halts_[(first_ + size_ - 1) % most] = {halt, level};
    }
    Halt pop() { return halts_[(first_ + --size_) % most]; }

private:
    static constexpr std::size_t most = 3;  // Horn et al. 2007
    std::array<Halt, most> halts_;
    std::size_t first_ = 0, size_ = 0;
};

template <Query Q, Counter C>
inline void Bsp::trace_with_short_stack(BspFlight& flight, C& count) const {
    const FewHalts::Halt whole{{flight.node, flight.entry, flight.exit}, 0};
    FewHalts halts;
    Trail trail;
    for (int level = 0; flight.entry <= flight.hit.t;) {
        BspNode node = tree_.nodes[flight.node];
        for (; !node.is_leaf(); ++level) {
            count(Event::step);
            const std::uint32_t axis = node.axis();
            const BspCrossing plane((node.plane() - flight.origin[axis]) * flight.inverse[axis],
                                    flight.entry, flight.exit);
            const std::uint32_t near = node.children() + flight.near_side[axis], far = near ^ 1;
            const bool both = plane.near && plane.far, to_far = both && trail.near_done(level);
            if (!both) trail.set(level);
            else if (to_far) flight.entry = plane.far_entry(flight.entry);
            else {
                halts.push({far, plane.far_entry(flight.entry), flight.exit}, level + 1);
                flight.exit = plane.near_exit(flight.exit);
            }
            node = tree_.nodes[plane.near && !to_far ? near : far];
        }
        if (flight.entry > flight.hit.t) return;
        visit_leaf<Q>(flight, node, count);
        if (flight.over<Q>() || !trail.advance(level)) return;
        const FewHalts::Halt next = halts.empty() ? whole : halts.pop();
        flight.node = next.at.node;
        flight.entry = next.at.entry;
        flight.exit = next.at.exit;
        level = next.level;
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

#pragma once

#include "accel/bsp/descend.h"
#include "accel/bsp/fleet.h"
#include "accel/bsp/layout.h"
#include "accel/bsp/outlines.h"
#include "accel/bsp/ropes.h"
#include "accel/bsp/walk.h"
#include "accel/core/structure.h"
#include "accel/simd/in_packets.h"
#include "accel/simd/packet_leaf.h"
#include "accel/space/membership.h"

/// Binary space partitioning: Kaplan's tree and the kd-tree. Coherent rays go together as packets;
/// of the others many are in flight. See README.md.
namespace rayshoot::inline RAYSHOOT_ISA {

class Bsp {
public:
    static constexpr std::string_view name = "bsp";
    static constexpr std::string_view summary =
        "binary space partitioning: SAH kd-tree or Kaplan's, packets, rays in flight";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::size_t most_flights = 64;
    static constexpr std::array options{
        OptionInfo{"build", "sah|binned|midpoint", "binned",
                   "cells are divided by SAH, the same over bins first, or in the middle"},
        OptionInfo{"depth", "0 to 60", "0", "most levels; 0: as many as the build likes"},
        OptionInfo{"leaf", "0 to 64", "0",
                   "no cell with so few primitives is divided; 0: likewise"},
        OptionInfo{"overlap", "auto|bounds|exact", "auto",
                   "primitives in a cell: by stored bounds, by the part inside, or what pays"},
        OptionInfo{"traversal", "stack|short_stack|ropes", "stack",
                   "how a ray finds the next cell; all but stack: each ray goes alone"},
        OptionInfo{"packets", "on|off", "on", "coherent rays go together, up to 64"},
        OptionInfo{"flight", "1 to 64", "32", "incoherent rays on their way at once"}};
    static constexpr std::array<std::string_view, 10> configurations{
        "bsp:traversal=short_stack",
        "bsp:traversal=ropes",
        "bsp:build=sah,traversal=ropes,overlap=exact",
        "bsp",
        "bsp:build=sah",
        "bsp:build=sah,overlap=exact,flight=5",
        "bsp:overlap=exact",
        "bsp:overlap=bounds,packets=off,flight=1",
        "bsp:build=midpoint,packets=off,flight=1",
        "bsp:build=midpoint,overlap=exact"};

    struct Scratch {
        BspFlight alone;
        std::vector<Fleet> fleets = std::vector<Fleet>(most_flights / Fleet::lanes);
        Packet packet;
        BspWalk walk;

        std::size_t bytes() const { return sizeof(*this) + fleets.size() * sizeof(Fleet); }
    };

    Bsp(const BuildInput& input, const Options& chosen);

    template <Query Q, Counter C>
    void many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch, C& count) const;
    Footprint footprint() const { return tree_.footprint; }

private:
    enum class Traversal : std::uint8_t { stack, short_stack, ropes };

    template <Query Q, Counter C>
    void trace_each(const BatchPart& part, Answers<Q>& answers, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    void trace_alone(BspFlight& flight, C& count) const;
    template <Query Q, Counter C>
    void trace_with_short_stack(BspFlight& flight, C& count) const;
    template <Query Q, Counter C>
    bool trace_along_ropes(BspFlight& flight, C& count) const;
    template <Counter C>
    std::uint32_t leaf_at(const BspFlight& flight, std::uint32_t number, float t, C& count) const;
    template <Query Q, Counter C>
    void trace_from_afar(BspFlight& flight, float t_min, C& count) const;
    template <Query Q, Counter C>
    void trace_in_flight(const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                         C& count) const;
    template <Query Q, Counter C>
    void trace_together(const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                        C& count) const;

    bool from_afar(std::span<const Ray> rays) const;
    template <Query Q, Counter C>
    void visit_leaf(BspFlight& flight, BspNode leaf, C& count) const;
    template <Query Q, Counter C>
    void visit_leaf(Packet& packet, RaySet rays, BspNode leaf, C& count) const;
    template <Counter C>
    void count_steps(const Fleet& fleet, C& count) const;
    template <Query Q, Counter C>
    void visit_leaves(Fleet& fleet, FleetLanes lanes, FleetLanes& over, C& count) const;
    template <Query Q, class Block, Counter C>
    void visit_blocks(Fleet& fleet, FleetLanes& at_block, FleetLanes& over, C& count) const;
    template <Query Q, Counter C>
    void visit_mixed(Fleet& fleet, FleetLanes& over, C& count) const;
    template <Query Q>
    void leave(Fleet& fleet, std::size_t lane, FleetLanes& over) const;
    // Inlined in any case: g++ 12 takes a function that does nothing but this for one without an
    // effect, and drops its calls.
    [[gnu::always_inline]] void fetch(std::uint32_t node) const {
        __builtin_prefetch(&tree_.nodes[node]);
    }
    [[gnu::always_inline]] void fetch(PackedLeaf leaf) const {
        const std::byte* const block = tree_.leaves.first() + PackedLeaves::offset(leaf);
        for (std::size_t i = 0; i < sizeof(LeafBlock); i += 64) __builtin_prefetch(block + i);
    }
    /// Where a node is at hand: what will be needed after it.
    [[gnu::always_inline]] void fetch_beyond(std::uint32_t number) const {
        const BspNode node = tree_.nodes[number];
        if (!node.is_leaf()) fetch(node.children());
        else if (!node.is_empty()) fetch(node.leaf());
    }

    Membership membership_;
    Box space_;
    BspTree tree_;
    Outlines outlines_;  ///< of nothing where cells are good for every ray
    std::vector<RopedLeaf> ropes_;
    Traversal traversal_ = Traversal::stack;
    bool packets_ = true;
    float most_apart_ = 0;    ///< along an axis, origins of the rays of a packet
    std::size_t fleets_ = 0;  ///< none: rays go alone
};

template <Query Q, Counter C>
inline void Bsp::many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch,
                      C& count) const {
    const auto each = [&](const BatchPart& part) { trace_each<Q>(part, answers, scratch, count); };
    if (!packets_) return each({batch.rays});
    in_packets(
        batch.rays,
        [&](std::span<const Ray> rays) {
            return scratch.packet.load(rays, tree_.leaves.precision(), most_apart_) &&
                   !from_afar(rays);
        },
        [&](const BatchPart& part) { trace_together<Q>(part, answers, scratch, count); }, each);
}

/// Whether any of the rays begins so far away that its hits may be reported outside its cells.
inline bool Bsp::from_afar(std::span<const Ray> rays) const {
    if (membership_.overlap() != Overlap::exact) return false;
    bool made_for_all = true;
    for (const Ray& ray : rays) made_for_all &= membership_.made_for(ray);
    return !made_for_all;
}

template <Query Q, Counter C>
inline void Bsp::trace_each(const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                            C& count) const {
    if (part.rays.empty()) return;
    const bool afar = from_afar(part.rays);
    if (fleets_ > 0 && !afar) return trace_in_flight<Q>(part, answers, scratch, count);
    BspFlight& flight = scratch.alone;
    for (std::size_t i = 0; i < part.rays.size(); ++i) {
        flight.start(part.rays[i], i, tree_.leaves.precision(), space_);
        if (afar && !membership_.made_for(part.rays[i]))
            trace_from_afar<Q>(flight, part.rays[i].t_min, count);
        else if (traversal_ == Traversal::short_stack) trace_with_short_stack<Q>(flight, count);
        else if (traversal_ == Traversal::stack || !trace_along_ropes<Q>(flight, count))
            trace_alone<Q>(flight, count);
        answers.store(part.first + i, flight.hit);
    }
}

template <Query Q, Counter C>
inline void Bsp::visit_leaf(BspFlight& flight, BspNode leaf, C& count) const {
    rayshoot::visit_leaf<Q>(tree_.leaves, flight, leaf, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

#include "accel/bsp/alone.h"
#include "accel/bsp/along_ropes.h"
#include "accel/bsp/in_flight.h"
#include "accel/bsp/short_stack.h"
#include "accel/bsp/together.h"

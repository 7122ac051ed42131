#pragma once

#include "accel/bvh/builders.h"
#include "accel/bvh8/group_walk.h"
#include "accel/bvh8/halts.h"
#include "accel/bvh8/layout.h"
#include "accel/core/raw_array.h"
#include "accel/core/structure.h"
#include "accel/simd/in_packets.h"
#include "accel/simd/packet_leaf.h"

/// Bounding-volume hierarchy with several children a node, tested at once. Coherent rays go
/// together as packets; of the others many are in flight, so that one ray's wait for memory is the
/// others' time. See README.md.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Departures;

/// The tree over any type of WideNode; a structure of the catalogue gives it a name.
template <class Node>
class WideBvh {
public:
    using Flight = rayshoot::Flight<Node>;
    using Halts = rayshoot::Halts<Node::width>;

    static constexpr bool complete = true, remembers = false;
    static constexpr std::array options{
        build_option, OptionInfo{"leaf", "1 to 32", "4", "most primitives in a leaf"},
        OptionInfo{"bins", "2 to 256", "16", "bins per axis that a split is chosen from"},
        OptionInfo{"packets", "on|off", "on", "coherent rays go together, up to 64"},
        OptionInfo{"flight", "1 to 64", "16", "incoherent rays on their way at once"}};
    static constexpr std::size_t most_flights = 64;
    /// Nodes below the root that the beam round a packet meets before its groups go on by
    /// themselves.
    static constexpr int wide_steps = 24;

    struct Scratch {
        std::vector<Flight> flights = std::vector<Flight>(most_flights);
        Packet packet;
        Halts halts;
        GroupWalk walk;

        std::size_t bytes() const { return sizeof(*this) + flights.size() * sizeof(Flight); }
    };

    WideBvh(const BuildInput& input, const Options& chosen);
    /// Any tree of such nodes, whoever made it. `in_flight`: 1 to most_flights.
    WideBvh(const Geometry& geometry, WideTree<Node>&& tree, bool packets, int in_flight);

    template <Query Q, Counter C>
    void many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch, C& count) const;
    /// The same for some of a batch.
    template <Query Q, Counter C>
    void many(const BatchPart& some, Answers<Q>& answers, Scratch& scratch, C& count) const;
    TestRay prepared(const Ray& ray) const { return leaves_.prepared(ray); }
    /// Tests one ray against all leaves of a node, whether it meets their boxes or not. True: the
    /// question is answered.
    template <Query Q, Counter C>
    bool test_leaves(std::uint32_t node, const TestRay& ray, Hit& hit, C& count) const;
    Footprint footprint() const { return footprint_; }

private:
    using Part = BatchPart;

    template <Query Q, Counter C>
    void trace_each(const Part& part, Answers<Q>& answers, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    void trace_alone(Flight& flight, C& count) const;
    template <Query Q, Counter C>
    void trace_in_flight(const Part& part, Answers<Q>& answers, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    void trace_together(const Part& part, Answers<Q>& answers, Scratch& scratch, Company& company,
                        C& count) const;
    template <Query Q, Counter C>
    bool follow(Packet& packet, Halts& halts, C& count) const;
    template <Query Q, Counter C>
    void follow(Packet& packet, std::size_t group, GroupWalk& walk, Company& company,
                C& count) const;
    template <Counter C>
    void admit(const Packet& packet, std::size_t group, RaySet among, const Node& parent,
               std::size_t place, float entry, GroupWalk& walk, C& count) const;
    template <Counter C>
    void set_out(const Packet& packet, std::size_t group, Scratch& scratch, C& count) const;
    template <Counter C>
    std::pair<Places<Node::width>, simd::Floats<Node::width>> step(const Beam& beam,
                                                                   const Node& node,
                                                                   C& count) const;

    struct Children;
    template <Counter C>
    Children meet(const Flight& flight, const Node& node, C& count) const;
    template <Counter C>
    void cross(Flight& flight, C& count) const;
    template <Query Q, Counter C>
    void visit_leaf(Flight& flight, C& count) const;
    template <Query Q, class Block, Counter C>
    void visit_blocks(std::uint64_t& waiting, Departures& departures, Flight* flights,
                      C& count) const;
    void fetch(WideChild child) const;
    const Node& node_at(WideChild child) const { return nodes_[child.number()]; }

    RawArray<Node> nodes_;
    PackedLeaves leaves_;
    std::array<const std::byte*, 2> firsts_;  ///< where the nodes and the leaves begin
    bool packets_ = true;
    float most_apart_ = 0;  ///< along an axis, origins of the rays of a packet
    std::size_t in_flight_ = 1;
    Footprint footprint_;
};

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch,
                                C& count) const {
    many<Q>(BatchPart{batch.rays}, answers, scratch, count);
}

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::many(const BatchPart& some, Answers<Q>& answers, Scratch& scratch,
                                C& count) const {
    const auto each = [&](const Part& part) { trace_each<Q>(part, answers, scratch, count); };
    if (!packets_) return each(some);
    const auto of_batch = [&](const Part& part) {
        return Part{part.rays, some.first + part.first};
    };
    Company company;
    in_packets(
        some.rays,
        [&](std::span<const Ray> rays) {
            return company.pays<Q>() && scratch.packet.load(rays, leaves_.precision(), most_apart_);
        },
        [&](const Part& part) {
            trace_together<Q>(of_batch(part), answers, scratch, company, count);
        },
        [&](const Part& part) { each(of_batch(part)); });
}

template <class Node>
template <Query Q, Counter C>
inline bool WideBvh<Node>::test_leaves(std::uint32_t node, const TestRay& ray, Hit& hit,
                                       C& count) const {
    for (std::size_t i = 0; i < nodes_[node].live(); ++i) {
        const WideChild child = WideChild::from(nodes_[node].children[i]);
        if (child.interior()) continue;
        count(Event::cell);
        leaves_.template test<Q>(child.leaf(), ray, hit, count);
        if (Q == Query::occluded && hit.primitive != no_primitive) return true;
    }
    return false;
}

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::trace_each(const Part& part, Answers<Q>& answers, Scratch& scratch,
                                      C& count) const {
    if (in_flight_ > 1) return trace_in_flight<Q>(part, answers, scratch, count);
    Flight& flight = scratch.flights.front();
    for (std::size_t i = 0; i < part.rays.size(); ++i) {
        flight.start(part.rays[i], i, leaves_.precision());
        trace_alone<Q>(flight, count);
        answers.store(part.first + i, flight.hit);
    }
}

/// Asks for the memory of a child before its turn comes. Which kind it is cannot be foretold, so
/// the place of either is computed. Inlined in any case: g++ 12 takes a function that does nothing
/// but this for one without an effect, and drops its calls.
template <class Node>
[[gnu::always_inline]] inline void WideBvh<Node>::fetch(WideChild child) const {
    const std::size_t node = std::size_t{child.number()} * sizeof(Node);
    const std::size_t block = PackedLeaves::offset(child.leaf());
    const std::byte* const first =
        firsts_[child.interior() ? 0 : 1] + simd::select(child.interior(), node, block);
    for (std::size_t i = 0; i < std::max(sizeof(Node), sizeof(LeafBlock)); i += 64)
        __builtin_prefetch(first + i);
}

/// The children of a node that a ray meets, and where it enters them.
template <class Node>
struct WideBvh<Node>::Children {
    using V = simd::Floats<Node::width>;
    V entry;
    Places<Node::width> met;
    std::uint32_t places;  ///< the same, a bit each
};

/// clip() of box.h for all boxes at once.
template <class Node>
template <Counter C>
inline auto WideBvh<Node>::meet(const Flight& flight, const Node& node, C& count) const
    -> Children {
    using namespace simd;
    constexpr auto tag = floats<Node::width>;
    count(Event::step);
    if constexpr (C::counts) count(Event::bounding_volume_test, node.live());
    auto entry = hn::Set(tag, flight.ray.t_min), exit = limit(node.bounds, flight.hit.t);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Both factors negated: the same product, and the planes can stay in memory.
        const auto origin = hn::Set(tag, flight.origin[static_cast<int>(axis)]);
        const auto towards = hn::Set(tag, flight.towards[static_cast<int>(axis)]);
        const auto near = row(node.bounds, axis, flight.near[axis]);
        const auto far = row(node.bounds, axis, flight.far[axis]);
        entry = larger(hn::Mul(hn::Sub(origin, near), towards), entry);
        exit = smaller(hn::Mul(hn::Sub(origin, far), towards), exit);
    }
    const auto met = hn::Le(entry, exit);
    return {entry, met, bits(tag, met)};
}

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::visit_leaf(Flight& flight, C& count) const {
    count(Event::cell);
    leaves_.template test<Q>(flight.next.leaf(), flight.ray, flight.hit, count);
}

struct Bvh8 : WideBvh<WideNode8> {
    using WideBvh::WideBvh;
    static constexpr std::string_view name = "bvh8";
    static constexpr std::string_view summary =
        "bounding-volume hierarchy: binned SAH, 8-wide, SIMD leaves, packets, rays in flight";
    static constexpr std::array<std::string_view, 6> configurations{"bvh8",
                                                                    "bvh8:build=fast",
                                                                    "bvh8:build=high",
                                                                    "bvh8:packets=off,flight=1",
                                                                    "bvh8:packets=off,flight=16",
                                                                    "bvh8:leaf=32,bins=4"};
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

#include "accel/bvh8/alone.h"
#include "accel/bvh8/in_flight.h"
#include "accel/bvh8/together.h"

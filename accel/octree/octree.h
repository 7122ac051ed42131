#pragma once

#include "accel/bvh8/bvh8.h"
#include "accel/octree/glassner84.h"
#include "accel/octree/linear_octree.h"
#include "accel/octree/nodes.h"
#include "accel/octree/parametric.h"
#include "accel/octree/recursive93.h"
#include "accel/octree/samet89.h"
#include "accel/octree/wide.h"

#include <optional>

/// Octree (Glassner 1984): space is cut into eight cells, those that hold too much again, and a ray
/// visits the leaves that it passes through in their order. See README.md.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class OctreeTraversal : std::uint8_t {
    wide,  ///< all eight children at once
    glassner84,
    samet89,
    recursive93,
    parametric
};

class Octree {
public:
    static constexpr std::string_view name = "octree";
    static constexpr std::string_view summary =
        "octree: five traversals, centre or SAH planes, nodes or a Morton list, SIMD leaves";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::array options{
        OptionInfo{"traversal", "wide|glassner84|samet89|recursive93|parametric", "wide",
                   "how a ray finds the leaves it passes through"},
        OptionInfo{"planes", "centre|sah", "centre", "where a cell is cut"},
        OptionInfo{"overlap", "auto|bounds|exact|havran|loose", "auto",
                   "which primitives a cell holds; auto: loose if wide, else bounds"},
        OptionInfo{"storage", "nodes|linear", "nodes", "nodes, or a sorted list of leaves"},
        OptionInfo{"leaves", "packed|single", "packed",
                   "objects are tested side by side or singly"},
        OptionInfo{"leaf", "1 to 64", "4", "most primitives in a leaf, if it can be cut"},
        OptionInfo{"depth", "0 to 20", "20", "of the deepest leaf; the root's is 0"},
        OptionInfo{"stop", "count|cost", "cost", "cut by the leaf size alone, or by expected cost"},
        OptionInfo{"from", "t_min|origin", "t_min",
                   "where along the ray the first leaf is visited"},
        OptionInfo{"bound", "1 to 100000", "16", "most references for each primitive"},
        OptionInfo{"packets", "on|off", "on", "wide: coherent rays go together, up to 64"},
        OptionInfo{"flight", "1 to 64", "16", "wide: incoherent rays on their way at once"}};
    // Bounded, so that scenes with everything in every cell do not take minutes.
    static constexpr std::array<std::string_view, 14> configurations{
        "octree",
        "octree:packets=off,flight=1",
        "octree:overlap=bounds",
        "octree:overlap=exact",
        "octree:planes=sah",
        "octree:traversal=parametric,overlap=exact",
        "octree:traversal=parametric,storage=linear,depth=12",
        "octree:traversal=glassner84,storage=linear,leaf=8,depth=9",
        "octree:traversal=samet89,planes=sah,overlap=exact",
        "octree:traversal=glassner84,overlap=havran,leaves=single,leaf=1,depth=4,stop=count,"
        "bound=8",
        "octree:traversal=samet89,overlap=havran,leaves=single,leaf=1,depth=4,stop=count,"
        "bound=8",
        "octree:traversal=recursive93,overlap=havran,leaves=single,leaf=1,depth=4,stop=count,"
        "bound=8",
        "octree:traversal=glassner84,planes=sah,overlap=havran,leaves=single,leaf=1,depth=4,"
        "stop=count,bound=8",
        "octree:traversal=recursive93,planes=sah,overlap=havran,leaves=single,leaf=1,depth=4,"
        "stop=count,bound=8"};
    using Wide = WideBvh<WideNode8>;

    struct Scratch {
        Wide::Scratch wide;
        std::size_t bytes() const { return wide.bytes(); }
    };

    Octree(const BuildInput& input, const Options& chosen);

    template <Query Q, Counter C>
    void many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch, C& count) const;
    Footprint footprint() const { return footprint_; }

private:
    template <Query Q, Counter C>
    void trace_each(const BatchPart& part, Answers<Q>& answers, Scratch& scratch, C& count) const;
    template <Query Q, Counter C, class Cells>
    void trace(const Cells& cells, const Ray& from, Hit& hit, C& count) const;
    template <Query Q, Counter C>
    void trace_from_afar(const Ray& from, Hit& hit, C& count) const;
    /// Take the members of the cells over.
    void keep_wide(const Geometry& geometry, WideOctree&& octree, const Options& chosen);
    void keep_cells(const Geometry& geometry, OctreeCell& root, const Options& chosen);

    OctreeTraversal traversal_;
    bool from_origin_ = false;  ///< rays enter cells from their origin on, not from t_min
    Box space_;
    std::optional<Membership> exact_;  ///< where cells are not made for every ray
    OutlinedRuns outlines_;            ///< for those: of nodes if wide, else of leaves
    std::optional<Wide> wide_;
    std::optional<OctreeNodes> nodes_;
    std::optional<LinearOctree> list_;
    OctreeLeaves leaves_;
    Footprint footprint_;
};

template <Query Q, Counter C, class Cells>
inline void Octree::trace(const Cells& cells, const Ray& from, Hit& hit, C& count) const {
    const TestRay ray = leaves_.prepared(from);
    const OctreeQuestion<Cells, Q, C> ask{
        cells,
        leaves_,
        ray,
        clip(ray, space_, {from_origin_ ? std::min(0.0f, from.t_min) : from.t_min, infinity}),
        hit,
        count};
    if (ask.within.empty() || !ask.reaches(ask.within.entry)) return;
    switch (traversal_) {
        case OctreeTraversal::glassner84:
            return glassner84(ask);
        case OctreeTraversal::samet89:
            return samet89(ask);
        case OctreeTraversal::recursive93:
            return void(recursive93(ask, cells.root(), ask.within));
        case OctreeTraversal::parametric:
        case OctreeTraversal::wide:
            return void(parametric(ask, cells.root(), ask.within));
    }
}

/// Rays that cells are made for, as far as they follow each other; and the others one by one.
template <Query Q, Counter C>
inline void Octree::many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch,
                         C& count) const {
    if (!exact_) return trace_each<Q>(BatchPart{batch.rays}, answers, scratch, count);
    std::size_t waiting = 0;
    const auto go = [&](std::size_t end) {
        if (waiting < end)
            trace_each<Q>(BatchPart{batch.rays.subspan(waiting, end - waiting), waiting}, answers,
                          scratch, count);
        waiting = end;
    };
    for (std::size_t i = 0; i < batch.rays.size(); ++i) {
        if (exact_->made_for(batch.rays[i])) [[likely]]
            continue;
        go(i);
        Hit hit = nothing_yet(batch.rays[i]);
        trace_from_afar<Q>(batch.rays[i], hit, count);
        answers.store(i, hit);
        waiting = i + 1;
    }
    go(batch.rays.size());
}

template <Query Q, Counter C>
inline void Octree::trace_each(const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                               C& count) const {
    if (wide_) return wide_->template many<Q>(part, answers, scratch.wide, count);
    for (std::size_t i = 0; i < part.rays.size(); ++i) {
        Hit hit = nothing_yet(part.rays[i]);
        if (nodes_) trace<Q>(*nodes_, part.rays[i], hit, count);
        else trace<Q>(*list_, part.rays[i], hit, count);
        answers.store(part.first + i, hit);
    }
}

template <Query Q, Counter C>
inline void Octree::trace_from_afar(const Ray& from, Hit& hit, C& count) const {
    const TestRay ray = wide_ ? wide_->prepared(from) : leaves_.prepared(from);
    const auto visit = [&](std::uint32_t place) {
        if (wide_) return wide_->template test_leaves<Q>(place, ray, hit, count);
        count(Event::cell);
        leaves_.template test<Q>(place, ray, hit, count);
        return Q == Query::occluded && hit.primitive != no_primitive;
    };
    outlines_.each(ray, from.t_min, hit, visit, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

#pragma once

#include "accel/bvh8/bvh8.h"
#include "accel/octree/far_rays.h"
#include "accel/octree/glassner84.h"
#include "accel/octree/linear_octree.h"
#include "accel/octree/nodes.h"
#include "accel/octree/parametric.h"
#include "accel/octree/recursive93.h"
#include "accel/octree/samet89.h"

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
        "bound=100000",
        "octree:traversal=samet89,overlap=havran,leaves=single,leaf=1,depth=4,stop=count,"
        "bound=100000",
        "octree:traversal=recursive93,overlap=havran,leaves=single,leaf=1,depth=4,stop=count,"
        "bound=100000",
        "octree:traversal=glassner84,planes=sah,overlap=havran,leaves=single,leaf=1,depth=4,"
        "stop=count,bound=100000",
        "octree:traversal=recursive93,planes=sah,overlap=havran,leaves=single,leaf=1,depth=4,"
        "stop=count,bound=100000"};
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
    template <Query Q, Counter C, class Cells>
    void trace(const Cells& cells, const Ray& from, Hit& hit, C& count) const;
    bool any_far(std::span<const Ray> rays) const;
    /// Take the members of the cells over.
    void keep_wide(const Geometry& geometry, WideTree<WideNode8>&& tree, const Options& chosen);
    void keep_cells(const Geometry& geometry, OctreeCell& root, const Options& chosen);

    OctreeTraversal traversal_;
    bool from_origin_ = false;  ///< rays enter cells from their origin on, not from t_min
    Box space_;
    std::optional<Membership> exact_;  ///< where hits of far rays can lie outside their cells
    std::optional<Wide> wide_;
    std::optional<OctreeNodes> nodes_;
    std::optional<LinearOctree> list_;
    OctreeLeaves leaves_;
    Footprint footprint_;
};

template <Query Q, Counter C, class Cells>
inline void Octree::trace(const Cells& cells, const Ray& from, Hit& hit, C& count) const {
    const TestRay ray = leaves_.prepared(from);
    const float extra = exact_ ? exact_->extra(from) : 0;
    const OctreeQuestion<Cells, Q, C> ask{
        cells,
        leaves_,
        ray,
        clip(ray, space_, {from_origin_ ? std::min(0.0f, from.t_min) : from.t_min, infinity}),
        hit,
        count};
    if (extra > 0) return void(visit_grown(ask, cells.root(), space_, extra));
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

template <Query Q, Counter C>
inline void Octree::many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch,
                         C& count) const {
    if (wide_ && !any_far(batch.rays))
        return wide_->template many<Q>(batch, answers, scratch.wide, count);
    for (std::size_t i = 0; i < batch.rays.size(); ++i) {
        const Ray& ray = batch.rays[i];
        Hit hit = nothing_yet(ray);
        if (wide_) wide_->trace_grown<Q>(ray, exact_->extra(ray), hit, count);
        else if (nodes_) trace<Q>(*nodes_, ray, hit, count);
        else trace<Q>(*list_, ray, hit, count);
        answers.store(i, hit);
    }
}

inline bool Octree::any_far(std::span<const Ray> rays) const {
    return exact_ && std::any_of(rays.begin(), rays.end(),
                                 [&](const Ray& ray) { return exact_->extra(ray) > 0; });
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

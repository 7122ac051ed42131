#pragma once

#include "accel/bsp/layout.h"

/// Boxes around sub-trees, for the rays that the cells of a tree were not made for.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Where cells hold only what is near the part of a primitive inside them, a ray from far away can
/// be reported to hit a primitive elsewhere. But always within the primitive's stored bounds, so a
/// hierarchy of these loses none.
class Outlines {
public:
    /// A sub-tree with no more references has one box.
    static constexpr std::uint64_t references_per_box = 256;

    Outlines() = default;
    Outlines(const Geometry& geometry, const BspSketch& sketch, const BspTree& tree);

    /// visit(node) for the roots of sub-trees whose boxes the ray meets before `hit`, until it is
    /// true.
    template <class Visit, Counter C>
    void each(const SlabRay& ray, float t_min, const Hit& hit, const Visit& visit, C& count) const;
    /// visit(leaf) for all leaves of these sub-trees.
    template <class Visit, Counter C>
    void each_leaf(const BspTree& tree, const SlabRay& ray, float t_min, const Hit& hit,
                   const Visit& visit, C& count) const;
    std::size_t bytes() const { return pairs_.size() * sizeof(Pair); }

private:
    static constexpr std::uint32_t pair_bit = 0x80000000;
    struct Child {
        Box box;
        std::uint32_t place = 0;  ///< of a node of the tree, or a pair
    };
    using Pair = std::array<Child, 2>;
    class Maker;

    Child root_;
    std::vector<Pair> pairs_;
};

template <class Visit, Counter C>
inline void Outlines::each(const SlabRay& ray, float t_min, const Hit& hit, const Visit& visit,
                           C& count) const {
    std::array<const Child*, deepest_bsp + 2> later;
    std::size_t size = 0;
    later[size++] = &root_;
    while (size > 0) {
        const Child& child = *later[--size];
        count(Event::bounding_volume_test);
        if (clip(ray, child.box, {t_min, hit.t}).empty()) continue;
        if ((child.place & pair_bit) == 0) {
            if (visit(child.place)) return;
            continue;
        }
        for (const Child& next : pairs_[child.place & ~pair_bit]) later[size++] = &next;
    }
}

template <class Visit, Counter C>
inline void Outlines::each_leaf(const BspTree& tree, const SlabRay& ray, float t_min,
                                const Hit& hit, const Visit& visit, C& count) const {
    const auto visit_all = [&](std::uint32_t root) {
        std::array<std::uint32_t, deepest_bsp + 2> later;
        std::size_t size = 0;
        later[size++] = root;
        while (size > 0) {
            const BspNode node = tree.nodes[later[--size]];
            if (node.is_leaf()) {
                if (visit(node)) return true;
                continue;
            }
            count(Event::step);
            later[size++] = node.children() + 1;
            later[size++] = node.children();
        }
        return false;
    };
    each(ray, t_min, hit, visit_all, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

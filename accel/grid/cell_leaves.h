#pragma once

#include "accel/grid/grid_tree.h"
#include "accel/simd/packed_leaves.h"

/// The leaves of a grid: blocks that are tested at once, or objects one after the other.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class LeafKind : std::uint8_t { packed, single };

/// Which objects a ray has been tested against (Arnaldi, Priol & Bouatouch 1987), the last one of
/// each of a few classes: one that is forgotten is tested again.
class Mailbox {
public:
    void forget() { last_.fill(no_primitive); }
    /// Whether it was there, and from now on it is.
    bool seen(std::uint32_t primitive) {
        std::uint32_t& last = last_[primitive % last_.size()];
        const bool was_there = last == primitive;
        last = primitive;
        return was_there;
    }

private:
    std::array<std::uint32_t, 64> last_;
};

class CellLeaves {
public:
    CellLeaves() = default;
    /// Gives every leaf of the tree the word by which test() knows it.
    CellLeaves(const Geometry& geometry, LeafKind kind, bool mailbox, GridTree& tree);

    TestRay prepared(const Ray& ray) const {
        return kind_ == LeafKind::packed ? packed_.prepared(ray) : single_.prepared(ray);
    }
    template <Query Q, Counter C>
    void test(CellWord leaf, const TestRay& ray, Hit& hit, Mailbox& mailbox, C& count) const;

    bool uses_mailbox() const { return mailbox_; }
    const PackedLeaves& packed() const { return packed_; }
    std::size_t bytes() const;

private:
    void pack(const Geometry& geometry, GridTree& tree);
    bool pack_at_once(const Geometry& geometry, GridTree& tree);

    LeafKind kind_ = LeafKind::packed;
    bool mailbox_ = false;
    PackedLeaves packed_;
    Leaves single_;
    std::vector<LeafRange> ranges_;       ///< of single_, by number
    std::vector<std::uint32_t> members_;  ///< with a mailbox: what is in each slot of single_
};

template <Query Q, Counter C>
inline void CellLeaves::test(CellWord leaf, const TestRay& ray, Hit& hit, Mailbox& mailbox,
                             C& count) const {
    if (kind_ == LeafKind::packed)
        return packed_.template test<Q>(PackedLeaf::from(leaf.leaf()), ray, hit, count);
    const LeafRange range = ranges_[leaf.leaf()];
    if (!mailbox_) return single_.template test<Q>(range, ray, hit, count);
    for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot) {
        if (mailbox.seen(members_[slot])) {
            count(Event::mailbox_skip);
            continue;
        }
        single_.template test<Q>({slot, 1}, ray, hit, count);
        if (Q == Query::occluded && hit.primitive != no_primitive) return;
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

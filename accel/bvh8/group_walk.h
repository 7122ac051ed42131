#pragma once

#include "accel/bvh8/flight.h"
#include "accel/simd/packet.h"

/// What a group of a packet's rays has still to visit, and which of them.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A child that some of a group's rays enter.
struct GroupHalt {
    WideChild child;
    RaySet rays;
    float entry;  ///< of the group's beam
};

/// A stack of them.
class GroupWalk {
public:
    void clear() { size_ = 0; }
    bool empty() const { return size_ == 0; }
    GroupHalt pop() {
        --size_;
        return {WideChild::from(children_[size_]), rays_[size_], entries_[size_]};
    }
    /// Takes in a child if any ray enters it. Without a branch: how many do cannot be foretold.
    void admit(WideChild child, RaySet rays, float entry) {
        children_[size_] = child.bits();
        rays_[size_] = static_cast<std::uint32_t>(rays);
        entries_[size_] = entry;
        size_ += rays != 0;
    }

private:
    /// Those that the packet's beam had still to visit, and all but one more on each level.
    static constexpr std::size_t most = 2 * ((most_children - 1) * Stack::deepest + most_children);

    std::array<std::uint32_t, most> children_, rays_;
    std::array<float, most> entries_;
    std::size_t size_ = 0;
};

/// How many rays of a group visit a node together, on average over a batch so far. Rays of a batch
/// go much the same way, and what they see is much alike: so this foretells the next packet's.
class Company {
public:
    void note(RaySet rays) {
        ++nodes_;
        rays_ += static_cast<std::uint64_t>(std::popcount(rays));
    }
    /// Whether the next rays had better go as a packet, too.
    template <Query Q>
    bool pays() const {
        return nodes_ < few_nodes || rays_ >= least_rays<Q> * nodes_;
    }

private:
    static constexpr std::uint64_t few_nodes = 64;  ///< say nothing yet
    /// With fewer a group's step costs more than those of its rays in flight (measured: README).
    template <Query Q>
    static constexpr std::uint64_t least_rays = Q == Query::closest ? 3 : 4;

    std::uint64_t nodes_ = 0, rays_ = 0;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

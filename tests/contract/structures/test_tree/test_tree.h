#pragma once

#include "accel/core/structure.h"
#include "tests/contract/structures/test_tree/kd.h"
#include "tests/contract/structures/test_tree/walk.h"

/// A kd-tree that can be told to make one classic mistake: the kit must find each of them.
namespace rayshoot::contract {

class TestTree {
public:
    static constexpr std::string_view name = "test_tree";
    static constexpr std::string_view summary = "test only: a kd-tree with planted faults";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::array options{
        OptionInfo{"fault", "none|skipped_child|...", "none", "the mistake to make"}};
    static constexpr std::array<std::string_view, 1> configurations{"test_tree"};

    struct Scratch {
        std::vector<bool> seen;  ///< mailbox, of the ray before where that fault is planted
        std::size_t bytes() const { return seen.size() / 8; }
    };

    TestTree(const BuildInput& input, const Options& chosen);

    template <Query Q, Counter C>
    void many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch, C& count) const;
    Footprint footprint() const;

    bool has(Fault fault) const { return fault_ == fault; }
    const KdTree& tree() const { return tree_; }
    const Geometry& geometry() const { return geometry_; }
    const Leaves& leaves() const { return leaves_; }

private:
    const Geometry& geometry_;
    Fault fault_;
    KdTree tree_;
    Leaves leaves_;
};

/// The faults by name, as the option takes them.
std::vector<std::string_view> fault_names();

/// A leaf of its own for every primitive: leaf number and primitive number are the same.
Leaves one_leaf_each(const Geometry& geometry);

template <Query Q, Counter C>
void TestTree::many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch, C& count) const {
    const std::size_t size = batch.rays.size();
    scratch.seen.resize(geometry_.size());
    for (std::size_t i = 0; i < size; ++i) {
        const Ray& ray = batch.rays[i];
        if (has(Fault::declining) && i % 97 == 96) {
            answers.decline(i);
            continue;
        }
        Hit hit = nothing_yet(ray);
        if (has(Fault::closed_limit)) hit.t = ray.t_max;
        if (!has(Fault::stale_mailbox)) std::fill(scratch.seen.begin(), scratch.seen.end(), false);
        const bool forgotten = has(Fault::lost_remainder) && size % 8 != 0 && i + 1 == size;
        if (!forgotten) Walk<Q, TestTree, C>(*this, ray, hit, scratch, count).run();
        answers.store(i, hit);
    }
}

}  // namespace rayshoot::contract

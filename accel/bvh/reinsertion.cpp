#include "accel/bvh/reinsertion.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <array>
#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

using Node = BinaryTree::Node;
constexpr std::uint32_t root = BinaryTree::root;
constexpr int levels_of_tasks = 10;  ///< of the tree, whose sub-trees are refitted in parallel

/// A place for a node, and by how much moving it there lessens the sum of all half-areas.
struct Move {
    std::uint32_t node = 0, target = 0;
    float gain = 0;

    bool operator<(const Move& other) const {
        return gain != other.gain ? gain > other.gain : node < other.node;
    }
};

/// The tree with the way up, too.
class LinkedTree {
public:
    explicit LinkedTree(BinaryTree& tree)
        : tree_(tree), nodes_(tree.nodes.data()), parent_of_pair_(tree.nodes.size() / 2) {
        link(root, 0);
    }

    bool is_root(std::uint32_t node) const { return node == root; }
    bool interior(std::uint32_t node) const { return nodes_[node].count == 0; }
    const Box& bounds(std::uint32_t node) const { return nodes_[node].bounds; }
    std::uint32_t child(std::uint32_t node) const { return nodes_[node].first; }
    std::uint32_t parent(std::uint32_t node) const { return parent_of_pair_[node / 2]; }
    static std::uint32_t sibling(std::uint32_t node) { return BinaryTree::sibling(node); }

    bool is_ancestor(std::uint32_t ancestor, std::uint32_t node) const {
        while (node != ancestor && node != root) node = parent(node);
        return node == ancestor;
    }

    /// The sibling takes its parent's place, the target the sibling's old one beside the node, and
    /// the pair hangs where the target was. Bounds are left for refit().
    void apply(const Move& move) {
        const std::uint32_t old_parent = parent(move.node), place = sibling(move.node);
        put(nodes_[place], old_parent);
        put(nodes_[move.target], place);
        nodes_[move.target].first = move.node & ~1u;
        nodes_[move.target].count = 0;
        adopt(move.target);
    }

    void refit() { tree_.depth = refit(root, 0).depth; }

private:
    void adopt(std::uint32_t node) { parent_of_pair_[nodes_[node].first / 2] = node; }
    void put(const Node& node, std::uint32_t place) {
        nodes_[place] = node;
        if (interior(place)) adopt(place);
    }

    void link(std::uint32_t node, int depth) {
        if (!interior(node)) return;
        adopt(node);
        both(depth, [&](std::uint32_t side) { link(child(node) + side, depth + 1); });
    }

    Extent refit(std::uint32_t node, int depth) {
        if (!interior(node)) return Extent::of_leaf(depth);
        const std::uint32_t pair = child(node);
        std::array<Extent, 2> sides;
        both(depth, [&](std::uint32_t side) { sides[side] = refit(pair + side, depth + 1); });
        nodes_[node].bounds = nodes_[pair].bounds;
        nodes_[node].bounds.include(nodes_[pair + 1].bounds);
        return sides[0] + sides[1];
    }

    template <class Work>
    static void both(int depth, const Work& work) {
        if (depth < levels_of_tasks) {
            tbb::parallel_invoke([&] { work(0u); }, [&] { work(1u); });
        } else {
            work(0u);
            work(1u);
        }
    }

    BinaryTree& tree_;
    Node* nodes_;
    RawArray<std::uint32_t> parent_of_pair_;
};

/// The best place for one node, by branch and bound.
class Search {
public:
    Search(const LinkedTree& tree, std::uint32_t node)
        : tree_(tree), moved_(tree.bounds(node)), area_(moved_.half_area()), best_{node, 0, 0} {}

    /// Climbs from the node to the root, and searches each sibling on the way.
    Move run() && {
        const std::uint32_t node = best_.node;
        std::uint32_t ancestor = tree_.parent(node);
        if (tree_.is_root(ancestor)) return best_;
        float saved = tree_.bounds(ancestor).half_area();  // by taking the node out
        Box without = tree_.bounds(tree_.sibling(node));   // the ancestor's bounds after that
        search_children(tree_.sibling(node), saved);
        while (!tree_.is_root(ancestor)) {
            const std::uint32_t beside = tree_.sibling(ancestor);
            search(beside, saved);
            without.include(tree_.bounds(beside));
            ancestor = tree_.parent(ancestor);
            saved += tree_.bounds(ancestor).half_area() - without.half_area();
        }
        return best_;
    }

private:
    struct Pending {
        std::uint32_t node;
        float saved;
    };

    void search(std::uint32_t subtree, float saved) {
        std::size_t size = 0;
        pending_[size++] = {subtree, saved};
        while (size > 0) {
            const Pending next = pending_[--size];
            if (!promising(next.saved)) continue;
            const float gain = offer(next.node, next.saved);
            const float below = gain + tree_.bounds(next.node).half_area();
            if (!tree_.interior(next.node) || !promising(below)) continue;
            pending_[size++] = {tree_.child(next.node), below};
            pending_[size++] = {tree_.child(next.node) + 1, below};
        }
    }

    /// False also where areas overflow.
    bool promising(float saved) const { return saved - area_ > best_.gain; }

    /// Beside the sibling itself the node is already.
    void search_children(std::uint32_t sibling, float saved) {
        if (!tree_.interior(sibling)) return;
        Box both = tree_.bounds(sibling);
        both.include(moved_);
        const float below = saved - both.half_area() + tree_.bounds(sibling).half_area();
        search(tree_.child(sibling), below);
        search(tree_.child(sibling) + 1, below);
    }

    float offer(std::uint32_t target, float saved) {
        Box both = tree_.bounds(target);
        both.include(moved_);
        const float gain = saved - both.half_area();
        if (gain > best_.gain) {
            best_.target = target;
            best_.gain = gain;
        }
        return gain;
    }

    const LinkedTree& tree_;
    Box moved_;
    float area_;
    Move best_;
    std::array<Pending, 256> pending_;  // a level of the tree leaves one behind
};

std::vector<std::uint32_t> all_but_root(const BinaryTree& tree) {
    std::vector<std::uint32_t> nodes, pending{root};
    while (!pending.empty()) {
        const Node& node = tree.nodes[pending.back()];
        pending.pop_back();
        if (node.count > 0) continue;
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            nodes.push_back(child);
            pending.push_back(child);
        }
    }
    return nodes;
}

std::vector<Move> best_moves(const LinkedTree& tree, const std::vector<std::uint32_t>& nodes) {
    std::vector<Move> moves(nodes.size());
    tbb::parallel_for(std::size_t{0}, nodes.size(),
                      [&](std::size_t i) { moves[i] = Search(tree, nodes[i]).run(); });
    std::erase_if(moves, [](const Move& move) { return !(move.gain > 0); });
    tbb::parallel_sort(moves.begin(), moves.end());
    return moves;
}

/// Moves that share a node with a better one wait for the next round.
void apply(const std::vector<Move>& moves, LinkedTree& tree, std::size_t nodes) {
    std::vector<bool> touched(nodes);
    for (const Move& move : moves) {
        const std::array near{move.node, move.target, tree.sibling(move.node),
                              tree.parent(move.node), tree.parent(move.target)};
        if (std::any_of(near.begin(), near.end(), [&](auto node) { return touched[node]; }) ||
            tree.is_ancestor(move.node, move.target))
            continue;
        for (const std::uint32_t node : near) touched[node] = true;
        tree.apply(move);
    }
}

}  // namespace

void reinsert(BinaryTree& tree, const Reinsertion& settings) {
    if (tree.leaves < 4) return;
    LinkedTree linked(tree);
    for (int i = 0; i < settings.rounds; ++i) {
        const RawArray<Node> before = tree.nodes.copy();
        const int depth = tree.depth;
        apply(best_moves(linked, all_but_root(tree)), linked, tree.nodes.size());
        linked.refit();
        if (tree.depth <= settings.deepest) continue;
        std::copy(before.begin(), before.end(), tree.nodes.begin());
        tree.depth = depth;
        return;
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

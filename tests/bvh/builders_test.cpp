#include <gtest/gtest.h>

#include "accel/bvh/builders.h"
#include "tests/bvh/soups.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace rayshoot::bvh_test {
namespace {

constexpr std::array all_builds{TreeBuild::fast, TreeBuild::standard, TreeBuild::high};
constexpr int deepest = 64;

std::string name_of(TreeBuild build) { return build == TreeBuild::fast ? "fast" : "default"; }

TreeSettings settings_for(TreeBuild build, std::uint32_t test_width = 4) {
    TreeSettings settings;
    settings.build = build;
    settings.sah.deepest = deepest;
    settings.sah.test_width = test_width;
    return settings;
}

/// Visits every node from the root down, with its depth.
template <class Visit>
void walk(const BinaryTree& tree, const Visit& visit) {
    std::vector<std::pair<std::uint32_t, int>> pending;
    if (!tree.nodes.empty()) pending.emplace_back(BinaryTree::root, 0);
    while (!pending.empty()) {
        const auto [number, depth] = pending.back();
        pending.pop_back();
        const BinaryTree::Node& node = tree.nodes[number];
        visit(node, depth);
        if (node.count > 0) continue;
        pending.emplace_back(node.first + 1, depth + 1);
        pending.emplace_back(node.first, depth + 1);
    }
}

/// MacDonald & Booth 1990, with tests of four boxes at once.
double sah_cost(const BinaryTree& tree) {
    double cost = 0;
    walk(tree, [&](const BinaryTree::Node& node, int) {
        cost += double(node.bounds.half_area()) * (node.count > 0 ? (node.count + 3) / 4 : 1);
    });
    return cost / double(tree.nodes.front().bounds.half_area());
}

void expect_same(const BinaryTree& a, const BinaryTree& b) {
    ASSERT_TRUE(std::equal(a.order.begin(), a.order.end(), b.order.begin(), b.order.end()));
    EXPECT_EQ(a.leaves, b.leaves);
    EXPECT_EQ(a.depth, b.depth);
    std::vector<BinaryTree::Node> nodes;
    walk(a, [&](const BinaryTree::Node& node, int) { nodes.push_back(node); });
    std::size_t next = 0;
    walk(b, [&](const BinaryTree::Node& node, int) {
        ASSERT_LT(next, nodes.size());
        EXPECT_EQ(std::memcmp(&nodes[next], &node, sizeof node), 0) << next;
        ++next;
    });
    EXPECT_EQ(next, nodes.size());
}

TEST(TreeBuilders, put_every_box_into_exactly_one_leaf) {
    for (const Soup& soup : nasty_soups()) {
        for (const TreeBuild build : all_builds) {
            SCOPED_TRACE(soup.name + ", " + name_of(build));
            const BinaryTree tree = build_tree(soup.boxes, settings_for(build));
            std::vector<int> seen(soup.boxes.size());
            std::uint32_t leaves = 0;
            walk(tree, [&](const BinaryTree::Node& node, int) {
                leaves += node.count > 0;
                for (std::uint32_t i = 0; i < node.count; ++i) {
                    const std::uint32_t here = node.first + i;
                    ++seen[tree.order[here]];
                    EXPECT_TRUE(i == 0 || tree.order[here - 1] < tree.order[here]);
                }
            });
            EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ssize(seen));
            EXPECT_EQ(leaves, tree.leaves);
            EXPECT_EQ(tree.order.size(), soup.boxes.size());
        }
    }
}

TEST(TreeBuilders, make_bounds_that_are_exact_unions) {
    for (const Soup& soup : nasty_soups()) {
        for (const TreeBuild build : all_builds) {
            SCOPED_TRACE(soup.name + ", " + name_of(build));
            const BinaryTree tree = build_tree(soup.boxes, settings_for(build));
            walk(tree, [&](const BinaryTree::Node& node, int) {
                Box unite;
                for (std::uint32_t i = 0; i < node.count; ++i)
                    unite.include(soup.boxes[tree.order[node.first + i]]);
                for (std::uint32_t i = 0; node.count == 0 && i < 2; ++i)
                    unite.include(tree.nodes[node.first + i].bounds);
                EXPECT_EQ(node.bounds, unite);
            });
        }
    }
}

TEST(TreeBuilders, keep_within_the_depth_and_the_size_of_leaves) {
    for (const Soup& soup : nasty_soups()) {
        for (const TreeBuild build : all_builds) {
            for (const std::uint32_t largest_leaf : {1u, 4u, 32u}) {
                for (const int within : {32, deepest}) {
                    SCOPED_TRACE(soup.name + ", " + name_of(build));
                    TreeSettings settings = settings_for(build, 1);
                    settings.sah.largest_leaf = largest_leaf;
                    settings.sah.deepest = within;
                    const BinaryTree tree = build_tree(soup.boxes, settings);
                    int found = 0;
                    walk(tree, [&](const BinaryTree::Node& node, int depth) {
                        EXPECT_LE(node.count, largest_leaf);
                        found = std::max(found, depth);
                    });
                    EXPECT_EQ(found, tree.depth);
                    EXPECT_LE(found, within);
                }
            }
        }
    }
}

TEST(TreeBuilders, build_the_same_tree_with_any_number_of_threads) {
    const std::vector<Box> boxes = random_boxes(40000, 0.02f, 5);
    for (const TreeBuild build : all_builds) {
        SCOPED_TRACE(name_of(build));
        BinaryTree first;
        for (const std::size_t threads : {1u, 2u, 4u, 7u, 7u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            BinaryTree tree = build_tree(boxes, settings_for(build));
            if (first.nodes.empty()) first = std::move(tree);
            else expect_same(first, tree);
        }
    }
}

TEST(TreeBuilders, trade_time_for_cost) {
    for (const float size : {0.01f, 0.05f, 0.3f}) {
        const std::vector<Box> boxes = random_boxes(20000, size, 6);
        const double fast = sah_cost(build_tree(boxes, settings_for(TreeBuild::fast)));
        const double standard = sah_cost(build_tree(boxes, settings_for(TreeBuild::standard)));
        const double high = sah_cost(build_tree(boxes, settings_for(TreeBuild::high)));
        EXPECT_LE(high, standard) << size;
        EXPECT_LE(standard, fast) << size;
        EXPECT_LE(fast, 1.4 * standard) << size;
    }
}

}  // namespace
}  // namespace rayshoot::bvh_test

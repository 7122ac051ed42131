#include <gtest/gtest.h>

#include "accel/bvh/builders.h"
#include "accel/bvh8/layout.h"
#include "tests/bvh/soups.h"

#include <tbb/global_control.h>

#include <algorithm>

namespace rayshoot::bvh_test {
namespace {

/// A triangle across each box; the first one may be a sphere.
Geometry across(const std::vector<Box>& boxes, bool with_a_sphere) {
    GeometryBuilder builder;
    if (with_a_sphere) builder.add_sphere({boxes.front().centre(), 0.1f});
    for (std::size_t i = with_a_sphere; i < boxes.size(); ++i) {
        const auto& [lo, hi] = boxes[i];
        builder.add_triangle(lo, vec3(hi.x, lo.y, hi.z), hi);
    }
    return std::move(builder).build();
}

WideTree<WideNode8> wide_tree(const Geometry& geometry) {
    return laid_out<WideNode8>(geometry,
                               build_tree(geometry.all_bounds(), {.sah = {.test_width = 4}}));
}

/// Every leaf as the numbers of its primitives, if these are triangles.
std::vector<int> times_met(const WideTree<WideNode8>& tree, std::size_t primitives) {
    std::vector<int> met(primitives);
    std::vector<std::uint32_t> pending{0};
    while (!pending.empty()) {
        const WideNode8& node = tree.nodes[pending.back()];
        pending.pop_back();
        for (std::size_t i = 0; i < node.live; ++i) {
            const WideChild child = node.child(i);
            if (child.interior()) {
                pending.push_back(child.number());
                continue;
            }
            for (std::uint32_t b = 0; b < child.leaf().block_count(); ++b)
                for (const std::uint32_t number :
                     tree.leaves.block<TriangleBlock>(child.leaf().first_block() + b).primitive)
                    if (number != no_primitive) ++met[number];
        }
    }
    return met;
}

TEST(WideLayout, is_the_same_for_any_number_of_threads) {
    for (const bool with_a_sphere : {false, true}) {
        const Geometry geometry = across(random_boxes(30000, 0.02f, 8), with_a_sphere);
        WideTree<WideNode8> first;
        for (const std::size_t threads : {1u, 2u, 7u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            WideTree<WideNode8> tree = wide_tree(geometry);
            if (first.nodes.empty()) first = std::move(tree);
            else {
                ASSERT_EQ(first.nodes.size(), tree.nodes.size());
                EXPECT_TRUE(std::equal(first.nodes.begin(), first.nodes.end(), tree.nodes.begin(),
                                       [](const WideNode8& a, const WideNode8& b) {
                                           return a.bounds.planes == b.bounds.planes &&
                                                  a.children == b.children && a.live == b.live;
                                       }));
                ASSERT_EQ(first.leaves.bytes(), tree.leaves.bytes());
            }
        }
    }
}

TEST(WideLayout, has_every_triangle_once) {
    for (const std::size_t count : {1u, 2u, 4u, 5u, 9u, 40u, 3000u, 30000u}) {
        const Geometry geometry = across(random_boxes(count, 0.1f, 9), false);
        const std::vector<int> met = times_met(wide_tree(geometry), count);
        EXPECT_EQ(std::count(met.begin(), met.end(), 1), std::ssize(met)) << count;
    }
}

TEST(WideLayout, of_nothing_is_an_empty_root) {
    const Geometry geometry = GeometryBuilder().build();
    const WideTree<WideNode8> tree = wide_tree(geometry);
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(tree.nodes.front().live, 0u);
}

}  // namespace
}  // namespace rayshoot::bvh_test

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

template <class Node = WideNode8>
WideTree<Node> wide_tree(const Geometry& geometry) {
    return laid_out<Node>(geometry, build_tree(geometry.all_bounds(), {.sah = {.test_width = 4}}));
}

/// Every leaf as the numbers of its primitives, if these are triangles.
template <class Node>
std::vector<int> times_met(const WideTree<Node>& tree, std::size_t primitives) {
    std::vector<int> met(primitives);
    std::vector<std::uint32_t> pending{0};
    while (!pending.empty()) {
        const Node& node = tree.nodes[pending.back()];
        pending.pop_back();
        for (std::size_t i = 0; i < node.live(); ++i) {
            const WideChild child = node.child(i);
            if (child.interior()) {
                pending.push_back(child.number());
                continue;
            }
            for (std::uint32_t b = 0; b < child.leaf().block_count(); ++b)
                for (const std::uint32_t number :
                     tree.leaves.template block<TriangleBlock>(child.leaf().first_block() + b)
                         .primitive)
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
                                                  a.children == b.children;
                                       }));
                ASSERT_EQ(first.leaves.bytes(), tree.leaves.bytes());
            }
        }
    }
}

TEST(WideLayout, has_every_triangle_once) {
    for (const std::size_t count : {1u, 2u, 4u, 5u, 9u, 40u, 3000u, 30000u}) {
        const Geometry geometry = across(random_boxes(count, 0.1f, 9), false);
        for (const std::vector<int>& met : {times_met(wide_tree(geometry), count),
                                            times_met(wide_tree<WideNode4>(geometry), count),
                                            times_met(wide_tree<WideNode8q>(geometry), count)})
            EXPECT_EQ(std::count(met.begin(), met.end(), 1), std::ssize(met)) << count;
    }
}

/// Bounds of triangles with such corners may be unbounded again: they are padded.
std::vector<Box> with_finite_corners(std::vector<Box> boxes) {
    constexpr float largest = std::numeric_limits<float>::max();
    for (Box& box : boxes)
        for (int axis = 0; axis < 3; ++axis)
            for (float* const coordinate : {&box.lo[axis], &box.hi[axis]})
                *coordinate = std::clamp(*coordinate, -largest, largest);
    return boxes;
}

/// Exactly: a box that is decoded is compared as a float.
TEST(WideLayout, quantised_contains_every_child_of_every_node) {
    std::vector<Soup> soups = nasty_soups();
    soups.push_back({"random", random_boxes(30000, 0.02f, 10)});
    for (const Soup& soup : soups) {
        const Geometry geometry = across(with_finite_corners(soup.boxes), false);
        if (geometry.size() == 0) continue;
        const WideTree<WideNode8> exact = wide_tree(geometry);
        const WideTree<WideNode8q> quantised = wide_tree<WideNode8q>(geometry);
        ASSERT_EQ(exact.nodes.size(), quantised.nodes.size()) << soup.name;
        for (std::size_t n = 0; n < exact.nodes.size(); ++n) {
            const WideNode8& node = exact.nodes[n];
            ASSERT_EQ(node.children, quantised.nodes[n].children) << soup.name;
            for (std::size_t i = 0; i < node.live(); ++i)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const QuantisedBoxes& found = quantised.nodes[n].bounds;
                    ASSERT_FALSE(plane(found, axis, axis, i) > plane(node.bounds, axis, axis, i))
                        << soup.name;
                    ASSERT_FALSE(plane(found, axis, axis + 3, i) <
                                 plane(node.bounds, axis, axis + 3, i))
                        << soup.name;
                }
        }
    }
}

TEST(WideLayout, of_nothing_is_an_empty_root) {
    const Geometry geometry = GeometryBuilder().build();
    const WideTree<WideNode8> tree = wide_tree(geometry);
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(tree.nodes.front().live(), 0u);
}

}  // namespace
}  // namespace rayshoot::bvh_test

#include <gtest/gtest.h>

#include "accel/bvh/builders.h"
#include "accel/bvh8/layout.h"
#include "accel/bvh8/wide_hlbvh.h"
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

template <class Node>
using Build = WideTree<Node> (*)(const Geometry&);

template <class Node>
WideTree<Node> by_binned_sah(const Geometry& geometry) {
    return laid_out<Node>(geometry, build_tree(geometry.all_bounds(), {.sah = {.test_width = 4}}));
}
template <class Node>
WideTree<Node> by_hlbvh(const Geometry& geometry) {
    return build_wide_hlbvh<Node>(geometry, {.test_width = 4});
}
template <class Node>
constexpr std::array<Build<Node>, 2> all_wide_builds{by_binned_sah<Node>, by_hlbvh<Node>};
using WideTree8 = WideTree<WideNode8>;

/// The numbers in the blocks of every leaf that is triangles alone, in one fixed order.
template <class Node>
std::vector<std::uint32_t> triangles_of(const WideTree<Node>& tree) {
    std::vector<std::uint32_t> numbers, pending{0};
    while (!pending.empty()) {
        const Node& node = tree.nodes[pending.back()];
        pending.pop_back();
        for (std::size_t i = 0; i < node.live(); ++i) {
            const WideChild child = node.child(i);
            if (child.interior()) {
                pending.push_back(child.number());
                continue;
            }
            if (!child.leaf().only_triangles()) continue;
            for (std::uint32_t b = 0; b < child.leaf().block_count(); ++b) {
                const std::uint32_t block = child.leaf().first_block() + b;
                const auto& four = tree.leaves.template block<TriangleBlock>(block).primitive;
                numbers.insert(numbers.end(), four.begin(), four.end());
            }
        }
    }
    return numbers;
}

/// How often each triangle is in a leaf.
template <class Node>
std::vector<int> times_met(const WideTree<Node>& tree, std::size_t primitives) {
    std::vector<int> met(primitives);
    for (const std::uint32_t number : triangles_of(tree))
        if (number != no_primitive) ++met[number];
    return met;
}

/// Of the children as they are, which is what the parent has to enclose.
Box bounds_of(const WideTree8& tree, std::uint32_t number) {
    Box all;
    for (std::size_t i = 0; i < tree.nodes[number].live(); ++i) {
        const auto& planes = tree.nodes[number].bounds.planes;
        all.include(Box{{planes[0][i], planes[1][i], planes[2][i]},
                        {planes[3][i], planes[4][i], planes[5][i]}});
    }
    return all;
}

void expect_same(const WideTree8& a, const WideTree8& b) {
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_TRUE(std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(),
                           [](const WideNode8& n, const WideNode8& m) {
                               return n.bounds.planes == m.bounds.planes &&
                                      n.children == m.children;
                           }));
    EXPECT_EQ(triangles_of(a), triangles_of(b));
    EXPECT_EQ(a.leaves.bytes(), b.leaves.bytes());
    EXPECT_EQ(a.leaf_count, b.leaf_count);
    EXPECT_EQ(a.depth, b.depth);
}

TEST(WideTrees, are_the_same_for_any_number_of_threads) {
    for (const Build<WideNode8> build : all_wide_builds<WideNode8>) {
        for (const bool with_a_sphere : {false, true}) {
            const Geometry geometry = across(random_boxes(30000, 0.02f, 8), with_a_sphere);
            WideTree8 first;
            for (const std::size_t threads : {1u, 2u, 7u}) {
                const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                                threads);
                WideTree8 tree = build(geometry);
                if (first.nodes.empty()) first = std::move(tree);
                else expect_same(first, tree);
            }
        }
    }
}

template <class Node>
void expect_every_triangle_once() {
    for (const Build<Node> build : all_wide_builds<Node>)
        for (const std::size_t count : {1u, 2u, 4u, 5u, 9u, 32u, 33u, 40u, 3000u, 30000u}) {
            const Geometry geometry = across(random_boxes(count, 0.1f, 9), false);
            const std::vector<int> met = times_met(build(geometry), count);
            EXPECT_EQ(std::count(met.begin(), met.end(), 1), std::ssize(met)) << count;
        }
}

TEST(WideTrees, have_every_triangle_once) {
    expect_every_triangle_once<WideNode8>();
    expect_every_triangle_once<WideNode4>();
    expect_every_triangle_once<WideNode8q>();
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
TEST(WideTrees, that_are_quantised_contain_every_child_of_every_node) {
    std::vector<Soup> soups = nasty_soups();
    soups.push_back({"random", random_boxes(30000, 0.02f, 10)});
    for (const Soup& soup : soups) {
        const Geometry geometry = across(with_finite_corners(soup.boxes), false);
        if (geometry.size() == 0) continue;
        const WideTree<WideNode8> exact = by_binned_sah<WideNode8>(geometry);
        const WideTree<WideNode8q> quantised = by_binned_sah<WideNode8q>(geometry);
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

TEST(WideTrees, have_nodes_in_the_bounds_of_their_place) {
    const Geometry geometry = across(random_boxes(3000, 0.1f, 10), false);
    for (const Build<WideNode8> build : all_wide_builds<WideNode8>) {
        const WideTree8 tree = build(geometry);
        EXPECT_EQ(bounds_of(tree, 0), geometry.bounds());
        for (std::uint32_t number = 0; number < tree.nodes.size(); ++number) {
            const WideNode8& node = tree.nodes[number];
            for (std::size_t i = 0; i < node.live(); ++i) {
                if (!node.child(i).interior()) continue;
                const Box box = bounds_of(tree, node.child(i).number());
                for (int axis = 0; axis < 3; ++axis) {
                    const auto lo = static_cast<std::size_t>(axis);
                    EXPECT_EQ(box.lo[axis], node.bounds.planes[lo][i]);
                    EXPECT_EQ(box.hi[axis], node.bounds.planes[lo + 3][i]);
                }
            }
        }
    }
}

TEST(WideTrees, of_coincident_triangles_are_no_deeper_than_the_stack) {
    const Geometry geometry = across(std::vector<Box>(5000, Box{vec3(0), vec3(1)}), false);
    for (const Build<WideNode8> build : all_wide_builds<WideNode8>)
        EXPECT_LE(build(geometry).depth, 64);
}

TEST(WideTrees, of_nothing_are_an_empty_root) {
    const Geometry geometry = GeometryBuilder().build();
    for (const Build<WideNode8> build : all_wide_builds<WideNode8>) {
        const WideTree8 tree = build(geometry);
        ASSERT_EQ(tree.nodes.size(), 1u);
        EXPECT_EQ(tree.nodes.front().live(), 0u);
    }
}

}  // namespace
}  // namespace rayshoot::bvh_test

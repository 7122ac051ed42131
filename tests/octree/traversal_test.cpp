#include "accel/octree/glassner84.h"
#include "accel/octree/linear_octree.h"
#include "accel/octree/nodes.h"
#include "accel/octree/parametric.h"
#include "accel/octree/recursive93.h"
#include "accel/octree/samet89.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

/// Which leaves a ray is shown, and in which order, by every traversal and in every storage.
namespace rayshoot {
namespace {

using Key = std::array<std::uint32_t, 4>;
Key key(OctreeNodes::Cell cell) { return {cell, 0, 0, 0}; }
Key key(const LinearOctree::Cell& cell) {
    const OctreePlace& place = cell.lattice;
    return {place.place[0], place.place[1], place.place[2], std::uint32_t(place.level)};
}

/// Notes the leaves instead of testing their members.
template <class Cells>
struct Recorder {
    using Cell = typename Cells::Cell;
    const Cells& cells;
    SlabRay ray;
    Interval within;
    unsigned nearest = ray.descending[0] * 1u | ray.descending[1] * 2u | ray.descending[2] * 4u;
    float hit = infinity;  ///< what lies behind it need not be visited
    std::vector<Key>& seen;

    bool interior(const Cell& cell) const { return cells.interior(cell); }
    float crossing(const Cell& cell, int axis) const {
        return ray.at(axis, cells.plane(cell, axis));
    }
    bool reaches(float t) const { return t <= hit; }
    void step() const {}
    bool visit(const Cell& cell) const {
        seen.push_back(key(cell));
        return false;
    }
};

/// An octree of triangles with corners on the planes of its cells, and beside them.
struct Woods {
    Geometry geometry;
    OctreeGrowth growth;
    OctreeLists lists;

    explicit Woods(OctreePlanes planes) {
        std::mt19937 random(7);
        std::uniform_int_distribution<int> place(0, 16);
        GeometryBuilder builder;
        for (int i = 0; i < 300; ++i) {
            const vec3 corner(float(place(random)), float(place(random)), float(place(random)));
            const auto shift = [&] { return float(place(random) % 3); };
            builder.add_triangle(corner, corner + vec3(shift(), shift(), 1),
                                 corner + vec3(1, shift(), shift()));
        }
        builder.add_triangle({0, 0, 0}, {16, 0, 0}, {0, 0, 16});
        geometry = std::move(builder).build();
        const BuildInput input{geometry, {}, {}, nullptr};
        growth = grow_octree(geometry.size(), Membership(input, Overlap::bounds),
                             {.depth = 5, .planes = planes, .most_references = 1000});
    }
};

template <class Cells>
void gather(const Cells& cells, const typename Cells::Cell& cell, const Box& box,
            std::map<Key, Box>& leaves) {
    if (!cells.interior(cell)) {
        leaves[key(cell)] = box;
        return;
    }
    for (unsigned i = 0; i < 8; ++i) {
        Box part = box;
        for (int axis = 0; axis < 3; ++axis)
            (i >> axis & 1 ? part.lo : part.hi)[axis] = cells.plane(cell, axis);
        gather(cells, cells.child(cell, i), part, leaves);
    }
}

/// Rays that are hard on these leaves: along their edges, through corners, in planes, from planes,
/// and the same from so far away that planes are met at the same t.
std::vector<Ray> hard_rays(const std::map<Key, Box>& leaves) {
    std::mt19937 random(3);
    std::vector<Box> boxes;
    for (const auto& [name, box] : leaves) boxes.push_back(box);
    const auto plane = [&](int axis) {
        const Box& box = boxes[random() % boxes.size()];
        return random() % 2 ? box.lo[axis] : box.hi[axis];
    };
    std::uniform_real_distribution<float> turn(-1, 1);
    std::vector<Ray> rays;
    for (int i = 0; i < 3000; ++i) {
        Ray ray;
        for (int axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = plane(axis);
            const float towards = plane(axis) - ray.origin[axis];
            const std::array<float, 4> ways{towards, turn(random), random() % 2 ? 1.0f : -1.0f,
                                            random() % 2 ? 0.0f : towards};
            ray.direction[axis] = ways[static_cast<std::size_t>(i % 4)];
        }
        if (ray.direction == vec3(0)) ray.direction.y = -1;
        if (i % 7 == 0) ray.origin = ray.origin - 1e6f * ray.direction;
        else if (i % 3 == 0) ray.origin = ray.origin - 3.0f * ray.direction;
        ray.t_min = i % 5 == 0 ? -infinity : i % 5 == 1 ? turn(random) : 0;
        rays.push_back(ray);
    }
    return rays;
}

/// Whether the ray runs inside a face of a box: then those on both sides of it have no order.
bool is_inside_face(const Ray& ray, const Box& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (ray.direction[axis] == 0 &&
            (ray.origin[axis] == box.lo[axis] || ray.origin[axis] == box.hi[axis]))
            return true;
    return false;
}

enum class Way { glassner84, samet89, recursive93, parametric };

template <class Cells>
std::vector<Key> visited(const Cells& cells, const Ray& from, const Box& space, Way way) {
    std::vector<Key> seen;
    const SlabRay ray(from.origin, from.direction);
    const Recorder<Cells> ask{.cells = cells,
                              .ray = ray,
                              .within = clip(ray, space, {from.t_min, infinity}),
                              .seen = seen};
    if (ask.within.empty()) return seen;
    switch (way) {
        case Way::glassner84:
            glassner84(ask);
            break;
        case Way::samet89:
            samet89(ask);
            break;
        case Way::recursive93:
            recursive93(ask, cells.root(), ask.within);
            break;
        case Way::parametric:
            parametric(ask, cells.root(), ask.within);
            break;
    }
    return seen;
}

class OctreeTraversals : public testing::TestWithParam<Way> {
protected:
    template <class Cells>
    void expect_touched_leaves_in_order(const Cells& cells, const Box& space);
};

template <class Cells>
void OctreeTraversals::expect_touched_leaves_in_order(const Cells& cells, const Box& space) {
    std::map<Key, Box> leaves;
    gather(cells, cells.root(), space, leaves);
    ASSERT_GT(leaves.size(), 500u);
    for (const Ray& ray : hard_rays(leaves)) {
        const SlabRay slabs(ray.origin, ray.direction);
        std::set<Key> touched;
        bool ordered = true;
        for (const auto& [name, box] : leaves) {
            if (clip(slabs, box, {ray.t_min, infinity}).empty()) continue;
            touched.insert(name);
            ordered &= !is_inside_face(ray, box);
        }
        const std::vector<Key> seen = visited(cells, ray, space, GetParam());
        EXPECT_EQ(std::set<Key>(seen.begin(), seen.end()), touched);
        // Leaves that are met again in a block may come late; none may come for the first time
        // after one that begins behind it.
        std::set<Key> before;
        float latest = -infinity;
        for (const Key& leaf : seen) {
            if (!ordered || !before.insert(leaf).second) continue;
            const float entry = clip(slabs, leaves[leaf], {ray.t_min, infinity}).entry;
            EXPECT_GE(entry, latest);
            latest = entry;
        }
        if (HasFailure()) {
            ADD_FAILURE() << std::hexfloat << ray.origin.x << ' ' << ray.origin.y << ' '
                          << ray.origin.z << "  " << ray.direction.x << ' ' << ray.direction.y
                          << ' ' << ray.direction.z << "  " << ray.t_min;
            return;
        }
    }
}

TEST_P(OctreeTraversals, show_every_leaf_that_a_ray_touches_in_the_right_order) {
    Woods woods(OctreePlanes::centre);
    const Box space = woods.growth.root.box;
    expect_touched_leaves_in_order(OctreeNodes(woods.growth.root, woods.lists), space);
}

TEST_P(OctreeTraversals, do_so_with_planes_anywhere) {
    Woods woods(OctreePlanes::sah);
    const Box space = woods.growth.root.box;
    expect_touched_leaves_in_order(OctreeNodes(woods.growth.root, woods.lists), space);
}

TEST_P(OctreeTraversals, do_so_in_a_sorted_list_of_leaves) {
    Woods woods(OctreePlanes::centre);
    const Box space = woods.growth.root.box;
    expect_touched_leaves_in_order(LinearOctree(woods.growth.root, woods.lists), space);
}

std::string way_name(const testing::TestParamInfo<Way>& way) {
    constexpr std::array names{"glassner84", "samet89", "recursive93", "parametric"};
    return names[static_cast<std::size_t>(way.param)];
}
INSTANTIATE_TEST_SUITE_P(All, OctreeTraversals,
                         testing::Values(Way::glassner84, Way::samet89, Way::recursive93,
                                         Way::parametric),
                         way_name);

TEST(OctreeParametric, has_bit_0_for_x_and_bit_2_for_z_as_the_erratum_says) {
    const std::array<float, 3> cuts{1, 2, 3};
    EXPECT_EQ(first_child(cuts, 0.5f), 0u);
    EXPECT_EQ(first_child(cuts, 1.5f), 1u);
    EXPECT_EQ(first_child(cuts, 2.5f), 3u);
    EXPECT_EQ(first_child({3, 2, 1}, 1.5f), 4u);
}

TEST(OctreeParametric, leaves_a_child_through_all_cuts_that_are_tied) {
    const OctreeChildExit exit(0, {2, 5, 2}, 9);
    EXPECT_EQ(exit.t, 2);
    EXPECT_EQ(exit.axes, 5u);
    EXPECT_EQ(OctreeChildExit(7, {2, 5, 2}, 9).axes, 0u);
}

TEST(OctreeLattice, planes_never_decrease_with_their_number) {
    for (const Box& space : {Box{vec3(-1), vec3(1)}, Box{vec3(1e8f), vec3(1e8f + 16)},
                             Box{vec3(-1e30f), vec3(1e-10f)}, Box{vec3(5), vec3(5)}}) {
        const OctreeLattice lattice(space);
        float last = space.lo.x;
        for (std::uint32_t i = 0; i < 4096; ++i) {
            const float plane = lattice.middle(0, {{i, 0, 0}, 12});
            EXPECT_GE(plane, last);
            EXPECT_LE(plane, space.hi.x);
            last = plane;
        }
    }
}

TEST(LinearOctree, holds_the_leaves_of_the_nodes_that_are_not_empty) {
    Woods one(OctreePlanes::centre), other(OctreePlanes::centre);
    const OctreeNodes nodes(one.growth.root, one.lists);
    const LinearOctree list(other.growth.root, other.lists);
    EXPECT_EQ(one.lists.members, other.lists.members);
    EXPECT_EQ(one.lists.leaves.size(), other.lists.leaves.size());
    EXPECT_LT(list.bytes(), nodes.bytes());
}

}  // namespace
}  // namespace rayshoot

#include "tests/generators/golden.h"

#include <gtest/gtest.h>

namespace rayshoot {
namespace {

struct Encloses {
    Box inner;
    bool operator()(std::monostate) const { return false; }
    bool operator()(const Box& box) const { return box.contains(inner); }
    bool operator()(const Sphere& sphere) const {
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 p((corner & 1 ? inner.hi : inner.lo).x,
                          (corner & 2 ? inner.hi : inner.lo).y,
                          (corner & 4 ? inner.hi : inner.lo).z);
            if (!(length(p - dvec3(sphere.centre)) < 0.9999 * sphere.radius)) return false;
        }
        return true;
    }
};

class Chair : public testing::Test {
protected:
    /// Counts how often each primitive occurs below a group; every bound on the way must enclose
    /// it.
    void visit(std::uint32_t id, std::vector<std::uint32_t>& path, std::vector<int>& seen) const {
        path.push_back(id);
        const Hierarchy::Group& group = scene.hierarchy->groups[id];
        for (const std::uint32_t primitive : group.primitives) {
            ++seen[primitive];
            for (const std::uint32_t outer : path)
                EXPECT_TRUE(std::visit(Encloses{scene.geometry.bounds(primitive)},
                                       scene.hierarchy->groups[outer].bound))
                    << "primitive " << primitive << " in group " << outer;
        }
        for (const std::uint32_t child : group.groups) visit(child, path, seen);
        path.pop_back();
    }

    Scene scene = generate_scene("chair");
};

TEST_F(Chair, each_of_96_primitives_is_in_one_group_and_inside_all_its_bounds) {
    std::vector<std::uint32_t> path;
    std::vector<int> seen(scene.geometry.size());
    visit(0, path, seen);
    EXPECT_EQ(seen, std::vector<int>(96, 1));
}

TEST_F(Chair, has_arms_back_seat_and_legs_under_one_sphere) {
    const auto& groups = scene.hierarchy->groups;
    EXPECT_TRUE(std::holds_alternative<Sphere>(groups[0].bound));
    EXPECT_EQ(groups[0].groups.size(), 4u);
    EXPECT_TRUE(groups[0].primitives.empty());
    std::vector<std::size_t> parts;
    for (const std::uint32_t part : groups[0].groups) {
        std::size_t primitives = groups[part].primitives.size();
        for (const std::uint32_t child : groups[part].groups)
            primitives += groups[child].primitives.size();
        parts.push_back(primitives);
    }
    EXPECT_EQ(parts, (std::vector<std::size_t>{16, 32, 24, 24}));
}

}  // namespace
}  // namespace rayshoot

#include "accel/space/outlines.h"

#include <gtest/gtest.h>

#include "tests/contract/random.h"

#include <set>

namespace rayshoot::space_test {
namespace {

/// Things in a row, every third of which holds something.
struct Row {
    std::vector<Box> boxes;
    std::vector<std::uint32_t> references;

    explicit Row(int size) {
        contract::Random random(1);
        for (int i = 0; i < size; ++i) {
            const vec3 at(static_cast<float>(i), random.between(-1, 1), random.between(-1, 1));
            boxes.push_back({at, at + vec3(0.5f)});
            references.push_back(i % 3 == 0 ? 1 + random.below(100) : 0);
        }
    }
    OutlinedRuns outlined() const {
        return {boxes.size(), [&](std::size_t i) { return references[i]; },
                [&](std::size_t i) { return boxes[i]; }};
    }
};

TEST(OutlinedRuns, show_a_ray_all_that_it_meets) {
    const Row row(2000);
    const OutlinedRuns runs = row.outlined();
    EXPECT_GT(runs.runs(), 50u);
    contract::Random random(2);
    Silent none;
    std::size_t most_visited = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 direction = random.direction();
        const SlabRay ray(vec3(random.between(0, 2000), 0, 0) - 1e3f * direction, direction);
        std::set<std::uint32_t> visited;
        const Hit nothing{infinity, no_primitive, 0, 0};
        runs.each(
            ray, 0, nothing,
            [&](std::uint32_t item) {
                EXPECT_TRUE(visited.insert(item).second);
                return false;
            },
            none);
        most_visited = std::max(most_visited, visited.size());
        for (std::uint32_t item = 0; item < row.boxes.size(); ++item)
            EXPECT_TRUE(row.references[item] == 0 || visited.contains(item) ||
                        clip(ray, row.boxes[item], {0, infinity}).empty())
                << item;
    }
    EXPECT_LT(most_visited, row.boxes.size());
}

TEST(OutlinedRuns, stop_when_they_are_told_to) {
    const Row row(500);
    Silent none;
    int visits = 0;
    const Hit nothing{infinity, no_primitive, 0, 0};
    row.outlined().each(
        SlabRay(vec3(-10, 0, 0), vec3(1, 0, 0)), 0, nothing,
        [&](std::uint32_t) { return ++visits == 3; }, none);
    EXPECT_EQ(visits, 3);
}

TEST(OutlinedRuns, of_nothing_show_nothing) {
    Silent none;
    const Hit nothing{infinity, no_primitive, 0, 0};
    const auto visit = [](std::uint32_t) { return ADD_FAILURE(), true; };
    for (const std::size_t size : {std::size_t{0}, std::size_t{10}}) {
        const OutlinedRuns runs(
            size, [](std::size_t) { return 0u; }, [](std::size_t) { return Box{}; });
        runs.each(SlabRay(vec3(0), vec3(1)), 0, nothing, visit, none);
        EXPECT_EQ(runs.runs(), 0u);
    }
}

}  // namespace
}  // namespace rayshoot::space_test

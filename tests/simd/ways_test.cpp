#include "accel/core/catalogue.h"
#include "accel/simd/packet.h"
#include "tests/core/cases.h"

#include <gtest/gtest.h>

#include <cstring>
#include <tuple>

/// Every way through the wide trees, over leaves of every kind: on packets whose beam meets few
/// nodes, on such wide ones that their groups go on by themselves, and where these give way to rays
/// in flight.
namespace rayshoot {
namespace {

struct Scene {
    const char* name;
    Precision precision;
    std::uint32_t triangles, spheres, others;  ///< of ten primitives
};
constexpr Scene scenes[] = {{"triangles", Precision::standard, 10, 0, 0},
                            {"watertight_triangles", Precision::watertight, 10, 0, 0},
                            {"spheres", Precision::standard, 0, 10, 0},
                            {"mixture", Precision::standard, 6, 3, 1},
                            {"watertight_mixture", Precision::watertight, 6, 3, 1}};

/// Frusta, and spheres that move.
void add_other(GeometryBuilder& builder, const vec3& place, cases::Random& random) {
    if (random.below(2) == 0) {
        builder.add_frustum({place, 0.01f, place + random.in_cube(0.04), 0.005f});
    } else {
        Motion motion;
        motion.translation[1] = random.in_cube(0.02);
        builder.add_sphere({place, 0.01f}, builder.add_motion(motion));
    }
}

Geometry many_small_ones(const Scene& scene) {
    cases::Random random(1);
    GeometryBuilder builder;
    for (int i = 0; i < 20000; ++i) {
        const vec3 place = random.in_cube(1);
        const std::uint32_t kind = random.below(10);
        if (kind < scene.triangles) {
            const vec3 b = place + random.in_cube(0.02), c = place + random.in_cube(0.02);
            builder.add_triangle(place, b, c);
        } else if (kind < scene.triangles + scene.spheres) {
            builder.add_sphere({place, static_cast<float>(random.uniform(0.001, 0.01))});
        } else {
            add_other(builder, place, random);
        }
    }
    return std::move(builder).build(scene.precision);
}

/// From nearly one point, in directions that spread.
std::vector<Ray> packets(double apart, double spread) {
    cases::Random random(2);
    std::vector<Ray> rays;
    while (rays.size() < 4096) {
        const vec3 towards = vec3(-3) + random.in_cube(0.9);
        for (int i = 0; i < 64; ++i) {
            Ray ray;
            ray.origin = vec3(3, 3, 3.5f) + random.in_cube(apart);
            ray.direction = towards + random.in_cube(spread);
            ray.time = static_cast<float>(random.uniform(0, 1));
            rays.push_back(ray);
        }
    }
    return rays;
}

class Ways : public testing::TestWithParam<std::tuple<const char*, Scene>> {};

/// Asks for so many rays at once; returns what was counted.
Counters expect_answers_like_the_scalar_tree(const char* way, const Scene& scene,
                                             const std::vector<Ray>& rays, std::size_t batch_size) {
    const Geometry geometry = many_small_ones(scene);
    const BuildInput input{geometry};
    const auto scalar = build(built_in_catalogue(), "bvh", input);
    const auto tested = build(built_in_catalogue(), way, input);
    const auto truth = scalar->open(Mode::timing), session = tested->open(Mode::counting);
    std::vector<Hit> wanted(rays.size()), found(rays.size());
    std::vector<std::uint8_t> wanted_any(rays.size()), any(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += batch_size) {
        const RayBatch batch{RayKind::secondary, 1, std::span(rays).subspan(first, batch_size)};
        const auto of_batch = [&](auto& answers) {
            return std::span(answers).subspan(first, batch_size);
        };
        truth->closest(batch, of_batch(wanted));
        session->closest(batch, of_batch(found));
        truth->occluded(batch, of_batch(wanted_any));
        session->occluded(batch, of_batch(any));
    }
    EXPECT_EQ(std::memcmp(found.data(), wanted.data(), found.size() * sizeof(Hit)), 0);
    EXPECT_EQ(any, wanted_any);
    const Counters counted = *session->counters(RayKind::secondary);
    EXPECT_GT(counted[Event::hit], 500u);
    return counted;
}

bool makes_packets(std::string_view way) {
    return way.find("packets=off") == std::string_view::npos;
}

TEST_P(Ways, answer_like_the_scalar_tree_where_groups_go_on_by_themselves) {
    const auto& [way, scene] = GetParam();
    const std::vector<Ray> rays = packets(0.05, 0.1);
    const Counters counted = expect_answers_like_the_scalar_tree(way, scene, rays, Packet::most);
    if (makes_packets(way)) {
        // For two questions. A packet's beam alone meets less than one node for each of 64 rays, a
        // ray alone 26 for one question, and more in the 4-wide tree.
        EXPECT_GT(counted[Event::step], rays.size());
        EXPECT_LT(counted[Event::step], 40 * rays.size());
    }
}

TEST_P(Ways, answer_like_the_scalar_tree_where_packets_give_way_to_rays_in_flight) {
    const auto& [way, scene] = GetParam();
    const std::vector<Ray> rays = packets(0.05, 0.25);
    const Counters counted = expect_answers_like_the_scalar_tree(way, scene, rays, rays.size());
    EXPECT_GT(counted[Event::step], 40 * rays.size());
}

TEST_P(Ways, answer_like_the_scalar_tree_where_packets_stay_together) {
    const auto& [way, scene] = GetParam();
    const std::vector<Ray> rays = packets(0.0005, 0.0005);
    const Counters counted = expect_answers_like_the_scalar_tree(way, scene, rays, rays.size());
    if (makes_packets(way)) {
        // For two questions. Alone a ray takes 26 steps for one, and 41 in the 4-wide tree, where
        // some beams meet more nodes than they may.
        const std::size_t most_of_a_ray = std::string_view(way).starts_with("bvh4") ? 16 : 4;
        EXPECT_LT(counted[Event::step], most_of_a_ray * rays.size());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Wide, Ways,
    testing::Combine(testing::Values("bvh8", "bvh8:flight=1", "bvh8:flight=16",
                                     "bvh8:packets=off,flight=64", "bvh4", "bvh4:build=fast",
                                     "bvh8q", "bvh8q:build=fast,leaf=1", "bvh8:build=fast,leaf=3"),
                     testing::ValuesIn(scenes)),
    [](const auto& test) {
        return std::to_string(test.index) + "_" + std::get<Scene>(test.param).name;
    });

}  // namespace
}  // namespace rayshoot

#include "tracer/bsdf/bsdf.h"

#include <gtest/gtest.h>

#include "tests/tracer/bsdf/materials.h"
#include "tests/tracer/bsdf/sphere_bins.h"
#include "tests/tracer/stream.h"

namespace rayshoot::tracer_tests {
namespace {

/// What is looked at, and how.
struct Look {
    Surface surface;
    double degrees;
    bool from_front;

    std::string name() const {
        return surface.name + " at " + std::to_string(degrees) + " degrees from " +
               (from_front ? "the front" : "behind");
    }
    vec3 out() const { return looking(degrees, from_front); }
    Bsdf bsdf() const { return bsdf_at(surface.material, out()); }
    /// Radiance from beyond the surface counts by this much less: (index beyond / index here)^2.
    float beyond() const {
        const float relative = from_front ? surface.index : 1 / surface.index;
        return relative * relative;
    }
};

/// From behind only where it differs.
std::vector<Look> looks() {
    std::vector<Look> all;
    for (const Surface& surface : surfaces()) {
        for (const double degrees : {5.0, 45.0, 80.0}) {
            all.push_back({surface, degrees, true});
            if (surface.index != 1) all.push_back({surface, degrees, false});
        }
    }
    return all;
}

/// Null hypothesis: samples have the density pdf() says, and what it leaves over is the share of
/// deltas and of nothing. Level 0.01 for all of them together (Bonferroni), N = 100 000 each.
TEST(Bsdf, samples_have_the_density_that_pdf_says) {
    constexpr int count = 100'000;
    constexpr double level = 0.01;
    const std::vector<Look> all = looks();
    std::uint32_t seed = 0;
    for (const Look& look : all) {
        const Bsdf bsdf = look.bsdf();
        std::vector<double> expected =
            SphereBins::integrals([&](const vec3& in) { return bsdf.pdf(in); });
        double rest = 1;
        for (double& share : expected) {
            rest -= share;
            share *= count;
        }
        ASSERT_GT(rest, -1e-3) << look.name();
        expected.push_back(std::max(0.0, rest) * count);
        std::vector<double> counts(expected.size());
        Stream random(++seed);
        for (int i = 0; i < count; ++i) {
            const auto sample = bsdf.sample(random.number(), random.pair());
            const bool counted = sample && !sample->delta;
            ++counts[counted ? SphereBins::bin(sample->in) : expected.size() - 1];
        }
        EXPECT_GT(chi_squared_p(counts, expected), level / static_cast<double>(all.size()))
            << look.name();
    }
}

TEST(Bsdf, weights_are_what_evaluate_and_pdf_say) {
    std::uint32_t seed = 0;
    for (const Look& look : looks()) {
        const Bsdf bsdf = look.bsdf();
        Stream random(++seed);
        for (int i = 0; i < 2000; ++i) {
            const auto sample = bsdf.sample(random.number(), random.pair());
            if (!sample) continue;
            EXPECT_NEAR(length(sample->in), 1, 1e-6) << look.name();
            if (sample->delta) {
                EXPECT_EQ(sample->pdf, 0) << look.name();
                continue;
            }
            // Rounding `in` moves the half vector, by up to 1e-6 of the narrowest lobe's width.
            const float pdf = bsdf.pdf(sample->in);
            ASSERT_NEAR(pdf / sample->pdf, 1, 5e-3) << look.name();
            const vec3 value = bsdf.evaluate(sample->in), product = sample->weight * sample->pdf;
            for (int channel = 0; channel < 3; ++channel) {
                ASSERT_NEAR(value[channel], product[channel], 5e-3 * product[channel] + 1e-7)
                    << look.name();
            }
        }
    }
}

/// f of radiance is reciprocal but for the square of the index at the side it comes out at.
TEST(Bsdf, is_reciprocal) {
    Stream random(1);
    for (const Surface& surface : surfaces()) {
        const auto index = [&](const vec3& direction) {
            return direction.z > 0 ? 1.0f : surface.index;
        };
        for (int i = 0; i < 3000; ++i) {
            const vec3 a = random.direction(), b = random.direction();
            if (std::min(std::abs(a.z), std::abs(b.z)) < 0.05f) continue;
            const vec3 there =
                bsdf_at(surface.material, a).evaluate(b) / (std::abs(b.z) * index(a) * index(a));
            const vec3 back =
                bsdf_at(surface.material, b).evaluate(a) / (std::abs(a.z) * index(b) * index(b));
            for (int channel = 0; channel < 3; ++channel) {
                ASSERT_NEAR(there[channel], back[channel], 1e-3f * there[channel] + 1e-6f)
                    << surface.name << ": " << a.x << ' ' << a.y << ' ' << a.z << ", " << b.x << ' '
                    << b.y << ' ' << b.z;
            }
        }
    }
}

/// What goes out when 1 comes in from everywhere, n^2 in a medium of index n.
vec3 furnace(const Look& look) {
    const Bsdf bsdf = look.bsdf();
    constexpr int strata = 64;
    Stream random(7);
    dvec3 sum(0);
    for (int i = 0; i < strata; ++i) {
        for (int j = 0; j < strata; ++j) {
            const Pair pair{(static_cast<float>(i) + random.number()) / strata,
                            (static_cast<float>(j) + random.number()) / strata};
            const auto place = static_cast<float>((i * 37 + j * 61) % 64);  // a stratum of 64
            const auto sample = bsdf.sample((place + random.number()) / strata, pair);
            if (!sample) continue;
            const bool passes = sample->in.z * look.out().z < 0;
            sum += dvec3(sample->weight * (passes ? look.beyond() : 1));
        }
    }
    return vec3(sum / double{strata * strata});
}

TEST(Bsdf, gives_no_more_than_it_gets_and_all_of_it_where_nothing_is_lost) {
    constexpr float noise = 0.01f;  // about four standard deviations of the noisiest
    for (const Look& look : looks()) {
        const vec3 albedo = furnace(look);
        EXPECT_LE(largest(albedo), 1 + noise) << look.name();
        EXPECT_GT(largest(albedo), 0.1f) << look.name();
        if (!look.surface.lossless) continue;
        EXPECT_NEAR(mean(albedo), 1, noise) << look.name();
    }
}

/// The same without chance, for all that has no delta.
TEST(Bsdf, integrates_to_no_more_than_one) {
    for (const Surface& surface : surfaces()) {
        if (surface.sharp) continue;
        for (const double degrees : {0.0, 45.0, 75.0, 89.0}) {
            for (const bool from_front : {true, false}) {
                if (!from_front && surface.index == 1) continue;  // the same
                const Look look{surface, degrees, from_front};
                const Bsdf bsdf = look.bsdf();
                const bool above = look.out().z > 0;
                const float beyond = look.beyond();
                const auto reflected_most = [&](const vec3& in) {
                    return largest(bsdf.evaluate(in)) * ((in.z > 0) == above ? 1 : beyond);
                };
                double sum = 0;
                for (const double part : SphereBins::integrals(reflected_most)) sum += part;
                EXPECT_LE(sum, 1 + 1e-3) << look.name();
            }
        }
    }
}

TEST(Bsdf, lets_no_light_leak_between_its_two_normals) {
    Stream random(3);
    int dark = 0, sampled = 0;
    for (const Surface& surface : surfaces()) {
        for (int i = 0; i < 300; ++i) {
            SurfacePoint point;
            point.geometric = random.direction();
            point.shading = normalised(point.geometric + 0.7f * random.direction());
            const vec3 out = random.direction();
            const Bsdf bsdf(surface.material, point, out);
            EXPECT_GT(dot(bsdf.normal(), out), 0);
            EXPECT_GT(dot(bsdf.normal(), point.geometric) * dot(out, point.geometric), 0);
            const auto same_side = [&](const vec3& in) {
                return dot(in, bsdf.normal()) * dot(in, point.geometric) *
                           dot(out, point.geometric) >
                       0;
            };
            const vec3 in = random.direction();
            if (!same_side(in)) {
                ++dark;
                EXPECT_EQ(bsdf.evaluate(in), vec3(0));
                EXPECT_EQ(bsdf.pdf(in), 0);
            }
            const auto sample = bsdf.sample(random.number(), random.pair());
            if (!sample) continue;
            ++sampled;
            EXPECT_TRUE(same_side(sample->in)) << surface.name;
        }
    }
    EXPECT_GT(dark, 500);
    EXPECT_GT(sampled, 2000);
}

TEST(Bsdf, stays_finite_at_grazing_angles) {
    Stream random(4);
    for (const Surface& surface : surfaces()) {
        for (const float height : {1e-3f, 1e-5f, 1e-7f, 0.0f}) {
            const vec3 out = normalised(vec3(1, 0.5f, height));
            const Bsdf bsdf = bsdf_at(surface.material, out);
            for (int i = 0; i < 200; ++i) {
                vec3 in = random.direction();
                if (i % 2) in = normalised(vec3(in.x, in.y, in.z * height));
                EXPECT_TRUE(finite(bsdf.evaluate(in))) << surface.name << ' ' << height;
                EXPECT_TRUE(std::isfinite(bsdf.pdf(in))) << surface.name << ' ' << height;
                const auto sample = bsdf.sample(random.number(), random.pair());
                if (!sample) continue;
                EXPECT_TRUE(finite(sample->weight)) << surface.name << ' ' << height;
            }
        }
    }
}

TEST(Bsdf, says_whether_only_deltas_are_left) {
    for (const Surface& surface : surfaces()) {
        const Bsdf bsdf = bsdf_at(surface.material, looking(30));
        double density = 0;
        for (const double part :
             SphereBins::integrals([&](const vec3& in) { return bsdf.pdf(in); }, 5))
            density += part;
        EXPECT_EQ(bsdf.only_deltas(), density == 0) << surface.name;
    }
}

TEST(RequirePhysical, refuses_what_no_surface_is) {
    const auto refused = [](auto change) {
        Material material;
        material.model = SurfaceModel::cook_torrance;
        require_physical(material);
        change(material);
        EXPECT_THROW(require_physical(material), std::invalid_argument);
    };
    refused([](Material& m) { m.colour.y = -0.1f; });
    refused([](Material& m) { m.diffuse = 1.1f; });
    refused([](Material& m) { m.specular = 1.1f; });
    refused([](Material& m) { m.shininess = -1; });
    refused([](Material& m) { m.roughness = 1.1f; });
    refused([](Material& m) { m.refraction_index = infinity; });
    refused([](Material& m) { m.absorption.x = std::nanf(""); });
    refused([](Material& m) { m.emission.z = -1; });
}

}  // namespace
}  // namespace rayshoot::tracer_tests

#include <gtest/gtest.h>

#include <complex>

#include "tests/tracer/bsdf/materials.h"
#include "tests/tracer/bsdf/sphere_bins.h"
#include "tests/tracer/stream.h"
#include "tracer/bsdf/fresnel.h"
#include "tracer/bsdf/ggx.h"

namespace rayshoot::tracer_tests {
namespace {

using Complex = std::complex<double>;

/// Born & Wolf: amplitudes of the two polarisations, by complex arithmetic throughout.
double fresnel_truth(double cosine, Complex index) {
    const Complex transmitted = std::sqrt(1.0 - (1 - cosine * cosine) / (index * index));
    const Complex across = (cosine - index * transmitted) / (cosine + index * transmitted);
    const Complex along = (index * cosine - transmitted) / (index * cosine + transmitted);
    return (std::norm(across) + std::norm(along)) / 2;
}

TEST(Fresnel, is_that_of_complex_amplitudes) {
    for (int i = 0; i <= 100; ++i) {
        const float cosine = static_cast<float>(i) / 100;
        for (const float index : {0.5f, 0.75f, 1.0f, 1.33f, 2.4f}) {
            if (index == 1 && i == 0) continue;  // 0 / 0
            EXPECT_NEAR(refraction(cosine, index).reflectance, fresnel_truth(cosine, index), 3e-5)
                << cosine << ' ' << index;
        }
        const vec3 eta(0.19f, 0.54f, 1.33f), absorption(3.4f, 2.2f, 1.9f);
        const vec3 metal = conductor_reflectance(cosine, eta, absorption);
        for (int channel = 0; channel < 3; ++channel) {
            const Complex index(eta[channel], -absorption[channel]);
            EXPECT_NEAR(metal[channel], fresnel_truth(cosine, index), 1e-5) << cosine;
        }
    }
}

TEST(Fresnel, has_the_known_values) {
    EXPECT_NEAR(refraction(1, 1.5f).reflectance, 0.04, 1e-6);
    EXPECT_EQ(refraction(0, 1.5f).reflectance, 1);
    // Brewster's angle, tan = n: only what is polarised across the plane comes back.
    const double n = 1.5, brewster = 1 / std::sqrt(1 + n * n);
    const double across = (n * n - 1) / (n * n + 1);
    EXPECT_NEAR(refraction(static_cast<float>(brewster), 1.5f).reflectance, across * across / 2,
                1e-6);
    // The critical angle, sin = 1 / n, from within.
    const auto cosine_of = [](double sine) {
        return static_cast<float>(std::sqrt(1 - sine * sine));
    };
    EXPECT_EQ(refraction(cosine_of(1 / n + 1e-4), 1 / 1.5f).reflectance, 1);
    EXPECT_LT(refraction(cosine_of(1 / n - 1e-4), 1 / 1.5f).reflectance, 0.95);
    // A conductor without absorption is a dielectric; at right angles ((n-1)^2+k^2)/((n+1)^2+k^2).
    EXPECT_NEAR(conductor_reflectance(0.5f, vec3(1.5f), vec3(0)).x,
                refraction(0.5f, 1.5f).reflectance, 1e-6);
    EXPECT_NEAR(conductor_reflectance(1, vec3(0.2f), vec3(3)).x, 9.64 / 10.44, 1e-6);
}

TEST(Fresnel, bends_by_snells_law) {
    const vec3 out = looking(40), normal(0, 0, 1);
    const Refraction at = refraction(out.z, 1.5f);
    const vec3 in = refracted(out, normal, out.z, 1.5f, at.transmitted_cosine);
    EXPECT_NEAR(length(in), 1, 1e-6);
    EXPECT_NEAR(-in.x * 1.5, out.x, 1e-6);
    EXPECT_LT(in.z, 0);
}

double sphere_integral(auto&& density) {
    double sum = 0;
    for (const double part : SphereBins::integrals(density)) sum += part;
    return sum;
}

TEST(Ggx, covers_the_surface_once) {
    for (const float alpha : {0.1f, 0.4f, 1.0f}) {
        const Ggx facets{alpha};
        const auto covered = [&](const vec3& normal) {
            return normal.z > 0 ? facets.density(normal) * normal.z : 0;
        };
        EXPECT_NEAR(sphere_integral(covered), 1, 1e-4) << alpha;
        for (const double degrees : {10.0, 50.0, 80.0, 89.0}) {
            const vec3 out = looking(degrees);
            // Smith 1967: the facets seen cover what is seen of the surface.
            const auto seen = [&](const vec3& normal) {
                return normal.z > 0 && dot(out, normal) > 0
                           ? facets.visible_density(out, normal, dot(out, normal))
                           : 0;
            };
            EXPECT_NEAR(sphere_integral(seen), 1, 2e-3) << alpha << ' ' << degrees;
        }
    }
}

TEST(Ggx, lambda_is_smiths_integral) {
    // 1 / cos * integral of the slopes steeper than the ray, for alpha = 1: (sqrt(1+tan^2)-1)/2.
    const Ggx facets{0.5f};
    const vec3 direction = looking(70);
    const double slope = 0.5 * std::tan(70 * std::numbers::pi / 180);
    EXPECT_NEAR(facets.lambda(direction), (std::sqrt(1 + slope * slope) - 1) / 2, 1e-5);
    EXPECT_NEAR(facets.lambda(looking(0.01)), 0.25 * 0.25 * 3.046e-8, 1e-10);
    EXPECT_EQ(facets.lambda(direction), facets.lambda(-direction));
}

/// At right angles and alpha = 1: D = 1 / pi and G1 = 2 cos / (1 + cos), so the integral of D G1 /
/// 4 is 1 - ln 2.
TEST(Conductor, keeps_1_minus_ln_2_when_as_rough_as_can_be) {
    const Conductor mirror(vec3(1), vec3(1), vec3(1e4f), 1);
    const vec3 out(0, 0, 1);
    const double albedo =
        sphere_integral([&](const vec3& in) { return mirror.evaluate(out, in).x; });
    EXPECT_NEAR(albedo, 1 - std::numbers::ln2, 5e-4);  // 4e-4 is absorbed
}

/// The table of README.md: what single scattering leaves of a white furnace.
TEST(Conductor, loses_what_the_table_says) {
    struct Row {
        float alpha;
        double at_0, at_60, at_85;
    };
    for (const Row& row : {Row{0.2f, 0.948, 0.895, 0.900}, Row{0.5f, 0.688, 0.698, 0.872},
                           Row{1.0f, 0.307, 0.451, 0.780}}) {
        const Conductor mirror(vec3(1), vec3(1), vec3(1e4f), row.alpha);
        const auto albedo = [&](double degrees) {
            const vec3 out = looking(degrees);
            return sphere_integral([&](const vec3& in) { return mirror.evaluate(out, in).x; });
        };
        EXPECT_NEAR(albedo(0), row.at_0, 2e-3) << row.alpha;
        EXPECT_NEAR(albedo(60), row.at_60, 2e-3) << row.alpha;
        EXPECT_NEAR(albedo(85), row.at_85, 2e-3) << row.alpha;
    }
}

TEST(OrenNayar, is_the_formula_of_angles) {
    const float sigma = 0.6f;
    const OrenNayar lobe(vec3(1), sigma);
    const double a = 1 - 0.5 * 0.36 / (0.36 + 0.33), b = 0.45 * 0.36 / (0.36 + 0.09);
    ASSERT_LT(a + b / 2, 1);  // nothing is scaled
    Stream random(5);
    for (int i = 0; i < 100; ++i) {
        vec3 out = random.direction(), in = random.direction();
        out.z = std::abs(out.z), in.z = std::abs(in.z);
        const double polar_out = std::acos(double{out.z}), polar_in = std::acos(double{in.z});
        const double turn = std::cos(std::atan2(out.y, out.x) - std::atan2(in.y, in.x));
        const double expected =
            in.z / std::numbers::pi *
            (a + b * std::max(0.0, turn) * std::sin(std::max(polar_out, polar_in)) *
                     std::tan(std::min(polar_out, polar_in)));
        EXPECT_NEAR(lobe.evaluate(out, in).x, expected, 1e-4);
    }
}

TEST(OrenNayar, without_slopes_is_lambert) {
    const OrenNayar lobe(vec3(0.7f), 0);
    const Lambert lambert(vec3(0.7f));
    const vec3 out = looking(70), in = looking(-30);
    EXPECT_EQ(lobe.evaluate(out, in), lambert.evaluate(out, in));
}

TEST(Phong, of_exponent_0_is_lambert) {
    const Phong lobe(vec3(0), 1, 0);
    EXPECT_NEAR(lobe.evaluate(looking(10), looking(-40)).x, looking(-40).z / std::numbers::pi,
                1e-6);
}

TEST(Phong, reflects_all_that_falls_at_right_angles) {
    const Phong lobe(vec3(0), 1, 20);
    const vec3 out(0, 0, 1);
    EXPECT_NEAR(sphere_integral([&](const vec3& in) { return lobe.evaluate(out, in).x; }), 1, 1e-4);
}

Material nff_material(float diffuse, float specular, float transmittance, float index = 1) {
    Material material;
    material.diffuse = diffuse;
    material.specular = specular;
    material.transmittance = transmittance;
    material.refraction_index = index;
    material.shininess = 18;
    return material;
}

/// A light without falloff gives pi I; Whitted's shading of it is I (Kd cos + Ks cos^n).
TEST(Nff, shows_lights_as_whitteds_shading_does) {
    const Material material = nff_material(0.5f, 0.3f, 0);
    const vec3 out = looking(40), in = looking(-50);
    const float mirror_cosine = std::cos(10 * std::numbers::pi_v<float> / 180);
    const float highlight = 0.3f * std::pow(mirror_cosine, 18.0f) * in.z;  // f cos: with a cosine
    const vec3 value = bsdf_at(material, out).evaluate(in);
    EXPECT_NEAR(pi * value.x, 0.5f * in.z + highlight, 1e-5);
}

struct Deltas {
    double mirrored = 0, refracted = 0;
};

Deltas deltas(const Material& material, const vec3& out) {
    Deltas sum;
    constexpr int count = 10'000;
    for (int i = 0; i < count; ++i) {
        const float choice = (static_cast<float>(i) + 0.5f) / count;
        const auto sample = bsdf_at(material, out).sample(choice, {0.5f, 0.5f});
        if (!sample || !sample->delta) continue;
        (sample->in.z * out.z > 0 ? sum.mirrored : sum.refracted) += sample->weight.x / count;
    }
    return sum;
}

TEST(Nff, mirrors_and_refracts_its_shares) {
    const Deltas outside = deltas(nff_material(0.2f, 0.3f, 0.4f, 1.5f), looking(30));
    EXPECT_NEAR(outside.mirrored, 0.3, 1e-3);
    EXPECT_NEAR(outside.refracted, 0.4 / 2.25, 1e-3);  // radiance comes out of glass
    const Deltas total = deltas(nff_material(0.2f, 0.3f, 0.4f, 1.5f), looking(60, false));
    EXPECT_NEAR(total.mirrored, 0.7, 1e-3);
    EXPECT_EQ(total.refracted, 0);
}

TEST(Nff, is_scaled_down_to_what_comes_in) {
    const Deltas all = deltas(nff_material(1, 1, 1), looking(30));
    const double sum = 1 + 1 + 2 * 1 / 20.0 + 1;
    EXPECT_NEAR(all.mirrored, 1 / sum, 1e-3);
    EXPECT_NEAR(all.refracted, 1 / sum, 1e-3);
}

TEST(Nff, is_a_perfect_mirror_where_it_has_nothing_else) {
    Material material = nff_material(0, 1, 0);
    material.shininess = 1e9f;
    EXPECT_NEAR(deltas(material, looking(30)).mirrored, 1, 1e-6);
}

TEST(Dielectric, sharp_deltas_are_fresnels_shares) {
    Material glass;
    glass.model = SurfaceModel::dielectric;
    glass.refraction_index = 1.5f;
    const vec3 out = looking(50);
    const double share = fresnel_truth(out.z, 1.5);
    const Deltas outside = deltas(glass, out);
    EXPECT_NEAR(outside.mirrored, share, 1e-3);
    EXPECT_NEAR(outside.refracted, (1 - share) / 2.25, 1e-3);
    EXPECT_NEAR(deltas(glass, looking(60, false)).mirrored, 1, 1e-6);
}

/// As the lobe narrows it becomes the sharp model: the same albedo, round the same direction.
TEST(Dielectric, narrow_facets_are_almost_sharp) {
    const vec3 out = looking(50);
    const Dielectric lobe(vec3(1), 1.5f, 2e-3f);
    Stream random(9);
    dvec3 up(0), down(0);
    int mirrored_count = 0, sampled = 0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
        const auto sample = lobe.sample(out, random.number(), random.pair());
        if (!sample) continue;
        ++sampled;
        mirrored_count += sample->in.z > 0;
        (sample->in.z > 0 ? up : down) += dvec3(sample->in);
    }
    EXPECT_GT(sampled, count - 10);  // few facets stand so steep that light goes astray
    EXPECT_NEAR(static_cast<double>(mirrored_count) / count, fresnel_truth(out.z, 1.5), 0.01);
    EXPECT_LT(length(normalised(up) - dvec3(mirrored(out))), 2e-3);
    const double cosine = refraction(out.z, 1.5f).transmitted_cosine;
    EXPECT_NEAR(normalised(down).z, -cosine, 2e-3);
}

}  // namespace
}  // namespace rayshoot::tracer_tests

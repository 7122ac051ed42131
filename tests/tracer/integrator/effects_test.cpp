#include <gtest/gtest.h>

#include "tests/tracer/integrator/every_effect.h"
#include "tests/tracer/test_scenes.h"
#include "tracer/settings.h"

namespace rayshoot {
namespace {

using tracer_tests::every_effect;

RenderResult rendered(const Scene& scene, const std::string& spec, const std::string& settings,
                      int threads) {
    ImageSettings image;
    apply_settings(settings, image);
    RenderSettings& how = image.render;
    how.format.width = 48;
    how.format.height = 36;
    how.format.raster = Raster::centres;
    how.threads = threads;
    const auto accel = build(built_in_catalogue(), spec, build_input(scene, how));
    return render(scene, *accel, how);
}

/// Every way to expose a pixel, with each method that follows light.
class EveryEffect : public testing::TestWithParam<std::string> {};

TEST_P(EveryEffect, gives_the_same_bits_by_every_structure_on_any_number_of_threads) {
    const Scene scene = every_effect();
    const RenderResult reference = rendered(scene, "bvh", GetParam(), 1);
    std::size_t lit = 0;
    for (const vec3& pixel : reference.image.pixels()) {
        ASSERT_TRUE(finite(pixel));
        lit += pixel != vec3(0);
    }
    EXPECT_GT(lit, reference.image.pixels().size() / 2);
    for (const StructureEntry& entry : built_in_catalogue()) {
        if (entry.agreement != Agreement::exact || !entry.complete) continue;
        for (const int threads : {1, 2}) {
            const RenderResult other =
                rendered(scene, std::string(entry.name), GetParam(), threads);
            EXPECT_EQ(other.image, reference.image) << entry.name << " on " << threads;
            EXPECT_EQ(other.counts, reference.counts) << entry.name << " on " << threads;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Settings, EveryEffect,
    testing::Values("spp=4", "spp=4,filter=hann,radius=1.6,reconstruct=splat,time=cook",
                    "spp=4,filter=cone,radius=1.5,reconstruct=splat_undivided,sampler=random",
                    "spp=4,filter=gaussian,radius=1.5,reconstruct=weighted,sampler=gaussian",
                    "spp=4,light_samples=6,shutter=triangle",
                    "method=path,spp=4,sampler=sobol,order=blue_noise,filter=mitchell,radius=2",
                    "method=path,depth=3,least=4,round=4,most=12,tolerance=0.02",
                    "method=path,least=4,most=12,tolerance=0.02,adaptive=two_pass",
                    "method=irradiance,spp=2,gather=16,cache_error=0.5"),
    [](const auto& test) { return "number_" + std::to_string(test.index); });

}  // namespace
}  // namespace rayshoot

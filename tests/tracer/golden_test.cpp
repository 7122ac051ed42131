#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/tracer/spd_scenes.h"

/// Images of the SPD scenes at 64 x 64: the same bits from every structure, thread count and
/// compiler. golden_images.csv holds their digests; run with RAYSHOOT_WRITE_GOLDEN=<file> to append
/// new ones after a change that is meant to change images.
namespace rayshoot {
namespace {

RenderSettings settings(int threads) {
    RenderSettings result;
    result.format = {64, 64, 1, Raster::corners, 0};
    result.threads = threads;
    return result;
}

std::map<std::string, std::string> golden_digests() {
    std::ifstream in("tests/tracer/golden_images.csv");
    std::string line;
    std::getline(in, line);  // scene,sha256
    std::map<std::string, std::string> digests;
    while (std::getline(in, line)) {
        const std::size_t comma = line.find(',');
        digests[line.substr(0, comma)] = line.substr(comma + 1);
    }
    return digests;
}

class SpdImages : public testing::TestWithParam<const char*> {};

TEST_P(SpdImages, agree_bit_for_bit) {
    const Scene scene = tracer_tests::spd_scene(GetParam());
    const Image reference = tracer_tests::render(scene, "bvh", settings(1)).image;
    EXPECT_EQ(tracer_tests::render(scene, "bvh", settings(2)).image, reference);
    EXPECT_EQ(tracer_tests::render(scene, "brute_force", settings(2)).image, reference);
    EXPECT_EQ(digest(reference), golden_digests()[GetParam()]);
    if (const char* file = std::getenv("RAYSHOOT_WRITE_GOLDEN")) {
        std::ofstream(file, std::ios::app) << GetParam() << ',' << digest(reference) << '\n';
    }
}

INSTANTIATE_TEST_SUITE_P(Spd, SpdImages, testing::ValuesIn(tracer_tests::spd_names),
                         [](const auto& scene) { return std::string(scene.param); });

/// Every length of the teapot scene times `factor`.
TEST(Teapot, scale_does_not_show) {
    const Scene scene = tracer_tests::scaled(tracer_tests::spd_scene("teapot"), 1);
    const Image reference = tracer_tests::render(scene, "bvh", settings(2)).image;
    for (const float factor : {0x1p-20f, 0x1p20f}) {
        const Scene other = tracer_tests::scaled(scene, factor);
        EXPECT_EQ(tracer_tests::render(other, "bvh", settings(2)).image, reference) << factor;
    }
    for (const float factor : {1e-6f, 1e6f}) {
        const Scene other = tracer_tests::scaled(scene, factor);
        const Image image = tracer_tests::render(other, "bvh", settings(2)).image;
        std::size_t differing = 0;
        for (std::size_t i = 0; i < image.pixels().size(); ++i) {
            differing += taxicab(image.pixels()[i] - reference.pixels()[i]) > 1e-3f;
        }
        EXPECT_LE(differing, 8u) << factor;  // of 4096: silhouettes and edges of the checkerboard
    }
}

}  // namespace
}  // namespace rayshoot

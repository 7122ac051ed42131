#include "bench/streams/ray_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

namespace rayshoot {
namespace {

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::path(testing::TempDir()) /
           (std::to_string(getpid()) + "_rayshoot_" + name);
}

RayStream specimen() {
    RayStream stream;
    stream.scene = "spd/tetra:size=2";
    stream.kind = StreamKind::shadow;
    stream.batch_kind = RayKind::shadow;
    stream.question = Query::occluded;
    stream.depth = 2;
    stream.width = 3;
    stream.height = 5;
    stream.samples = 7;
    for (int i = 0; i < 10; ++i) {
        Ray ray;
        ray.origin = vec3{static_cast<float>(i), -0.0f, 1e-40f};
        ray.t_max = i % 2 == 0 ? infinity : std::nextafter(1.0f, 0.0f);
        ray.t_min = -infinity;
        ray.time = 0.25f;
        stream.rays.push_back(ray);
        stream.sources.push_back(Source::light(static_cast<std::uint32_t>(i)));
    }
    return stream;
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(RayFile, gives_back_what_was_written_bit_for_bit) {
    const RayStream stream = specimen();
    write_ray_file(scratch("round.rays"), stream);
    const RayStream back = read_ray_file(scratch("round.rays"));
    EXPECT_EQ(back.scene, stream.scene);
    EXPECT_EQ(back.kind, stream.kind);
    EXPECT_EQ(back.batch_kind, stream.batch_kind);
    EXPECT_EQ(back.question, stream.question);
    EXPECT_EQ(back.depth, stream.depth);
    EXPECT_EQ(back.width, 3);
    EXPECT_EQ(back.height, 5);
    EXPECT_EQ(back.samples, 7);
    ASSERT_EQ(back.size(), stream.size());
    EXPECT_EQ(std::memcmp(back.rays.data(), stream.rays.data(), sizeof(Ray) * stream.size()), 0);
    ASSERT_EQ(back.sources.size(), stream.sources.size());
    for (std::size_t i = 0; i < back.sources.size(); ++i)
        EXPECT_EQ(back.sources[i].bits, stream.sources[i].bits);
}

TEST(RayFile, is_laid_out_as_documented) {
    write_ray_file(scratch("layout.rays"), specimen());
    const std::string bytes = bytes_of(scratch("layout.rays"));
    EXPECT_EQ(bytes.size(), 56 + 16 + 10 * 36 + 10 * 4u);
    EXPECT_EQ(bytes.substr(0, 8), "RAYSHOOT");
    EXPECT_EQ(bytes.substr(8, 4), std::string("\1\0\0\0", 4));
    EXPECT_EQ(bytes.substr(28, 4), std::string("\3\0\0\0", 4));
    EXPECT_EQ(bytes.substr(48, 8), std::string("\12\0\0\0\0\0\0\0", 8));
    EXPECT_EQ(bytes.substr(56, 16), "spd/tetra:size=2");
}

/// Every single byte of the header set to 255: refused or, where any number will do, read; and
/// never a count that the size of the file does not bear out.
TEST(RayFile, damaged_headers_are_refused_and_never_believed) {
    write_ray_file(scratch("whole.rays"), specimen());
    const std::string whole = bytes_of(scratch("whole.rays"));
    for (std::size_t at = 0; at < 56; ++at) {
        std::string damaged = whole;
        damaged[at] = '\xff';
        std::ofstream(scratch("damaged.rays"), std::ios::binary) << damaged;
        try {
            EXPECT_EQ(read_ray_file(scratch("damaged.rays")).size(), 10u) << at;
        } catch (const std::runtime_error& refusal) {
            EXPECT_NE(std::string(refusal.what()).find("byte "), std::string::npos) << at;
        }
    }
}

TEST(RayFile, every_truncation_is_refused) {
    write_ray_file(scratch("whole.rays"), specimen());
    const std::string whole = bytes_of(scratch("whole.rays"));
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        std::ofstream(scratch("short.rays"), std::ios::binary) << whole.substr(0, size);
        EXPECT_THROW(read_ray_file(scratch("short.rays")), std::runtime_error) << size;
    }
    std::ofstream(scratch("long.rays"), std::ios::binary) << whole << "x";
    EXPECT_THROW(read_ray_file(scratch("long.rays")), std::runtime_error);
}

TEST(RayFile, what_is_not_there_is_named) {
    EXPECT_THROW(read_ray_file(scratch("absent.rays")), std::runtime_error);
    EXPECT_THROW(read_ray_file(testing::TempDir()), std::runtime_error);
    EXPECT_THROW(write_ray_file(testing::TempDir(), specimen()), std::invalid_argument);
}

TEST(Sample, is_spread_seeded_and_ascending) {
    const auto sample = spread_sample(1000, 10, 3);
    ASSERT_EQ(sample.size(), 10u);
    for (std::size_t i = 0; i < sample.size(); ++i) EXPECT_EQ(sample[i] / 100, i);
    EXPECT_EQ(sample, spread_sample(1000, 10, 3));
    EXPECT_NE(sample, spread_sample(1000, 10, 4));
    EXPECT_EQ(spread_sample(3, 10, 1), (std::vector<std::size_t>{0, 1, 2}));
}

}  // namespace
}  // namespace rayshoot

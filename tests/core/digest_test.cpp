#include <gtest/gtest.h>

#include "tests/core/digest.h"

/// The same bits from every compiler, build type and instruction set. A deliberate change of a
/// primitive test changes its line: take the new one from core_digest, built with g++ and clang.
namespace rayshoot {
namespace {

TEST(Digest, of_triangles) {
    EXPECT_EQ(hit_digest(PrimitiveKind::triangle, Precision::standard), 0x2b94085046797e86u);
}
TEST(Digest, of_watertight_triangles) {
    EXPECT_EQ(hit_digest(PrimitiveKind::triangle, Precision::watertight), 0x91c6560dae76be52u);
}
TEST(Digest, of_spheres) {
    EXPECT_EQ(hit_digest(PrimitiveKind::sphere, Precision::standard), 0xc4522c2a67c3ba49u);
}
TEST(Digest, of_frusta) {
    EXPECT_EQ(hit_digest(PrimitiveKind::frustum, Precision::standard), 0xfc6f2c47d084caaeu);
}
TEST(Digest, of_polygons) {
    EXPECT_EQ(hit_digest(PrimitiveKind::polygon, Precision::standard), 0x51fb95cba9e34cd5u);
}

}  // namespace
}  // namespace rayshoot

#include <gtest/gtest.h>

#include "accel/core/vec.h"

/// What the arithmetic of every test relies on, and what a compiler or its flags may break.
namespace rayshoot {
namespace {

struct Start {
    vec3 origin;
    dvec3 rest;  ///< what the rounding of the origin left over
};

[[gnu::noinline]] Start start(const dvec3& target, const dvec3& direction, double away) {
    Start s{};
    s.origin = vec3(target - away * direction);
    s.rest = target - dvec3(s.origin);
    return s;
}

TEST(Compiler, rounds_double_to_float_and_back) {
    const dvec3 target(0.1, 0.2, 0.3), direction(0.3, 0.4, 0.5);
    const Start s = start(target, direction, 0.7);
    for (int axis = 0; axis < 3; ++axis) {
        const volatile float stored = s.origin[axis];
        const volatile double widened = stored;
        EXPECT_EQ(s.rest[axis], target[axis] - widened);
    }
}

[[gnu::noinline]] void round_trip(const double* from, double* to, int count) {
    for (int i = 0; i < count; ++i) to[i] = static_cast<double>(static_cast<float>(from[i] * 3));
}

TEST(Compiler, rounds_double_to_float_and_back_in_loops) {
    std::array<double, 64> from{}, to{};
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = 0.1 * static_cast<double>(i + 1);
    round_trip(from.data(), to.data(), 64);
    for (std::size_t i = 0; i < from.size(); ++i) {
        const volatile double product = from[i] * 3;
        const volatile float rounded = static_cast<float>(product);
        EXPECT_EQ(to[i], double(rounded));
    }
}

[[gnu::noinline]] double product_sum(double a, double b, double c) { return a * b + c; }

TEST(Compiler, contracts_nothing_that_is_not_an_explicit_fma) {
    const double a = 1 + 0x1p-30, rounded = 1 + 0x1p-29;  // a * a = rounded + 2^-60
    EXPECT_EQ(product_sum(a, a, -rounded), 0);
    EXPECT_EQ(std::fma(a, a, -rounded), 0x1p-60);
}

TEST(Compiler, keeps_denormals_and_signed_zeros) {
    const volatile float smallest = 0x1p-149f, half = 0.5f;
    EXPECT_GT(smallest * 2.0f, 0.0f);
    EXPECT_EQ(smallest * half, 0.0f);
    EXPECT_TRUE(std::signbit(-smallest * half));
}

}  // namespace
}  // namespace rayshoot

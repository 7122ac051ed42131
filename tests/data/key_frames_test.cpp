#include "data/key_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rayshoot {
namespace {

std::vector<Key<dvec3>> random_positions(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1), step(0.1, 2);
    std::vector<Key<dvec3>> keys;
    double time = -1;
    for (std::size_t i = 0; i < count; ++i) {
        Key<dvec3>& key = keys.emplace_back();
        key.time = time += step(random);
        for (int axis = 0; axis < 3; ++axis) key.value[axis] = 3 * number(random);
        const double tension = number(random), continuity = number(random);
        key.shape = {tension, continuity, number(random)};
    }
    return keys;
}

TEST(KeyFrames, go_through_all_keys_but_the_outer_ones_and_stand_still_outside) {
    const auto keys = random_positions(1, 9);
    const PositionTrack track(keys);
    for (std::size_t i = 1; i + 1 < keys.size(); ++i)
        EXPECT_LT(length(track.at(keys[i].time) - keys[i].value), 1e-12);
    EXPECT_EQ(track.at(keys[0].time), keys[1].value);
    EXPECT_LT(length(track.at(1e9) - keys[7].value), 1e-12);
}

/// BART's wheels have such keys: their times are rounded.
TEST(KeyFrames, of_one_time_are_a_jump) {
    for (const std::size_t first : {std::size_t{1}, std::size_t{3}, std::size_t{5}}) {
        auto keys = random_positions(5, 8);
        keys[first + 1].time = keys[first].time;
        const PositionTrack track(keys);
        for (double time = -2; time < 12; time += 0.01) EXPECT_TRUE(finite(track.at(time)));
        const double jump = keys[first].time;
        if (first > 1) {
            EXPECT_LT(length(track.at(jump - 1e-9) - keys[first].value), 1e-6);
        }
        EXPECT_LT(length(track.at(jump) - keys[first + 1].value), 1e-12);
    }
}

/// Catmull & Rom 1974, in the basis of the four points.
TEST(KeyFrames, of_no_shape_and_even_times_are_a_catmull_rom_spline) {
    std::vector<Key<dvec3>> keys = random_positions(2, 6);
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = {double(i), keys[i].value, {}};
    const PositionTrack track(keys);
    for (double time = 1; time < 4; time += 0.0625) {
        const auto i = static_cast<std::size_t>(time);
        const double u = time - double(i);
        const dvec3 &a = keys[i - 1].value, &b = keys[i].value, &c = keys[i + 1].value,
                    &d = keys[i + 2].value;
        const dvec3 wanted =
            0.5 * (2.0 * b + u * (c - a) + u * u * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                   u * u * u * (3.0 * b - a - 3.0 * c + d));
        EXPECT_LT(length(track.at(time) - wanted), 1e-12) << time;
    }
}

/// What the three parameters are for (Kochanek & Bartels 1984): on a straight, evenly timed way
/// the speed at a key, in units of the way's, is (1 - tension) and does not depend on the others.
TEST(KeyFrames, tension_slows_down_at_the_key) {
    for (const double tension : {-1.0, 0.0, 0.5, 1.0})
        for (const KeyShape shape :
             {KeyShape{tension, 0, 0}, {tension, 0.5, 0}, {tension, 0, 0.7}}) {
            std::vector<Key<dvec3>> keys;
            for (int i = 0; i < 5; ++i) keys.push_back({double(i), dvec3(2 * i, 0, 0), shape});
            const PositionTrack track(keys);
            constexpr double h = 1e-6;
            EXPECT_NEAR((track.at(2 + h).x - track.at(2).x) / h, 2 * (1 - tension), 1e-4);
            EXPECT_NEAR((track.at(2).x - track.at(2 - h).x) / h, 2 * (1 - tension), 1e-4);
        }
}

/// With bias 1 the way before the key alone decides its tangent, with -1 the way after it.
TEST(KeyFrames, bias_prefers_the_way_before_the_key) {
    for (const double bias : {-1.0, 1.0}) {
        std::vector<Key<dvec3>> keys;
        for (const double x : {0.0, 1.0, 3.0, 8.0})
            keys.push_back({double(keys.size()), dvec3(x, 0, 0), {0, 0, bias}});
        const double speed = (PositionTrack(keys).at(1 + 1e-6).x - 1) / 1e-6;
        EXPECT_NEAR(speed, bias > 0 ? 1 : 2, 1e-4);
    }
}

/// Times that are unequal leave the velocity continuous, for keys without a shape.
TEST(KeyFrames, have_no_jolt_at_unequal_steps) {
    std::vector<Key<dvec3>> keys = random_positions(3, 8);
    for (Key<dvec3>& key : keys) key.shape = {};
    const PositionTrack track(keys);
    constexpr double h = 1e-6;
    for (std::size_t i = 2; i + 2 < keys.size(); ++i) {
        const double t = keys[i].time;
        const dvec3 before = (track.at(t) - track.at(t - h)) / h;
        const dvec3 after = (track.at(t + h) - track.at(t)) / h;
        EXPECT_LT(length(before - after), 1e-4 * (1 + length(before)));
    }
}

/// Rotations about one axis commute, so the quadrangle is the cubic of the angles.
TEST(KeyFrames, of_rotations_about_one_axis_are_those_of_the_angles) {
    std::vector<Key<dvec3>> angles = random_positions(4, 9);
    const dvec3 axis = normalised(dvec3(1, -2, 0.5));
    std::vector<Key<glm::dquat>> keys;
    for (const Key<dvec3>& angle : angles)  // less than half a turn from key to key
        keys.push_back({angle.time, glm::angleAxis(0.5 * angle.value.x, axis), angle.shape});
    const PositionTrack track(angles);
    const RotationTrack rotations(keys);
    for (double time = angles[1].time; time < angles[7].time; time += 0.01) {
        const glm::dquat wanted = glm::angleAxis(0.5 * track.at(time).x, axis);
        EXPECT_GT(std::abs(glm::dot(rotations.at(time), wanted)), 1 - 1e-12) << time;
    }
}

TEST(KeyFrames, of_rotations_take_the_shorter_way) {
    std::vector<Key<glm::dquat>> keys;
    for (const double degrees : {0.0, 350.0, 710.0, 700.0, 1050.0})  // 0, -10, -10, -20, -30
        keys.push_back({double(keys.size()),
                        glm::angleAxis(degrees * std::numbers::pi / 180, dvec3(0, 1, 0)),
                        {}});
    const RotationTrack track(keys);
    for (double time = 0; time < 4; time += 0.05) {
        const dvec3 x = track.at(time) * dvec3(1, 0, 0);
        const double angle = std::atan2(-x.z, x.x) * 180 / std::numbers::pi;
        EXPECT_LT(angle, -8);
        EXPECT_GT(angle, -22);
    }
}

TEST(KeyFrames, visibility_switches_at_its_keys) {
    KeyFrames frames;
    EXPECT_TRUE(frames.visible(0));
    frames.visibility = {{0.5, false, {}}, {2.0, true, {}}};
    EXPECT_TRUE(frames.visible(0.49));
    EXPECT_FALSE(frames.visible(0.5));
    EXPECT_FALSE(frames.visible(1.99));
    EXPECT_TRUE(frames.visible(2));
}

TEST(KeyFrames, scale_before_they_turn_and_turn_before_they_shift) {
    const auto constant = [](const dvec3& value) {
        return PositionTrack({{0, value, {}}, {1, value, {}}, {2, value, {}}, {3, value, {}}});
    };
    KeyFrames frames;
    frames.translation = constant({10, 0, 0});
    frames.scale = constant({2, 3, 1});
    const glm::dquat quarter = glm::angleAxis(std::numbers::pi / 2, dvec3(0, 0, 1));
    frames.rotation =
        RotationTrack({{0, quarter, {}}, {1, quarter, {}}, {2, quarter, {}}, {3, quarter, {}}});
    const dvec3 there(frames.matrix(1.5) * glm::dvec4(1, 1, 1, 1));
    EXPECT_LT(length(there - dvec3(7, 2, 1)), 1e-12);
}

}  // namespace
}  // namespace rayshoot

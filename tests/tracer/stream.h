#pragma once

#include <cstdint>

#include "accel/core/vec.h"
#include "tracer/random.h"
#include "tracer/sampling/pair.h"

namespace rayshoot::tracer_tests {

/// Random numbers one after the other.
class Stream {
public:
    explicit Stream(std::uint32_t seed) : random_(seed, 0, 0) {}
    float number() { return random_.number(next_++); }
    Pair pair() { return {number(), number()}; }
    float between(float lo, float hi) { return lo + (hi - lo) * number(); }
    vec3 in_cube() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
    /// Uniform on the sphere: the first of the cube's points that is in the ball.
    vec3 direction() {
        while (true) {
            const vec3 point = in_cube();
            const float size = length(point);
            if (size <= 1 && size > 0.01f) return point / size;
        }
    }

private:
    RandomSequence random_;
    std::uint32_t next_ = 0;
};

}  // namespace rayshoot::tracer_tests

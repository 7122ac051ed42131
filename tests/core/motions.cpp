#include "tests/core/motions.h"

namespace rayshoot::cases {
namespace {

Motion::Quaternion quaternion(Random& random) {
    dvec3 v = random.unit();
    const double w = random.uniform(-1, 1), size = std::sqrt(dot(v, v) + w * w);
    v /= size;
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
            static_cast<float>(w / size)};
}

/// The rows of the rotation matrix of the normalised lerp.
std::array<dvec3, 3> rotation(const Motion& m, double time) {
    std::array<double, 4> q{};
    std::array<double, 2> sizes{};
    for (std::size_t end = 0; end < 2; ++end) {
        for (const float c : m.rotation[end]) sizes[end] += double(c) * double(c);
        sizes[end] = std::sqrt(sizes[end]);
    }
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        q[i] = (1 - time) * m.rotation[0][i] / sizes[0] + time * m.rotation[1][i] / sizes[1];
        square += q[i] * q[i];
    }
    const double x = q[0], y = q[1], z = q[2], w = q[3], s = 2 / square;
    return {dvec3(1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)),
            dvec3(s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)),
            dvec3(s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y))};
}

dvec3 shift(const Motion& m, double time) {
    return (1 - time) * dvec3(m.translation[0]) + time * dvec3(m.translation[1]);
}

}  // namespace

Motion motion(Random& random) {
    for (;;) {
        Motion m;
        m.pivot = random.in_cube(2);
        m.translation = {random.in_cube(1), random.in_cube(1)};
        m.rotation[0] = quaternion(random);
        m.rotation[1] = quaternion(random);
        double cosine = 0;
        for (std::size_t i = 0; i < 4; ++i)
            cosine += double(m.rotation[0][i]) * double(m.rotation[1][i]);
        if (cosine > -0.9) return m;
    }
}

dvec3 moved(const Motion& motion, double time, const dvec3& point) {
    const auto rows = rotation(motion, time);
    const dvec3 p = point - dvec3(motion.pivot);
    return dvec3(dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)) + dvec3(motion.pivot) +
           shift(motion, time);
}

dvec3 moved_back(const Motion& motion, double time, const dvec3& point) {
    const auto rows = rotation(motion, time);
    const dvec3 p = point - shift(motion, time) - dvec3(motion.pivot);
    return p.x * rows[0] + p.y * rows[1] + p.z * rows[2] + dvec3(motion.pivot);
}

}  // namespace rayshoot::cases

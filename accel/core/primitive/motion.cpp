#include "accel/core/primitive/motion.h"

#include <algorithm>
#include <stdexcept>

#include "accel/core/primitive/rounding.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Unit quaternion in double: vector part and scalar part.
struct Rotation {
    dvec3 vector;
    double scalar;

    Rotation(const dvec3& v, double s) : vector(v), scalar(s) {
        const double size = std::sqrt(std::fma(scalar, scalar, dot(vector, vector)));
        vector /= size;
        scalar /= size;
    }
    explicit Rotation(const Motion::Quaternion& q) : Rotation(dvec3(q[0], q[1], q[2]), q[3]) {}

    dvec3 apply(const dvec3& x) const {
        const dvec3 twice = 2.0 * cross(vector, x);
        return x + scalar * twice + cross(vector, twice);
    }
    dvec3 undo(const dvec3& x) const {
        const dvec3 twice = 2.0 * cross(vector, x);
        return x - scalar * twice + cross(vector, twice);
    }
    double dot_with(const Rotation& other) const {
        return std::fma(scalar, other.scalar, dot(vector, other.vector));
    }
};

dvec3 translation_at(const Motion& motion, double time) {
    const dvec3 from(motion.translation[0]), to(motion.translation[1]);
    return (1 - time) * from + time * to;
}

/// Normalised lerp: turns about one fixed axis, at not quite constant speed.
Rotation rotation_at(const Motion& motion, double time) {
    const Rotation from(motion.rotation[0]), to(motion.rotation[1]);
    return {(1 - time) * from.vector + time * to.vector,
            (1 - time) * from.scalar + time * to.scalar};
}

std::array<dvec3, 8> corners(const Box& box) {
    std::array<dvec3, 8> all;
    for (std::size_t corner = 0; corner < all.size(); ++corner)
        all[corner] = {corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                       corner & 4 ? box.hi.z : box.lo.z};
    return all;
}

/// Where the corners are at one time: turned round the pivot, and how far they have moved with it.
struct Pose {
    Rotation rotation;
    dvec3 translation;
    std::array<dvec3, 8> turned;

    Pose(const Motion& motion, const std::array<dvec3, 8>& from_pivot, double time)
        : rotation(rotation_at(motion, time)), translation(translation_at(motion, time)) {
        for (std::size_t i = 0; i < turned.size(); ++i) turned[i] = rotation.apply(from_pivot[i]);
    }
};

/// Share of the largest distance that covers the rounding of poses in double.
constexpr double slack = 0x1p-46;

/// Encloses the way from one pose to the next: the chord of a circle and its rise, plus the range
/// of the translation.
void include_way(Box& box, const Pose& from, const Pose& to, const dvec3& pivot, double radius) {
    // Half the angle turned lies between the quaternions; an arc rises 1 - cos(half) over its
    // chord.
    const double rise = std::clamp(1 - from.rotation.dot_with(to.rotation), 0.0, 1.0) * radius;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [near, far] = std::minmax(from.translation[axis], to.translation[axis]);
        const double margin =
            rise + slack * (radius + std::abs(near) + std::abs(far) + std::abs(pivot[axis]));
        for (std::size_t i = 0; i < from.turned.size(); ++i) {
            const auto [lo, hi] = std::minmax(from.turned[i][axis], to.turned[i][axis]);
            box.lo[axis] = std::min(box.lo[axis], rounded_down(pivot[axis] + (near + lo) - margin));
            box.hi[axis] = std::max(box.hi[axis], rounded_up(pivot[axis] + (far + hi) + margin));
        }
    }
}

}  // namespace

Ray into_rest_frame(const Motion& motion, const Ray& ray) {
    const double time = shutter_time(ray.time);
    const Rotation rotation = rotation_at(motion, time);
    const dvec3 pivot(motion.pivot);
    const dvec3 from_pivot = dvec3(ray.origin) - pivot - translation_at(motion, time);
    Ray rest = ray;
    rest.origin = vec3(rotation.undo(from_pivot) + pivot);
    rest.direction = vec3(rotation.undo(dvec3(ray.direction)));
    return rest;
}

dvec3 move_to_world(const Motion& motion, float time, const dvec3& point) {
    const double t = shutter_time(time);
    const dvec3 pivot(motion.pivot);
    return rotation_at(motion, t).apply(point - pivot) + pivot + translation_at(motion, t);
}

vec3 rotate_to_world(const Motion& motion, float time, const vec3& direction) {
    return vec3(rotation_at(motion, shutter_time(time)).apply(dvec3(direction)));
}

Box swept(const Motion& motion, const Box& rest) {
    if (rest.empty()) return {};
    constexpr int steps = 64;  // at 90 degrees a step's arc rises 1e-4 of its radius
    const dvec3 pivot(motion.pivot);
    auto from_pivot = corners(rest);
    double radius = 0;
    for (dvec3& corner : from_pivot) {
        corner -= pivot;
        radius = std::max(radius, length(corner));
    }
    Box box;
    Pose pose(motion, from_pivot, 0);
    for (int step = 1; step <= steps; ++step) {
        const Pose next(motion, from_pivot, double(step) / steps);
        include_way(box, pose, next, pivot, radius);
        pose = next;
    }
    return box;
}

void require_rigid(const Motion& motion) {
    if (!finite(motion.pivot) || !finite(motion.translation[0]) || !finite(motion.translation[1]))
        throw std::invalid_argument("a motion's pivot and translations must be finite numbers");
    for (const Motion::Quaternion& q : motion.rotation) {
        const double size = std::sqrt(double(q[0]) * q[0] + double(q[1]) * q[1] +
                                      double(q[2]) * q[2] + double(q[3]) * q[3]);
        if (!(std::abs(size - 1) <= 1e-3))
            throw std::invalid_argument(
                "a motion's rotation must be a unit quaternion (x, y, z, "
                "w), but its length is " +
                std::to_string(size) + ": normalise it");
    }
    constexpr double cos_170_degrees = -0.98480775301220806;
    if (Rotation(motion.rotation[0]).dot_with(Rotation(motion.rotation[1])) < cos_170_degrees)
        throw std::invalid_argument(
            "a motion's two quaternions are more than 170 degrees apart, so that the way from one "
            "to the other is not defined: negate one, or split the motion");
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

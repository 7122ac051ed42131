#include "data/aff_poses.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <stdexcept>

namespace rayshoot {
namespace {

glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

double largest_difference(const glm::dmat3& a, const glm::dmat3& b) {
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    return largest;
}

/// The orthogonal factor of the polar decomposition, by Newton's iteration (Higham 1986).
glm::dmat3 nearest_rotation(glm::dmat3 m) {
    constexpr int most_steps = 100;  // quadratic: a handful
    constexpr double settled = 1e-14;
    for (int step = 0; step < most_steps; ++step) {
        const glm::dmat3 next = 0.5 * (m + glm::transpose(glm::inverse(m)));
        if (largest_difference(next, m) < settled) return next;
        m = next;
    }
    return m;
}

Motion::Quaternion floats(const glm::dquat& q) {
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z),
            static_cast<float>(q.w)};
}

/// With its scalar part not negative: the shorter way from the identity.
glm::dquat short_quaternion(const glm::dmat3& rotation) {
    const glm::dquat q = glm::normalize(glm::quat_cast(rotation));
    return q.w < 0 ? -q : q;
}

bool usable(double determinant) { return std::isfinite(determinant) && determinant != 0; }

/// Where the camera's key frames put it at a time: along -z of their rotation, y up.
struct CameraPose {
    dvec3 from;
    glm::dquat rotation;  ///< identity where they have none
};

CameraPose camera_pose(const KeyFrames& frames, const dvec3& otherwise, double time) {
    return {frames.translation ? frames.translation->at(time) : otherwise,
            frames.rotation ? frames.rotation->at(time) : glm::dquat(1, 0, 0, 0)};
}

}  // namespace

AffPose::AffPose(const glm::dmat4& matrix)
    : matrix_(matrix), for_normals_(cofactors(glm::dmat3(matrix))) {}

vec3 AffPose::normal(const vec3& n) const {
    const dvec3 turned = for_normals_ * dvec3(n);
    const double size = length(turned);
    return size > 0 && std::isfinite(size) ? vec3(turned / size) : vec3(0);
}

float AffPose::even_scale() const {
    const glm::dmat3 linear(matrix_);
    const double x = length(linear[0]), y = length(linear[1]), z = length(linear[2]);
    const double slack = 1e-5 * (x + y + z);  // a file's scales are printed numbers
    if (std::abs(x - y) > slack || std::abs(y - z) > slack)
        throw std::invalid_argument(
            "spheres and cones cannot be scaled unevenly; scale alike in x, "
            "y and z, or give a mesh");
    return static_cast<float>((x + y + z) / 3);
}

Motion rigid_motion(const glm::dmat4& from, const glm::dmat4& to, const dvec3& pivot) {
    const glm::dmat3 a(from), b(to);
    if (!usable(glm::determinant(a)) || !(glm::determinant(a) * glm::determinant(b) > 0))
        throw std::invalid_argument(
            "what the key frames move is flattened or mirrored by a scale "
            "on the way; keep scales away from 0");
    const glm::dmat4 change = to * glm::inverse(from);
    Motion motion;
    motion.pivot = vec3(pivot);
    const dvec3 start(motion.pivot);
    motion.translation[1] = vec3(dvec3(change * glm::dvec4(start, 1)) - start);
    motion.rotation[1] = floats(short_quaternion(nearest_rotation(glm::dmat3(change))));
    return motion;
}

AffPoses::AffPoses(const AffModel& model, const Exposure& exposure)
    : model_(model), exposure_(exposure) {
    for (std::uint32_t i = 0; i < model.transforms.size(); ++i) place(i);
}

const KeyFrames* AffPoses::key_frames_of(const AffTransform& transform) const {
    const auto* const name = std::get_if<std::string>(&transform.own);
    if (!name) return nullptr;
    const auto frames = model_.key_frames.find(*name);
    if (frames == model_.key_frames.end())
        throw std::invalid_argument(transform.where + ": there are no key frames `k " + *name +
                                    "` for this transform; add them, or use xs");
    return &frames->second;
}

void AffPoses::place(std::uint32_t i) {
    const AffTransform& transform = model_.transforms[i];
    const KeyFrames* const frames = key_frames_of(transform);
    const glm::dmat4* const fixed = std::get_if<glm::dmat4>(&transform.own);
    const glm::dmat4 open = fixed ? *fixed : frames->matrix(exposure_.open);
    const glm::dmat4 close = fixed ? *fixed : frames->matrix(exposure_.close);
    if (i == 0) {
        open_.emplace_back(open);
        close_.push_back(close);
        visible_.push_back(true);
        mover_.emplace_back();
        return;
    }
    const std::uint32_t parent = transform.parent;
    open_.emplace_back(open_[parent].matrix() * open);
    close_.push_back(close_[parent] * close);
    visible_.push_back(visible_[parent] && (!frames || frames->visible(exposure_.middle())));
    const bool moves = frames && open_[i].matrix() != close_[i];
    mover_.push_back(moves ? std::optional(i) : mover_[parent]);
}

Motion AffPoses::motion(std::uint32_t mover) const {
    const glm::dmat4& open = open_[mover].matrix();
    return rigid_motion(open, close_[mover], dvec3(open[3]));
}

Camera AffPoses::camera() const {
    Camera camera = *model_.camera;
    const auto frames = model_.key_frames.find("camera");
    if (frames == model_.key_frames.end()) return camera;
    const dvec3 gaze = dvec3(camera.at) - dvec3(camera.from);
    const CameraPose open = camera_pose(frames->second, dvec3(camera.from), exposure_.open);
    const CameraPose close = camera_pose(frames->second, dvec3(camera.from), exposure_.close);
    const double distance = length(gaze);
    const bool turned = frames->second.rotation.has_value();
    camera.from = vec3(open.from);
    camera.at = vec3(open.from + (turned ? distance * (open.rotation * dvec3(0, 0, -1)) : gaze));
    if (turned) camera.up = vec3(open.rotation * dvec3(0, 1, 0));
    Motion motion;
    motion.pivot = camera.from;
    motion.translation[1] = vec3(close.from - open.from);
    const glm::dquat change = glm::normalize(close.rotation * glm::conjugate(open.rotation));
    motion.rotation[1] = floats(change.w < 0 ? -change : change);
    if (motion != Motion{.pivot = motion.pivot}) camera.motion = motion;
    return camera;
}

}  // namespace rayshoot

#pragma once

#include "accel/core/primitive/motion.h"
#include "data/aff_model.h"
#include "data/animation.h"

#include <glm/mat3x3.hpp>

#include <optional>
#include <vector>

/// Where the transforms of an AFF model put what they hold, in one exposure.
namespace rayshoot {

/// A transform from its own coordinates to the world's.
class AffPose {
public:
    explicit AffPose(const glm::dmat4& matrix);

    const glm::dmat4& matrix() const { return matrix_; }
    vec3 point(const vec3& p) const { return vec3(matrix_ * glm::dvec4(p, 1)); }
    /// Unit, or zero where there is none (a zero normal, or space flattened). Where the transform
    /// mirrors, it goes with the winding of triangles to the other side.
    vec3 normal(const vec3& n) const;
    /// How much longer everything becomes. Throws std::invalid_argument when that depends on the
    /// direction.
    float even_scale() const;

private:
    glm::dmat4 matrix_;
    glm::dmat3 for_normals_;  ///< the cofactors: they map cross products of vectors
};

/// The rigid motion from one transform to another: exactly that of the point `pivot`, with the
/// rotation nearest to the linear part between them (Higham 1986). Throws std::invalid_argument
/// when `from` cannot be undone or one mirrors and the other does not.
Motion rigid_motion(const glm::dmat4& from, const glm::dmat4& to, const dvec3& pivot);

class AffPoses {
public:
    /// Throws std::invalid_argument, with the place, for a transform without its key frames.
    AffPoses(const AffModel& model, const Exposure& exposure);

    /// Where the shutter opens.
    const AffPose& pose(std::uint32_t transform) const { return open_[transform]; }
    bool visible(std::uint32_t transform) const { return visible_[transform]; }
    /// The innermost transform with key frames round a transform, if it moves in the exposure.
    std::optional<std::uint32_t> mover(std::uint32_t transform) const { return mover_[transform]; }
    /// Of a mover: about its own origin, which takes the way of the key frames' ends.
    Motion motion(std::uint32_t mover) const;
    /// The view, moved by the key frames named "camera", if there are any.
    Camera camera() const;

private:
    void place(std::uint32_t transform);
    const KeyFrames* key_frames_of(const AffTransform& transform) const;

    const AffModel& model_;
    Exposure exposure_;
    std::vector<AffPose> open_;
    std::vector<glm::dmat4> close_;
    std::vector<bool> visible_;
    std::vector<std::optional<std::uint32_t>> mover_;
};

}  // namespace rayshoot

#pragma once

#include "accel/core/vec.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include <optional>
#include <vector>

/// Key frames, interpolated as BART prescribes: by the splines of Kochanek & Bartels 1984, with
/// tangents adapted to unequal steps of time; rotations by the spherical quadrangle (Shoemake 1987)
/// with the same tangents of the logarithms. The first and the last key only bend the curve: before
/// the second and after the last but one, the value stands still.
namespace rayshoot {

/// How the curve passes a key; 0 each: a Catmull-Rom spline.
struct KeyShape {
    double tension = 0, continuity = 0, bias = 0;
};

template <class Value>
struct Key {
    double time = 0;
    Value value{};
    KeyShape shape;
};
inline constexpr std::size_t fewest_keys = 4;

/// At least fewest_keys keys in the order of time (the reader refuses others). Two at one time are
/// a jump.
class PositionTrack {
public:
    explicit PositionTrack(std::vector<Key<dvec3>> keys) : keys_(std::move(keys)) {}
    dvec3 at(double time) const;

private:
    std::vector<Key<dvec3>> keys_;
};

/// Unit quaternions; consecutive ones are turned to the same half of the sphere first, so that the
/// way from one to the next is the shorter.
class RotationTrack {
public:
    explicit RotationTrack(std::vector<Key<glm::dquat>> keys);
    glm::dquat at(double time) const;

private:
    std::vector<Key<glm::dquat>> keys_;
};

struct KeyFrames {
    std::optional<PositionTrack> translation, scale;
    std::optional<RotationTrack> rotation;
    std::vector<Key<bool>> visibility;  ///< from each time on; before the first: visible

    bool visible(double time) const;
    /// Translation * rotation * scale; what has no track is the identity.
    glm::dmat4 matrix(double time) const;
};

}  // namespace rayshoot

#pragma once

#include "data/key_frames.h"
#include "data/tokens.h"

/// The key frames of AFF: what follows `k name {`, the closing brace included.
namespace rayshoot {

/// transl, scale, rot and visibility, each at most once. Refuses, with the line, fewer than four
/// keys, times out of order and axes of no direction.
KeyFrames read_key_frames(Tokens& tokens);

/// Axis x y z and degrees, as `rot` and `xs` give a rotation. An axis of no direction may only go
/// with an angle of 0.
glm::dquat read_rotation(Tokens& tokens, std::string_view use);

}  // namespace rayshoot

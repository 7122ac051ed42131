#pragma once

#include "accel/core/build_input.h"
#include "bench/streams/ray_stream.h"

namespace rayshoot {

/// What is wrong with the sources of a stream, with the ray's number; "" when they are all true.
/// Structures rely on them, so a file is asked before it is traced.
std::string broken_promise_in(const BuildInput& input, const RayStream& stream);

/// Throws std::runtime_error with what is wrong.
void require_promises_kept(const BuildInput& input, const RayStream& stream);

}  // namespace rayshoot

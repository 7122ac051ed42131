#pragma once

#include "accel/core/geometry.h"
#include "bench/streams/ray_stream.h"

namespace rayshoot {

/// Seeded rays of the sorts that tell structures apart, in turn: chords of the scene's box, rays
/// from far outside, from inside, along an axis, that start on a primitive, and with a limited
/// interval. Equal arguments give equal rays on every machine.
RayStream hostile_rays(const Geometry& geometry, std::size_t count, std::uint64_t seed);

}  // namespace rayshoot

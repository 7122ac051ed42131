#pragma once

#include "accel/core/geometry.h"
#include "bench/streams/ray_stream.h"

#include <nlohmann/json_fwd.hpp>

namespace rayshoot {

/// What our interface costs Embree: its adaptor against direct calls on rays in its own layout, one
/// object per path, for the stream's question; an empty array in a build without Embree.
nlohmann::ordered_json adaptor_cost(const Geometry& geometry, const RayStream& stream,
                                    int repetitions);

}  // namespace rayshoot

#pragma once

#include "accel/core/build_input.h"

#include <string>

/// Sources are promises of the caller; this is where they are checked.
namespace rayshoot::inline RAYSHOOT_ISA {

/// What is wrong with the source of `batch.rays[i]`, for the first i where something is; "" when
/// all is well, or nothing was promised. Camera: the cell is of the image or its border, the ray
/// leaves the lens and goes through that cell on the focal plane, within 1e-3 cell; both but for
/// the rounding of the ray's origin, where the camera moves. Shadow: the light exists and origin +
/// direction is among its samples with t_max <= 1, or, directional, the direction is opposite to
/// the light's.
std::string broken_promise(const BuildInput& input, const RayBatch& batch);

/// Prints the broken promise and aborts.
[[noreturn]] void stop_for(const std::string& promise);

/// In a debug build, stops the program with that message; in others does nothing.
inline void assert_promises_kept([[maybe_unused]] const BuildInput& input,
                                 [[maybe_unused]] const RayBatch& batch) {
#ifndef NDEBUG
    if (const std::string promise = broken_promise(input, batch); !promise.empty())
        stop_for(promise);
#endif
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

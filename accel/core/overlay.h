#pragma once

#include "accel/core/intersector.h"

/// A composition: each member answers what the ones before it declined.
namespace rayshoot::inline RAYSHOOT_ISA {

/// `members`: at least two, all partial but the last, which is complete.
std::unique_ptr<Accel> overlay(std::vector<std::unique_ptr<Accel>> members);

}  // namespace rayshoot::inline RAYSHOOT_ISA

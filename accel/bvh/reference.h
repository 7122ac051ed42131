#pragma once

#include "accel/simd/bounds.h"

#include <span>

/// What top-down builders move about.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A box and its number in half a cache line, so that partitioning moves them together and binning
/// reads memory in order.
struct alignas(32) Reference {
    std::array<float, 3> lo;
    std::uint32_t number;
    std::array<float, 3> minus_hi;
    std::uint32_t unused;

    Reference(const Box& box, std::uint32_t n)
        : lo{box.lo.x, box.lo.y, box.lo.z},
          number(n),
          minus_hi{-box.hi.x, -box.hi.y, -box.hi.z},
          unused(0) {}

    /// As one register; the number's bits are in a lane that counts for nothing.
    explicit Reference(const simd::Bounds& whole) {
        simd::hn::Store(whole.planes(), simd::floats<8>, lo.data());
    }
    simd::Bounds bounds() const { return simd::Bounds(simd::hn::Load(simd::floats<8>, lo.data())); }
};
static_assert(sizeof(Reference) == 32);

/// The bounds of some boxes and of their centres.
struct Enclosure {
    simd::Bounds boxes, centres;

    void include(const simd::Bounds& box) {
        boxes.include(box);
        centres.include(box.centre());
    }
    void include(const Enclosure& other) {
        boxes.include(other.boxes);
        centres.include(other.centres);
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

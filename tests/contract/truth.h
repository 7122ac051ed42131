#pragma once

#include "accel/core/leaves.h"

/// The oracle: a loop over all primitives through the shared test of one primitive, in the plainest
/// form. It shares that test with every structure, and nothing else.
namespace rayshoot::contract {

class Truth {
public:
    /// Refers to `geometry`.
    explicit Truth(const Geometry& geometry);

    /// The nearest hit, {inf, none, 0, 0} when there is none.
    Hit closest(const Ray& ray) const;

private:
    std::uint32_t size_;
    Leaves leaves_;
};

/// The documented conditions, written a second time: a ray that breaks one hits nothing.
bool valid(const Ray& ray);

}  // namespace rayshoot::contract

#pragma once

#include "accel/core/geometry.h"

#include <memory>
#include <optional>

/// The second oracle: triangles and rays in exact arithmetic (CGAL), with no code of ours in the
/// decision. Rays so close to an edge, or hits so close together, that a correct float answer may
/// differ are called ambiguous.
namespace rayshoot::contract {

struct ExactAnswer {
    std::optional<double> t;  ///< of the nearest hit with t > t_min; none is a miss
    int crossings = 0;        ///< triangles that the ray passes through, borders included
    bool ambiguous = false;
};

class ExactOracle {
public:
    /// Triangles that stand still only.
    explicit ExactOracle(const Geometry& geometry);
    ~ExactOracle();
    ExactOracle(const ExactOracle&) = delete;
    ExactOracle& operator=(const ExactOracle&) = delete;

    /// `margin`: barycentric distance to an edge, and relative distance of two hits, below which a
    /// ray is ambiguous.
    ExactAnswer ask(const Ray& ray, double margin) const;

private:
    struct Triangles;
    std::unique_ptr<Triangles> triangles_;
};

}  // namespace rayshoot::contract

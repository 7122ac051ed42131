#pragma once

#include "accel/bsp/plane.h"
#include "accel/core/box.h"

#include <cstdint>
#include <utility>
#include <vector>

/// The cells of a tree whose planes lie anyhow.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A convex polyhedron, for its surface area: the chance of a ray to pass. No answer depends on it.
class Polyhedron {
public:
    struct Areas {
        double below = 0, above = 0;
    };

    /// Seen from `centre`.
    Polyhedron(const Box& box, const vec3& centre);

    double area() const;
    /// Of the surfaces of both halves; a half that is empty has none.
    Areas areas_of_halves(const ObliquePlane& plane) const;
    Polyhedron below(const ObliquePlane& plane) const { return half(plane, 1); }
    Polyhedron above(const ObliquePlane& plane) const { return half(plane, -1); }
    std::size_t faces() const { return ends_.size(); }

private:
    Polyhedron() = default;
    Polyhedron half(const ObliquePlane& plane, double side) const;
    void add_corner(const dvec3& corner) { corners_.push_back(corner); }
    void close_face();
    void close_with(std::vector<dvec3> rim, const dvec3& normal);
    /// visit(first, end) for the places of the corners of each face.
    template <class Visit>
    void each_face(const Visit& visit) const {
        std::size_t first = 0;
        for (const std::uint32_t end : ends_) {
            visit(first, std::size_t{end});
            first = end;
        }
    }

    std::vector<dvec3> corners_;  ///< of one face after the other; counter-clockwise from outside
    std::vector<std::uint32_t> ends_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

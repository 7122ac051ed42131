#pragma once

#include "accel/core/geometry.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <optional>
#include <vector>

/// An AABB_tree over the triangles of a geometry, asked with our rays.
namespace rayshoot::inline RAYSHOOT_ISA::cgal {

using Kernel = CGAL::Simple_cartesian<double>;

class Tree {
public:
    /// Takes copies. Triangles without an area are left out: CGAL's tests are not defined for them.
    explicit Tree(const Geometry& geometry);

    Hit closest(const Ray& ray) const;
    bool occluded(const Ray& ray) const;

    std::size_t size() const { return triangles_.size(); }
    std::size_t bytes() const;

private:
    using Triangles = std::vector<Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
    using Aabb = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

    /// The part of a ray's interval that lies within reach of the scene.
    struct Part {
        double start, end;  ///< in units of |direction|
    };
    std::optional<Part> part(const Ray& ray) const;
    Hit hit_at(const Ray& ray, Triangles::const_iterator triangle,
               const Kernel::Point_3& point) const;

    Box bounds_;
    Triangles triangles_;
    std::vector<std::uint32_t> numbers_;  ///< of the triangles, in the geometry
    Aabb tree_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA::cgal

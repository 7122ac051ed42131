#include "accel/cgal/tree.h"

#include <CGAL/number_utils.h>

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA::cgal {
namespace {

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

Point point(const vec3& p) { return {p.x, p.y, p.z}; }
Vector vector(const vec3& d) { return {d.x, d.y, d.z}; }

/// CGAL's intervals are closed, ours are open: hits nearer to an end than this share of the ray's
/// distances (origin, scene) are not hits. Far above double's rounding, far below float's.
constexpr double end_gap = 0x1p-40;

}  // namespace

Tree::Tree(const Geometry& geometry) : bounds_(geometry.bounds()) {
    for (std::uint32_t number = 0; number < geometry.size(); ++number) {
        const Triangle corners = geometry.triangle(geometry.ref(number).index);
        const Kernel::Triangle_3 triangle(point(corners.a), point(corners.b), point(corners.c));
        if (triangle.is_degenerate()) continue;
        triangles_.push_back(triangle);
        numbers_.push_back(number);
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
}

std::size_t Tree::bytes() const {
    const std::size_t each = sizeof(Kernel::Triangle_3) + sizeof(numbers_[0]) + sizeof(Primitive) +
                             sizeof(CGAL::AABB_node<Aabb::AABB_traits>);
    return triangles_.size() * each;
}

std::optional<Tree::Part> Tree::part(const Ray& ray) const {
    if (triangles_.empty() || !answerable(ray)) return std::nullopt;
    const Interval inside = clip(SlabRay(ray.origin, ray.direction), bounds_);
    if (inside.empty() || !std::isfinite(inside.entry) || !std::isfinite(inside.exit))
        return std::nullopt;
    const double entry = inside.entry, exit = inside.exit;
    const double distance = std::max(std::abs(entry), std::abs(exit));
    const double slack = 1e-3 * distance;  // the entry is a rounded float, the triangles are not
    const double gap = end_gap * distance;
    const Part part{std::max(ray.t_min + gap, entry - slack),
                    std::min(ray.t_max - gap, exit + slack)};
    if (!(part.start < part.end)) return std::nullopt;
    return part;
}

Hit Tree::closest(const Ray& ray) const {
    const std::optional<Part> part = this->part(ray);
    if (!part) return {};
    const Vector direction = vector(ray.direction);
    const Point start = point(ray.origin) + part->start * direction;
    const auto found =
        tree_.first_intersection(Kernel::Ray_3(start, (part->end - part->start) * direction));
    if (!found) return {};
    if (const Point* single = boost::get<Point>(&found->first))
        return hit_at(ray, found->second, *single);
    // The ray runs inside the triangle's plane: the nearer end of what they share.
    const auto& shared = boost::get<Kernel::Segment_3>(found->first);
    const bool source_first = CGAL::squared_distance(start, shared.source()) <=
                              CGAL::squared_distance(start, shared.target());
    return hit_at(ray, found->second, source_first ? shared.source() : shared.target());
}

Hit Tree::hit_at(const Ray& ray, Triangles::const_iterator triangle, const Point& at) const {
    const Vector direction = vector(ray.direction);
    const double t = (at - point(ray.origin)) * direction / direction.squared_length();
    Hit hit;
    hit.t = static_cast<float>(t);
    if (!(t > ray.t_min && t < ray.t_max)) return {};
    const Point& corner = triangle->vertex(0);
    const Vector to_b = triangle->vertex(1) - corner, to_c = triangle->vertex(2) - corner;
    const Vector normal = CGAL::cross_product(to_b, to_c);
    const double scale = normal.squared_length();
    hit.u = static_cast<float>(CGAL::cross_product(at - corner, to_c) * normal / scale);
    hit.v = static_cast<float>(CGAL::cross_product(to_b, at - corner) * normal / scale);
    hit.primitive = numbers_[static_cast<std::size_t>(triangle - triangles_.cbegin())];
    return hit;
}

bool Tree::occluded(const Ray& ray) const {
    const std::optional<Part> part = this->part(ray);
    if (!part) return false;
    const Vector direction = vector(ray.direction);
    const Point origin = point(ray.origin);
    return tree_.do_intersect(
        Kernel::Segment_3(origin + part->start * direction, origin + part->end * direction));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::cgal

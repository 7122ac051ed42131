#include "tests/contract/oracle/exact.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rayshoot::contract {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

Point exact(const vec3& p) { return {p.x, p.y, p.z}; }

struct ExactTriangle {
    std::array<dvec3, 3> rounded;  // doubles hold floats exactly; only what is made of them rounds
    std::array<Point, 3> corners;
};

struct ExactRay {
    dvec3 origin, direction;
    Point from, to;
};

/// Where the line passes the triangle, in double: good to far better than any margin.
struct Position {
    double inside;  // smallest barycentric; negative outside
    double t;
    bool parallel;
};

Position position(const ExactTriangle& triangle, const ExactRay& ray) {
    const dvec3 e1 = triangle.rounded[1] - triangle.rounded[0];
    const dvec3 e2 = triangle.rounded[2] - triangle.rounded[0];
    const dvec3 s = ray.origin - triangle.rounded[0];
    const dvec3 normal = cross(e1, e2), moment = cross(s, ray.direction);
    const double det = -dot(ray.direction, normal);
    const bool parallel = std::abs(det) < 1e-9 * length(normal) * length(ray.direction);
    const double u = dot(e2, moment) / det, v = -dot(e1, moment) / det;
    return {std::min({u, v, 1 - u - v}), dot(s, normal) / det, parallel};
}

/// Exactly: does the line pass through the closed triangle, not in its plane?
bool passes(const ExactTriangle& triangle, const ExactRay& ray) {
    int positive = 0, negative = 0;
    for (const std::size_t i : {0u, 1u, 2u}) {
        const auto side =
            CGAL::orientation(ray.from, ray.to, triangle.corners[i], triangle.corners[(i + 1) % 3]);
        positive += side == CGAL::POSITIVE;
        negative += side == CGAL::NEGATIVE;
    }
    return (positive == 0) != (negative == 0);
}

Kernel::FT exact_t(const ExactTriangle& triangle, const ExactRay& ray) {
    const auto& [a, b, c] = triangle.corners;
    const Vector normal = CGAL::cross_product(b - a, c - a);
    return ((a - ray.from) * normal) / ((ray.to - ray.from) * normal);
}

}  // namespace

struct ExactOracle::Triangles {
    std::vector<ExactTriangle> all;
};

ExactOracle::ExactOracle(const Geometry& geometry) : triangles_(std::make_unique<Triangles>()) {
    for (std::uint32_t i = 0; i < geometry.size(); ++i) {
        const Triangle t = geometry.triangle(geometry.ref(i).index);
        triangles_->all.push_back(
            {{dvec3(t.a), dvec3(t.b), dvec3(t.c)}, {exact(t.a), exact(t.b), exact(t.c)}});
    }
}

ExactOracle::~ExactOracle() = default;

ExactAnswer ExactOracle::ask(const Ray& ray, double margin) const {
    const Point from = exact(ray.origin);
    const vec3& d = ray.direction;
    const ExactRay exact_ray{dvec3(ray.origin), dvec3(d), from, from + Vector(d.x, d.y, d.z)};
    ExactAnswer answer;
    std::vector<double> hits;
    for (const ExactTriangle& triangle : triangles_->all) {
        const Position at = position(triangle, exact_ray);
        if (!at.parallel && at.inside < -margin) continue;
        const bool near_limit = std::abs(at.t - static_cast<double>(ray.t_min)) < margin;
        if (at.parallel || near_limit) answer.ambiguous |= at.parallel ? at.inside > -1 : true;
        if (at.t > static_cast<double>(ray.t_min)) answer.ambiguous |= at.inside < margin;
        if (!passes(triangle, exact_ray)) continue;
        const Kernel::FT t = exact_t(triangle, exact_ray);
        if (t > Kernel::FT(ray.t_min)) hits.push_back(CGAL::to_double(t));
    }
    answer.crossings = static_cast<int>(hits.size());
    if (hits.empty()) return answer;
    std::sort(hits.begin(), hits.end());
    answer.t = hits.front();
    if (hits.size() > 1) answer.ambiguous |= hits[1] - hits[0] < margin * hits[0];
    return answer;
}

}  // namespace rayshoot::contract

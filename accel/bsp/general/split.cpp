#include "accel/bsp/general/split.h"

#include "accel/core/primitive/rounding.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// By corners, in their order.
std::vector<vec3> normals_of(std::span<const dvec3> corners, const dvec3& normal) {
    const auto unit = [](const dvec3& v) { return vec3(normalised(v)); };
    std::vector<vec3> normals{unit(normal)};
    dvec3 from = corners.back();
    for (const dvec3& to : corners) {
        if (from != to) normals.push_back(unit(cross(to - from, normalised(normal))));
        from = to;
    }
    std::erase_if(normals, [](const vec3& n) { return !finite(n); });
    return normals;
}

/// Looks for the cheapest plane.
class Search {
public:
    Search(const Sah& sah, const PartMaker& maker, const Polyhedron& hull,
           std::span<const Part> parts)
        : sah_(sah), maker_(maker), hull_(hull), parts_(parts), whole_(hull.area()) {
        best_.cost = leaf_cost(sah, static_cast<std::uint32_t>(parts.size()));
    }

    GeneralSplit best() const {
        return best_.oblique || best_.axial.cost < infinity ? best_ : GeneralSplit{};
    }
    void consider(int axis, float plane) {
        std::uint32_t left = 0, right = 0, flat = 0;
        for (const Part& part : parts_) {
            const float lo = part.box.lo[axis], hi = part.box.hi[axis];
            left += lo < plane;
            right += hi > plane;
            flat += lo == plane && hi == plane;
        }
        consider({0, axis, plane, true}, left + flat, right);
        if (flat > 0) consider({0, axis, plane, false}, left, right + flat);
    }
    void consider(const ObliquePlane& plane) {
        std::uint32_t below = 0, above = 0;
        for (const Part& part : parts_) {
            const Heights heights = maker_.heights(part, plane);
            below += maker_.is_below(heights);
            above += maker_.is_above(heights);
        }
        // Where a side is empty there is nothing off: a plane may be beside all of a cell.
        const float cost = cost_of(plane, below, above, oblique_step_cost, 1);
        if (cost < best_.cost) best_ = {cost, true, {}, plane};
    }

private:
    void consider(KdSplit split, std::uint32_t left, std::uint32_t right) {
        const float factor = left == 0 || right == 0 ? sah_.empty_factor : 1;
        split.cost = cost_of(maker_.frame().across(split.axis, split.plane), left, right,
                             sah_.step_cost, factor);
        if (split.cost < best_.cost) best_ = {split.cost, false, split, {}};
    }
    float cost_of(const ObliquePlane& plane, std::uint32_t below, std::uint32_t above,
                  float step_cost, float factor) const {
        const float cost_below = leaf_cost(sah_, below), cost_above = leaf_cost(sah_, above);
        // The halves of a convex cell have at least its area together.
        if (factor * (step_cost + std::min(cost_below, cost_above)) >= best_.cost) return infinity;
        const Polyhedron::Areas areas = hull_.areas_of_halves(plane);
        if (!(areas.below > 0 && areas.above > 0)) return infinity;
        const auto tests = static_cast<float>(
            (areas.below * double(cost_below) + areas.above * double(cost_above)) / whole_);
        return factor * (step_cost + tests);
    }

    const Sah& sah_;
    const PartMaker& maker_;
    const Polyhedron& hull_;
    std::span<const Part> parts_;
    double whole_;
    GeneralSplit best_;
};

/// At both sides of a flat primitive, and on both sides of its edges.
void consider_offers(Search& search, const Geometry& geometry, const PartMaker& maker,
                     const Part& part) {
    const double margin = maker.frame().margin;
    bool own = true;
    for (const vec3& normal : offered_normals(geometry, part.number)) {
        const Heights heights = maker.heights(part, {normal, 0});
        // So far that what is there is on one side only.
        const float above = float_above(rounded_up(heights.hi + margin)),
                    below = float_below(rounded_down((own ? heights.lo : heights.hi) - margin));
        search.consider(ObliquePlane{normal, above});
        search.consider(ObliquePlane{normal, below});
        own = false;
    }
}

}  // namespace

std::vector<vec3> offered_normals(const Geometry& geometry, std::uint32_t primitive) {
    const PrimitiveRef& ref = geometry.ref(primitive);
    if (ref.motion != no_motion) return {};
    if (ref.kind == PrimitiveKind::triangle) {
        const Triangle triangle = geometry.triangle(ref.index);
        const std::array corners{dvec3(triangle.a), dvec3(triangle.b), dvec3(triangle.c)};
        return normals_of(corners, cross(corners[1] - corners[0], corners[2] - corners[0]));
    }
    if (ref.kind != PrimitiveKind::polygon) return {};
    const Polygon& polygon = geometry.polygon(ref.index);
    if (polygon.corners.size() > Part::most_corners) return {};
    return normals_of(std::vector<dvec3>(polygon.corners.begin(), polygon.corners.end()),
                      polygon.normal);
}

GeneralSplit best_general_split(const Geometry& geometry, const KdParting& parting,
                                const PartMaker& maker, const KdCell& cell, const Polyhedron& hull,
                                std::span<const Part> parts) {
    if (!parting.divisible(cell, parts.size())) return {};
    Search search(parting.sah(), maker, hull, parts);
    if (parts.size() <= most_offering) {
        for (const Part& part : parts)
            for (int axis = 0; axis < 3; ++axis)
                for (const float plane : {part.box.lo[axis], part.box.hi[axis]})
                    if (cell.box.lo[axis] < plane && plane < cell.box.hi[axis])
                        search.consider(axis, plane);
    } else {
        References references;
        for (const Part& part : parts) references.push_back(part.reference());
        const KdSplit split = parting.best_split(cell, references);
        if (split.cost < infinity) search.consider(split.axis, split.plane);
    }
    const std::size_t offering = std::min(parts.size(), most_offering);
    for (std::size_t i = 0; i < offering; ++i)
        consider_offers(search, geometry, maker, parts[i * parts.size() / offering]);
    return search.best();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

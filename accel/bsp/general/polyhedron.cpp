#include "accel/bsp/general/polyhedron.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Adds up the corners of a polygon to its area, as a vector along its normal.
class PolygonArea {
public:
    void add(const dvec3& corner) {
        if (count_ == 0) first_ = corner;
        else if (count_ > 1) twice_ = twice_ + cross(last_ - first_, corner - first_);
        last_ = corner;
        ++count_;
    }
    dvec3 area() const { return 0.5 * twice_; }

private:
    dvec3 first_{0}, last_{0}, twice_{0};
    int count_ = 0;
};

/// The part of an edge up to where its height is 0.
dvec3 crossing(const dvec3& from, double from_height, const dvec3& to, double to_height) {
    return along(from, from_height / (from_height - to_height), to - from);
}

/// Grows with the angle from (1, 0) on, from 0 to 4; without libm, so that it is the same
/// everywhere.
double turn(double x, double y) {
    const double size = std::abs(x) + std::abs(y);
    if (size == 0) return 0;
    const double part = y / size;
    return x < 0 ? 2 - part : y < 0 ? 4 + part : part;
}

}  // namespace

Polyhedron::Polyhedron(const Box& box, const vec3& centre) {
    const auto corner = [&](int axis, bool high, bool next, bool last) {
        dvec3 at;
        at[axis] = high ? box.hi[axis] : box.lo[axis];
        at[(axis + 1) % 3] = next ? box.hi[(axis + 1) % 3] : box.lo[(axis + 1) % 3];
        at[(axis + 2) % 3] = last ? box.hi[(axis + 2) % 3] : box.lo[(axis + 2) % 3];
        add_corner(at - dvec3(centre));
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            corner(axis, high, false, false);
            corner(axis, high, high, !high);
            corner(axis, high, true, true);
            corner(axis, high, !high, high);
            close_face();
        }
}

void Polyhedron::close_face() {
    const std::size_t first = ends_.empty() ? 0 : ends_.back();
    if (corners_.size() - first < 3) corners_.resize(first);
    else ends_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

double Polyhedron::area() const {
    double sum = 0;
    each_face([&](std::size_t first, std::size_t end) {
        PolygonArea face;
        for (std::size_t i = first; i < end; ++i) face.add(corners_[i]);
        sum += length(face.area());
    });
    return sum;
}

Polyhedron::Areas Polyhedron::areas_of_halves(const ObliquePlane& plane) const {
    Areas areas;
    dvec3 open(0);  // the areas of a closed surface add up to nothing: what lacks is the cut
    each_face([&](std::size_t first, std::size_t end) {
        PolygonArea below, above;
        dvec3 from = corners_[end - 1];
        double from_height = plane.height(from);
        for (std::size_t i = first; i < end; ++i) {
            const dvec3& to = corners_[i];
            const double to_height = plane.height(to);
            if ((from_height > 0) != (to_height > 0)) {
                const dvec3 between = crossing(from, from_height, to, to_height);
                below.add(between);
                above.add(between);
            }
            (to_height > 0 ? above : below).add(to);
            from = to;
            from_height = to_height;
        }
        areas.below += length(below.area());
        areas.above += length(above.area());
        open = open + below.area();
    });
    const double cut = length(open);
    if (areas.below > 0) areas.below += cut;
    if (areas.above > 0) areas.above += cut;
    return areas;
}

Polyhedron Polyhedron::half(const ObliquePlane& plane, double side) const {
    Polyhedron half;
    std::vector<dvec3> rim;
    each_face([&](std::size_t first, std::size_t end) {
        dvec3 from = corners_[end - 1];
        double from_height = side * plane.height(from);
        for (std::size_t i = first; i < end; ++i) {
            const dvec3& to = corners_[i];
            const double to_height = side * plane.height(to);
            if ((from_height > 0) != (to_height > 0)) {
                rim.push_back(crossing(from, from_height, to, to_height));
                half.add_corner(rim.back());
            }
            if (to_height <= 0) half.add_corner(to);
            from = to;
            from_height = to_height;
        }
        half.close_face();
    });
    if (half.faces() > 0) half.close_with(std::move(rim), side * dvec3(plane.normal));
    return half;
}

/// A face with these corners, which come in any order, and twice.
void Polyhedron::close_with(std::vector<dvec3> rim, const dvec3& normal) {
    if (rim.empty()) return;
    dvec3 middle(0);
    for (const dvec3& corner : rim) middle = middle + corner / double(rim.size());
    const dvec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    dvec3 axis(0);
    axis[least] = 1;
    const dvec3 u = cross(axis, normal), v = cross(normal, u);
    std::vector<std::pair<double, std::size_t>> turns;
    for (std::size_t i = 0; i < rim.size(); ++i)
        turns.emplace_back(turn(dot(rim[i] - middle, u), dot(rim[i] - middle, v)), i);
    std::sort(turns.begin(), turns.end());
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const dvec3& corner = rim[turns[i].second];
        if (i == 0 || corner != rim[turns[i - 1].second]) add_corner(corner);
    }
    close_face();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

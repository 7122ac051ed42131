#include "accel/core/primitive/clipping.h"

#include <algorithm>
#include <vector>

#include "accel/core/primitive/rounding.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Share of the largest coordinate by which clipping planes stand back, so that the rounding of
/// corners that earlier planes made never loses a part.
constexpr double slack = 0x1p-46;

/// A shape's corners; on the stack for all but large polygons.
class Corners {
public:
    void clear() { size_ = 0; }
    void add(const dvec3& p) {
        if (size_ == few_.size() && many_.empty()) many_.assign(few_.begin(), few_.end());
        if (many_.empty()) few_[size_] = p;
        else if (size_ < many_.size()) many_[size_] = p;
        else many_.push_back(p);
        ++size_;
    }
    std::span<const dvec3> all() const {
        return {many_.empty() ? few_.data() : many_.data(), size_};
    }

private:
    std::array<dvec3, 32> few_;
    std::vector<dvec3> many_;
    std::size_t size_ = 0;
};

/// Keeps the part where side * (x[axis] - plane) >= 0.
void clip_to_half(std::span<const dvec3> shape, int axis, double plane, double side, Corners& out) {
    out.clear();
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const dvec3& here = shape[i];
        const dvec3& next = shape[i + 1 < shape.size() ? i + 1 : 0];
        const double from = side * (here[axis] - plane), to = side * (next[axis] - plane);
        if (from >= 0) out.add(here);
        if ((from < 0) == (to < 0)) continue;
        dvec3 crossing = along(here, from / (from - to), next - here);
        crossing[axis] = plane;
        out.add(crossing);
    }
}

double largest_coordinate(std::span<const dvec3> shape) {
    double largest = 0;
    for (const dvec3& p : shape)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return largest;
}

Box enclosing(std::span<const dvec3> shape, double margin) {
    Box box;
    for (const dvec3& p : shape) {
        for (int axis = 0; axis < 3; ++axis) {
            box.lo[axis] = std::min(box.lo[axis], rounded_down(p[axis] - margin));
            box.hi[axis] = std::max(box.hi[axis], rounded_up(p[axis] + margin));
        }
    }
    return box;
}

}  // namespace

Box clipped_bounds(std::span<const dvec3> corners, const Box& box) {
    if (box.empty()) return {};
    Corners here, next;
    for (const dvec3& p : corners) here.add(p);
    const double margin = slack * largest_coordinate(corners);
    for (int axis = 0; axis < 3; ++axis) {
        clip_to_half(here.all(), axis, double(box.lo[axis]) - margin, 1, next);
        clip_to_half(next.all(), axis, double(box.hi[axis]) + margin, -1, here);
    }
    const Box part = enclosing(here.all(), margin).intersection(box);
    return part.empty() ? Box{} : part;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

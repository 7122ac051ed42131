#include "accel/space/membership.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Havran 1999: boxes of polygons thinner than this are widened by as much on each side; in scene
/// units.
constexpr float thin = 0.02f;
/// ... and the box of the scene by this.
constexpr float scene_margin = 0.001f;
/// Diagonals of the scenes for which the error radius is derived: products neither over- nor
/// underflow.
constexpr float least_diagonal = 0x1p-30f, largest_diagonal = 0x1p30f;

bool is_flat(PrimitiveKind kind) {
    return kind == PrimitiveKind::triangle || kind == PrimitiveKind::polygon;
}

Box widened(Box box) {
    for (int axis = 0; axis < 3; ++axis)
        if (box.hi[axis] - box.lo[axis] < thin) {
            box.lo[axis] -= thin;
            box.hi[axis] += thin;
        }
    return box;
}

}  // namespace

Membership::Membership(const BuildInput& input, Overlap overlap)
    : geometry_(&input.geometry), overlap_(overlap), space_(input.geometry.bounds()) {
    if (geometry_->size() == 0) return;
    if (overlap == Overlap::havran) {
        for (std::uint32_t i = 0; i < geometry_->size(); ++i) {
            const Box& own = geometry_->bounds(i);
            boxes_.push_back(is_flat(geometry_->ref(i).kind) ? widened(own) : own);
            space_.include(boxes_.back());
        }
        space_ = space_.grown(scene_margin);
    }
    if (overlap != Overlap::exact) return;
    centre_ = geometry_->bounds().centre();
    const vec3 size = geometry_->bounds().size();
    const float diagonal = std::sqrt(dot(size, size));
    if (!(diagonal > least_diagonal && diagonal < largest_diagonal)) {
        overlap_ = Overlap::bounds;
        return;
    }
    reach_ = diagonal;
    if (input.view) {
        const vec3 to_eye = input.view->eye - centre_;
        reach_ = std::max(reach_, std::sqrt(dot(to_eye, to_eye)) + input.view->lens_radius);
    }
    // Hits from beyond may be reported anywhere in the bounds (core/README.md, Stored bounds).
    if (geometry_->precision() == Precision::watertight) reach_ = std::min(reach_, 4 * diagonal);
    reach_ *= 1 + 0x1p-20f;
    radius_ = geometry_->error_radius(reach_ * (1 + 0x1p-20f));
    per_reach_ = 1 / reach_;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

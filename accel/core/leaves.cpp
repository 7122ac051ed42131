#include "accel/core/leaves.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {

Leaves::Leaves(const Geometry& geometry, std::span<const std::uint32_t> order,
               std::span<const LeafRange> leaves)
    : geometry_(&geometry) {
    slots_.reserve(order.size());
    for (const std::uint32_t primitive : order) slots_.push_back(pack(primitive));
    for (const LeafRange& leaf : leaves)
        std::sort(slots_.begin() + leaf.first, slots_.begin() + leaf.first + leaf.count,
                  [](const Slot& l, const Slot& r) {
                      return l.tag != r.tag ? l.tag < r.tag : l.primitive < r.primitive;
                  });
    plain_ = geometry.precision() == Precision::standard &&
             std::all_of(slots_.begin(), slots_.end(), [](const Slot& slot) {
                 return slot.kind() == PrimitiveKind::triangle && slot.motion() == no_motion;
             });
}

Leaves::Slot Leaves::pack(std::uint32_t primitive) const {
    const PrimitiveRef& ref = geometry_->ref(primitive);
    Slot slot{{vec3(0), vec3(0), vec3(0)},
              primitive,
              ref.motion * primitive_kinds + static_cast<std::uint32_t>(ref.kind)};
    if (ref.kind == PrimitiveKind::triangle) slot.triangle = geometry_->triangle(ref.index);
    if (ref.kind == PrimitiveKind::sphere) {
        const Sphere& sphere = geometry_->sphere(ref.index);
        slot.triangle = {sphere.centre, vec3(sphere.radius, 0, 0), vec3(0)};
    }
    return slot;
}

bool Leaves::misses_bounds(const Slot& slot, const TestRay& world) const {
    return clip(world, geometry_->bounds(slot.primitive)).empty();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

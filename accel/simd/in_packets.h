#pragma once

#include "accel/simd/packet.h"

/// How a batch falls into packets.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Some rays of a batch.
struct BatchPart {
    std::span<const Ray> rays;
    std::size_t first = 0;  ///< place of the first one in the batch
};

/// In order: together(part) for the rays that make a packet, which `load(rays)` has tried to load,
/// and each(part) for those between.
template <class Load, class Together, class Each>
inline void in_packets(std::span<const Ray> rays, const Load& load, const Together& together,
                       const Each& each) {
    std::size_t waiting = 0;  // the first ray that has not been traced
    const auto go = [&](std::size_t first, std::size_t size) {
        if (!load(rays.subspan(first, size))) return false;
        each(BatchPart{rays.subspan(waiting, first - waiting), waiting});
        together(BatchPart{rays.subspan(first, size), first});
        waiting = first + size;
        return true;
    };
    for (std::size_t i = 0; i + Packet::group <= rays.size(); i += Packet::most) {
        const std::size_t whole_groups = (rays.size() - i) / Packet::group * Packet::group;
        const std::size_t size = std::min(Packet::most, whole_groups);
        if (go(i, size) || size == Packet::group) continue;
        for (std::size_t j = i; j < i + size; j += Packet::group) go(j, Packet::group);
    }
    each(BatchPart{rays.subspan(waiting), waiting});
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

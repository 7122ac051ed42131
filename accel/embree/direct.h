#pragma once

#include "accel/core/geometry.h"
#include "accel/core/intersector.h"

#include <span>
#include <string_view>
#include <vector>

/// What the adaptor costs: Embree called directly on rays that lie ready in its own layout, against
/// the same calls through our interface, in turns, in one process.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Ratio of both sides' times, with its 95 % interval (bootstrap over the blocks).
struct RatioInterval {
    double median = 0, low = 0, high = 0;  ///< median: of the passes, block by block
};

struct DirectRow {
    std::string_view path;  ///< single, packet, stream
    Query query;
    RayKind kind;
    double direct_mrays, adaptor_mrays;  ///< per second, one thread, all blocks
    RatioInterval ratio;                 ///< adaptor / direct; 1 is a free adaptor
    std::size_t blocks;                  ///< that the rays were traced in
    std::size_t differences;             ///< answers that are not the same bits; 0 is right
};

/// One row per path and question. All rays are traced in blocks of `block`, in passes direct,
/// adaptor, adaptor, direct, `repetitions` times; a block's time is the median over the passes, a
/// side's the sum over the blocks. Rays that Embree cannot take as they are (not answerable,
/// t_min < 0) are left out. Empty when there are too few rays for one packet.
std::vector<DirectRow> measure_direct(const Geometry& geometry, RayKind kind,
                                      std::span<const Ray> rays, int repetitions,
                                      std::size_t block = default_batch);

}  // namespace rayshoot::inline RAYSHOOT_ISA

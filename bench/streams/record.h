#pragma once

#include "accel/core/catalogue.h"
#include "bench/streams/ray_stream.h"
#include "data/scene.h"
#include "tracer/camera.h"

#include <span>

namespace rayshoot {

inline constexpr std::size_t most_recorded_rays = std::size_t{1} << 25;  ///< camera rays: 1.3 GB

/// Streams of one scene, in the order of `kinds`. The scalar bvh finds the hits that the rays of
/// the later kinds start from, so equal scenes give equal streams. Throws std::invalid_argument for
/// an image of more than most_recorded_rays camera rays.
std::vector<RayStream> record_streams(const Catalogue& catalogue, const Scene& scene,
                                      std::span<const StreamKind> kinds, const ImageFormat& format);

/// The image that a stream was recorded from, for the View its sources speak of; `otherwise` for a
/// stream that was recorded from none.
ImageFormat format_of(const RayStream& stream, const ImageFormat& otherwise);

}  // namespace rayshoot

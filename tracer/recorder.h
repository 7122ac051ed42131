#pragma once

#include "accel/core/intersector.h"

#include <vector>

#include "tracer/camera.h"

/// Rays of every kind over one scene, for tracing again: what each structure is measured on.
namespace rayshoot {

/// Rays of one kind, in the order in which they should be traced, in batches of default_batch.
struct RecordedRays {
    std::vector<Ray> rays;
    std::vector<Source> sources;  ///< one per ray for camera and shadow rays, else empty
};

struct RecordedStreams {
    RecordedRays camera;     ///< all of the image's; batches are tiles in Morton order
    RecordedRays shadow;     ///< of the camera rays' hits, per tile light by light; any-hit
    RecordedRays secondary;  ///< mirror and refraction rays of the camera rays' hits; may be empty
    RecordedRays diffuse;    ///< one cosine-distributed bounce per hit of a camera ray
    RecordedRays random;     ///< chords of the sphere round the scene's bounds, one per camera ray
};

/// Traces the camera rays with `accel`, which must be complete, and records what they would spawn
/// under the SPD testing rules, to a random point of lamps of a size. Equal inputs and seeds give
/// equal rays, for every exact structure. Throws like render.
RecordedStreams record_streams(const Scene& scene, const Accel& accel, const ImageFormat& format);

/// `count` rays from point to point, both uniform on the sphere round `bounds`: isotropic. The
/// random rays of record_streams for images of `count` camera rays, so what was timed on these can
/// be compared with what `rayshoot bench --rays random` reports. None for empty bounds.
std::vector<Ray> random_chords(const Box& bounds, std::size_t count, std::uint32_t seed = 0);

}  // namespace rayshoot

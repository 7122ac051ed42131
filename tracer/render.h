#pragma once

#include "accel/core/intersector.h"

#include <functional>
#include <memory>

#include "tracer/camera.h"
#include "tracer/image.h"
#include "tracer/wavefront.h"

/// Renders a scene through any complete structure.
namespace rayshoot {

/// Called now and then while rendering, from one thread at a time.
using RenderProgress = std::function<void(double share_done, double seconds_left)>;

struct RenderSettings {
    ImageFormat format;  ///< the same as the structure was built for, where that has a view
    WavefrontSettings wavefront;
    int threads = 0;           ///< 0: as many as the machine has; counting takes one
    Mode mode = Mode::timing;  ///< counting: one session, tiles in stream order
    RenderProgress progress;   ///< may be empty
};

struct RenderResult {
    Image image;
    RayCounts counts;  ///< of the tracer itself, in either mode
    double seconds = 0;
    /// Mode::counting: the session that answered, with its counters and its members'; else null.
    std::unique_ptr<Session> session;
};

/// Throws std::invalid_argument for a structure that is not complete, settings out of range or
/// lights that Whitted shading cannot do.
RenderResult render(const Scene& scene, const Accel& accel, const RenderSettings& settings);

}  // namespace rayshoot

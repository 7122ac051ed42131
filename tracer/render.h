#pragma once

#include "accel/core/intersector.h"

#include <functional>
#include <memory>
#include <optional>

#include "tracer/camera.h"
#include "tracer/film/adaptive.h"
#include "tracer/film/film.h"
#include "tracer/filter/filter.h"
#include "tracer/image.h"
#include "tracer/integrator/transport.h"
#include "tracer/ray_counts.h"
#include "tracer/sampling/sampler.h"
#include "tracer/shutter.h"

/// Renders a scene through any complete structure.
namespace rayshoot {

/// Called now and then while rendering, from one thread at a time.
using RenderProgress = std::function<void(double share_done, double seconds_left)>;

struct RenderSettings {
    ImageFormat format;  ///< spp and seed are the sampler's, too
    SamplerKind sampler = SamplerKind::jitter;
    bool blue_noise = false;  ///< SamplerSettings::blue_noise
    bool cook_time = false;   ///< SamplerSettings::cook_time
    FilterSettings filter;
    Reconstruction reconstruction = Reconstruction::importance;
    ShutterWeight shutter = ShutterWeight::box;
    TransportSettings transport;
    std::optional<AdaptiveSettings> adaptive;  ///< none: format.spp samples everywhere
    std::size_t batch = default_batch;         ///< most rays in one call, 1 to max_batch
    int threads = 0;                ///< 0: as many as the machine has; counting takes one
    Mode mode = Mode::timing;       ///< counting: one session, tiles in stream order
    RenderProgress progress;        ///< may be empty
    std::function<bool()> stopped;  ///< may be empty; true: no further tile is begun
};

struct RenderResult {
    Image image;       ///< what of it was traced, when it was stopped
    RayCounts counts;  ///< of the tracer itself, in either mode
    double seconds = 0;
    double answering_seconds = 0;  ///< of all lanes together, in the structure; of no first pass
    bool stopped = false;
    /// Mode::counting: the session that answered, with its counters and its members'; else null.
    std::unique_ptr<Session> session;
};

/// Throws std::invalid_argument for a structure that is not complete and settings out of range.
RenderResult render(const Scene& scene, const Accel& accel, const RenderSettings& settings);

/// What a structure for rendering `scene` with these settings is built from; refers to `scene`.
BuildInput build_input(const Scene& scene, const RenderSettings& settings);

}  // namespace rayshoot

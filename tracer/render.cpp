#include "tracer/render.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>

#include "tracer/integrator/irradiance_fill.h"
#include "tracer/lanes.h"
#include "tracer/tiles.h"

namespace rayshoot {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Counts tiles and reports at most ten times a second; a lane that finds another one reporting
/// goes on with its work.
class ProgressMeter {
public:
    ProgressMeter(const RenderProgress& report, std::size_t tiles, Clock::time_point start)
        : report_(report), tiles_(static_cast<double>(tiles)), start_(start) {}

    void finish_tile() {
        const std::size_t done = ++done_;
        if (!report_) return;
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock || seconds_since(last_) < 0.1) return;
        last_ = Clock::now();
        const double share = static_cast<double>(done) / tiles_;
        report_(share, seconds_since(start_) * (1 - share) / share);
    }

private:
    const RenderProgress& report_;
    double tiles_;
    Clock::time_point start_;
    Clock::time_point last_ = start_;
    std::mutex mutex_;
    std::atomic<std::size_t> done_ = 0;
};

void require_valid(const Accel& accel, const RenderSettings& settings) {
    if (!accel.complete()) {
        throw std::invalid_argument("'" + accel.spec() +
                                    "' answers only some rays; add a complete " + "structure: '" +
                                    accel.spec() + "+bvh'");
    }
    if (settings.batch < 1 || settings.batch > max_batch) {
        throw std::invalid_argument("batch " + std::to_string(settings.batch) +
                                    ": must be from 1 to " + std::to_string(max_batch));
    }
    if (settings.threads < 0) {
        throw std::invalid_argument("threads " + std::to_string(settings.threads) +
                                    ": must be 0 (all) or more");
    }
}

Sampling sampling_of(const RenderSettings& settings) {
    Sampling sampling{{.kind = settings.sampler,
                       .spp = settings.format.spp,
                       .blue_noise = settings.blue_noise,
                       .cook_time = settings.cook_time,
                       .seed = settings.format.seed},
                      std::nullopt};
    const Sampler checked(sampling.sampler);
    if (settings.adaptive) sampling.adaptive.emplace(*settings.adaptive);
    return sampling;
}

Film film_of(const RenderSettings& settings, const Filter& filter) {
    return Film(settings.format.width, settings.format.height, filter, settings.reconstruction);
}

}  // namespace

BuildInput build_input(const Scene& scene, const RenderSettings& settings) {
    return build_input(scene, settings.format, film_of(settings, Filter(settings.filter)).border());
}

RenderResult render(const Scene& scene, const Accel& accel, const RenderSettings& settings) {
    require_valid(accel, settings);
    const Filter filter(settings.filter);
    Film film = film_of(settings, filter);
    const CameraRays camera(scene.camera, settings.format, film.border());
    const CameraSamples samples(camera, filter, settings.reconstruction,
                                shutter_of(scene, settings.shutter));
    const Sampling sampling = sampling_of(settings);
    const Tiles tiles(settings.format, settings.batch, film.traced_border());

    RenderResult result;
    const Clock::time_point start = Clock::now();
    std::optional<IrradianceCache> cache;
    if (settings.transport.method == Method::irradiance) {
        cache = fill_irradiance_cache(scene, accel, camera, settings.transport, settings.batch,
                                      settings.threads);
    }
    const auto integrator = make_integrator(scene, settings.transport, cache ? &*cache : nullptr);
    ProgressMeter meter(settings.progress, tiles.size(), start);
    Lanes lanes([&] {
        std::unique_ptr<Session> session = accel.open(settings.mode);
        Session& opened = *session;
        return std::make_unique<Lane>(std::move(session),
                                      TileTracer(samples, sampling, film, *integrator, opened,
                                                 scene.lights.size(), settings.batch));
    });
    std::atomic<bool> stopped = false;
    const auto trace_tile = [&](std::size_t tile) {
        if (stopped || (settings.stopped && settings.stopped())) {
            stopped = true;
            return;
        }
        std::unique_ptr<Lane> lane = lanes.take();
        lane->tracer.trace(tile, tiles.tile(tile));
        lanes.put_back(std::move(lane));
        meter.finish_tile();
    };
    if (settings.mode == Mode::counting) {
        for (std::size_t tile = 0; tile < tiles.size(); ++tile) trace_tile(tile);
    } else {
        tbb::task_arena arena(settings.threads == 0 ? tbb::task_arena::automatic
                                                    : settings.threads);
        // Begun in their order, whatever oneTBB's: few tiles of splats wait for others.
        std::atomic<std::size_t> next = 0;
        arena.execute([&] {
            tbb::parallel_for(std::size_t{0}, tiles.size(),
                              [&](std::size_t) { trace_tile(next++); });
        });
    }
    result.image = film.image();
    result.seconds = seconds_since(start);
    result.stopped = stopped;
    for (std::unique_ptr<Lane>& lane : lanes.all()) {
        result.counts += lane->tracer.counts();
        result.answering_seconds += std::chrono::duration<double>(lane->tracer.answering()).count();
        if (settings.mode == Mode::counting) result.session = std::move(lane->session);
    }
    return result;
}

}  // namespace rayshoot

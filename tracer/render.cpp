#include "tracer/render.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>

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

void require_valid(const Scene& scene, const Accel& accel, const RenderSettings& settings) {
    require_valid(settings.format);
    require_simple_lights(scene);
    if (!accel.complete()) {
        throw std::invalid_argument("'" + accel.spec() +
                                    "' answers only some rays; add a complete " + "structure: '" +
                                    accel.spec() + "+bvh'");
    }
    const WavefrontSettings& wavefront = settings.wavefront;
    if (wavefront.batch < 1 || wavefront.batch > max_batch) {
        throw std::invalid_argument("batch " + std::to_string(wavefront.batch) +
                                    ": must be from 1 to " + std::to_string(max_batch));
    }
    if (wavefront.depth < 1 || wavefront.depth > largest_depth) {
        throw std::invalid_argument("depth " + std::to_string(wavefront.depth) +
                                    ": must be from 1 to " + std::to_string(largest_depth));
    }
    if (settings.threads < 0) {
        throw std::invalid_argument("threads " + std::to_string(settings.threads) +
                                    ": must be 0 (all) or more");
    }
}

}  // namespace

RenderResult render(const Scene& scene, const Accel& accel, const RenderSettings& settings) {
    require_valid(scene, accel, settings);
    const CameraRays camera(scene.camera, settings.format);
    const Tiles tiles(settings.format, settings.wavefront.batch);
    RenderResult result;
    result.image = Image(settings.format.width, settings.format.height);

    const Clock::time_point start = Clock::now();
    ProgressMeter meter(settings.progress, tiles.size(), start);
    Lanes lanes([&] {
        return std::make_unique<Lane>(scene, camera, settings.wavefront, accel.open(settings.mode),
                                      result.image);
    });
    const auto trace_tile = [&](std::size_t tile) {
        std::unique_ptr<Lane> lane = lanes.take();
        lane->wavefront.trace(tiles.tile(tile));
        lanes.put_back(std::move(lane));
        meter.finish_tile();
    };
    if (settings.mode == Mode::counting) {
        for (std::size_t tile = 0; tile < tiles.size(); ++tile) trace_tile(tile);
    } else {
        tbb::task_arena arena(settings.threads == 0 ? tbb::task_arena::automatic
                                                    : settings.threads);
        arena.execute([&] { tbb::parallel_for(std::size_t{0}, tiles.size(), trace_tile); });
    }
    result.seconds = seconds_since(start);
    for (std::unique_ptr<Lane>& lane : lanes.all()) {
        result.counts += lane->wavefront.counts();
        if (settings.mode == Mode::counting) result.session = std::move(lane->session);
    }
    return result;
}

}  // namespace rayshoot

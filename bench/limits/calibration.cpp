#include "bench/limits/calibration.h"

#include "bench/timing/stream_tracer.h"
#include "data/scenes.h"
#include "tracer/recorder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <list>
#include <stdexcept>

namespace rayshoot {
namespace {

constexpr std::array soup_sizes{8, 16, 32, 64, 96, 128, 192, 256};  // triangles of a soup
constexpr std::array spheres{1.0f, 1.5f, 2.5f};  // the larger, the more rays pass the soup by

Box grown(const Box& box, float factor) {
    const vec3 half = 0.5f * factor * box.size();
    return {box.centre() - half, box.centre() + half};
}

/// A soup with its structure; streams and tracers refer to it, so it does not move.
struct SmallScene {
    Scene scene;
    std::unique_ptr<Accel> accel;
};

/// A stream through a small scene.
struct Trial {
    RayStream stream;
    std::unique_ptr<StreamTracer> tracer;
    CostSample sample;
};

std::unique_ptr<Accel> small_tree(const Catalogue& catalogue, const std::string& spec,
                                  const Scene& scene, std::size_t most_bytes) {
    auto accel = build(catalogue, spec, {.geometry = scene.geometry});
    const auto bytes = accel->footprint().bytes;
    if (!bytes) throw std::invalid_argument(spec + " does not tell how large it is");
    return *bytes <= most_bytes ? std::move(accel) : nullptr;
}

void count(const Accel& accel, Trial& trial) {
    const StreamCounts counts = count_stream(accel, trial.stream, default_batch);
    if (!counts.available) throw std::invalid_argument(accel.spec() + " cannot count its steps");
    const auto rays = static_cast<double>(counts.rays);
    trial.sample.steps = static_cast<double>(counts.total[Event::step]) / rays;
    trial.sample.leaves = static_cast<double>(counts.total[Event::cell]) / rays;
    trial.sample.ns = std::numeric_limits<double>::infinity();
}

void add_trials(const SmallScene& small, const CalibrationSettings& settings,
                std::list<Trial>& trials) {
    for (const float sphere : spheres) {
        Trial& trial = trials.emplace_back();
        trial.stream.rays = random_chords(grown(small.scene.geometry.bounds(), sphere),
                                          settings.rays, static_cast<std::uint32_t>(settings.seed));
        trial.tracer = std::make_unique<StreamTracer>(*small.accel, trial.stream, TraceSettings{});
        count(*small.accel, trial);
    }
}

}  // namespace

std::vector<CostSample> calibrate(const Catalogue& catalogue, const std::string& spec,
                                  const CalibrationSettings& settings) {
    std::list<SmallScene> scenes;
    std::list<Trial> trials;
    for (const int size : soup_sizes) {
        SmallScene& small = scenes.emplace_back();
        small.scene = load_scene("soup:count=" + std::to_string(size));
        small.accel = small_tree(catalogue, spec, small.scene, settings.most_bytes);
        if (small.accel) add_trials(small, settings, trials);
    }
    if (trials.empty()) {
        throw std::invalid_argument("the trees of " + spec +
                                    " over a few triangles take more than " +
                                    std::to_string(settings.most_bytes) +
                                    " bytes; name another spec with --alone or --in-flight");
    }
    for (int pass = 0; pass < settings.repetitions; ++pass) {
        for (Trial& trial : trials) {
            const double ns = 1e9 * trial.tracer->trace_warm() / static_cast<double>(settings.rays);
            trial.sample.ns = std::min(trial.sample.ns, ns);
        }
    }
    std::vector<CostSample> samples;
    for (const Trial& trial : trials) samples.push_back(trial.sample);
    return samples;
}

}  // namespace rayshoot

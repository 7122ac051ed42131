#include "tracer/integrator/transport.h"

#include <stdexcept>
#include <string>

#include "tracer/integrator/path_tracer.h"
#include "tracer/integrator/whitted.h"
#include "tracer/wavefront.h"

namespace rayshoot {
namespace {

void check(const char* what, int value, int least, int most) {
    if (value >= least && value <= most) return;
    throw std::invalid_argument(std::string(what) + " " + std::to_string(value) +
                                ": must be from " + std::to_string(least) + " to " +
                                std::to_string(most));
}

}  // namespace

std::unique_ptr<Integrator> make_integrator(const Scene& scene, const TransportSettings& settings,
                                            const IrradianceCache* cache) {
    check("depth", settings.depth, 0, largest_depth);
    check("light samples", settings.light_samples, 0, largest_light_samples);
    check("roulette level", settings.roulette_level, 1, largest_depth);
    check("gathered rays", settings.gather, 1, largest_gather);
    if (settings.method == Method::whitted) return std::make_unique<Whitted>(scene, settings);
    return std::make_unique<PathTracer>(scene, settings, cache);
}

}  // namespace rayshoot

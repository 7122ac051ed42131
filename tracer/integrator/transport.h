#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "tracer/integrator/integrator.h"
#include "tracer/integrator/irradiance_cache.h"
#include "tracer/shading.h"

/// Which light is followed, and how far.
namespace rayshoot {

/// whitted: mirror and refracted rays and light from every source (Whitted 1980), each distributed
/// where the scene has lamps of a size and blurred mirrors (Cook, Porter & Carpenter 1984), by the
/// NFF surface model. path: the rendering equation (Kajiya 1986), in physical units. irradiance:
/// the same with what matt surfaces send each other interpolated (Ward, Rubinstein & Clear 1988).
enum class Method : std::uint8_t { whitted, path, irradiance };
inline constexpr std::array<std::string_view, 3> method_names{"whitted", "path", "irradiance"};

inline constexpr int whitted_depth = 5, path_depth = 32;
inline constexpr int largest_light_samples = 4096, largest_gather = 65536;

struct TransportSettings {
    Method method = Method::whitted;
    Rules rules = Rules::spd_readme;  ///< of whitted
    /// Levels of the tree of rays; the camera ray's is 1. 0: 5 of whitted, as the SPD rules have
    /// it, 32 of the others, which roulette ends earlier.
    int depth = 0;
    int light_samples = 0;     ///< shadow rays to each lamp of a size; 0: as the scene says
    int roulette_level = 4;    ///< from which level on paths may be ended by chance
    int gather = 256;          ///< of irradiance: rays that make one record
    float cache_error = 0.2f;  ///< of irradiance: Ward's estimate, (0, 1]
};

/// Levels of the tree of rays, where the settings leave it to the method.
inline int levels(const TransportSettings& settings) {
    if (settings.depth > 0) return settings.depth;
    return settings.method == Method::whitted ? whitted_depth : path_depth;
}

/// Refers to `scene` and to `cache`, which the method irradiance needs and no other takes. Throws
/// std::invalid_argument for settings out of range.
std::unique_ptr<Integrator> make_integrator(const Scene& scene, const TransportSettings& settings,
                                            const IrradianceCache* cache = nullptr);

}  // namespace rayshoot

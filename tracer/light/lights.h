#pragma once

#include <optional>
#include <vector>

#include "data/scene.h"
#include "tracer/light/emitter.h"
#include "tracer/light/light_sample.h"
#include "tracer/sampling/pair.h"

/// All light of a scene: its lights as they are sampled, and what its primitives emit.
namespace rayshoot {

inline constexpr std::uint32_t no_light = 0xffffffff;

class Lights {
public:
    /// Refers to `scene`. Throws std::invalid_argument, with the remedy, for a light that is not
    /// one (require_valid.h), or two that shine from the same primitive.
    explicit Lights(const Scene& scene);

    std::uint32_t size() const { return static_cast<std::uint32_t>(emitters_.size()); }

    /// A point of light `light` as seen from `from` at shutter time `time`. Empty: from there it is
    /// dark or seen from behind. Strata of the pair become strata of the light.
    std::optional<LightSample> sample(std::uint32_t light, const dvec3& from, float time,
                                      Pair pair) const;
    /// The density per solid angle, seen from `from`, with which sample() takes the direction to
    /// `at`, a point of one of the light's primitives (surface_point of a hit). 0: it never does.
    float pdf(std::uint32_t light, const dvec3& from, const SurfacePoint& at, float time) const;

    /// One light, by power. `u` in [0, 1).
    struct Choice {
        std::uint32_t light = no_light;  ///< no_light: the scene has none
        float probability = 0;           ///< by which its contribution is to be divided
    };
    Choice choose(float u) const;
    float probability(std::uint32_t light) const { return probabilities_[light]; }

    /// The light whose primitive this is, or no_light: then sample() never leads there, and what it
    /// emits is met by chance alone.
    std::uint32_t light_of(std::uint32_t primitive) const {
        return light_of_.empty() ? no_light : light_of_[primitive];
    }
    /// Radiance that a point of `primitive` sends in `direction` (unit, away from it).
    vec3 emitted(std::uint32_t primitive, const SurfacePoint& at, const vec3& direction) const;

private:
    void own_primitives();
    void weigh();

    const Scene& scene_;
    std::vector<Emitter> emitters_;
    std::vector<std::uint32_t> light_of_;  ///< per primitive; empty if no light has any
    std::vector<float> cumulative_;        ///< probability of this light or one before it
    std::vector<float> probabilities_;
};

}  // namespace rayshoot

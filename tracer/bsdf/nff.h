#pragma once

#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/lambert.h"
#include "tracer/bsdf/lobe.h"
#include "tracer/bsdf/power_lobe.h"

namespace rayshoot {

struct Material;

/// The surface of an NFF file read as a physical one: what Whitted's integrator draws of it, as
/// shares of the light. Diffuse colour Kd; a highlight Ks / pi cos^n, which is the share 2 Ks / (n
/// + 2) of the normalised lobe; a mirror of share Ks; T passes, refracted. Where they sum to more
/// than 1 in a channel all are scaled down. `gloss` g > 0 makes the mirror a Phong lobe of exponent
/// g and the refraction one by microfacets as wide; both are sharp else.
class Nff {
public:
    /// `index` > 0 of the far medium / the near one.
    Nff(const Material& material, float index);

    vec3 evaluate(const vec3& out, const vec3& in) const;
    float pdf(const vec3& out, const vec3& in) const;
    std::optional<LobeSample> sample(const vec3& out, float choice, Pair pair) const;
    bool only_deltas() const;
    const vec3& reflectance() const { return diffuse_.reflectance(); }

private:
    /// How much the parts reflect or pass; or with which probability each is sampled.
    struct Parts {
        float diffuse = 0, highlight = 0, mirror = 0, passing = 0;

        float sum() const { return diffuse + highlight + mirror + passing; }
        Parts scaled(float by) const {
            return {diffuse * by, highlight * by, mirror * by, passing * by};
        }
    };
    static Parts shares(const Material& material);
    Parts probabilities(const vec3& out) const;
    /// Whether Snell's law has no direction beyond for one on the near side, or, z < 0, the far
    /// one.
    bool totally_reflected(const vec3& direction) const;
    LobeSample sharp_reflection(const vec3& out, float probability) const;
    LobeSample sharp_refraction(const vec3& out, float probability) const;
    /// z > 0 if there is none.
    vec3 blurred_refraction(const vec3& out, Pair pair) const;

    Parts share_;
    Lambert diffuse_;
    PowerLobe highlight_, blur_;
    Ggx facets_;
    float index_;   ///< of the far medium / that of the near one
    bool sharp_;    ///< mirror and refraction both
    bool matched_;  ///< the media are one: what passes goes straight on
};
static_assert(Lobe<Nff>);

}  // namespace rayshoot

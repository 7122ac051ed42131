#include "tracer/bsdf/nff.h"

#include <algorithm>
#include <cmath>

#include "data/scene.h"
#include "tracer/bsdf/facet_refraction.h"
#include "tracer/bsdf/fresnel.h"

namespace rayshoot {
namespace {

vec3 across_surface(const vec3& direction) { return {direction.x, direction.y, -direction.z}; }

/// Facets that spread reflected light as cos^gloss does: normals turn by half as much as
/// directions, so theirs is cos^(4 gloss), and alpha = sqrt(2 / (n + 2)) (Walter et al. 2007).
float roughness_of(float gloss) {
    return std::clamp(std::sqrt(2 / (4 * gloss + 2)), smallest_roughness, 1.0f);
}

/// The same hue, of another mean.
vec3 brought_to(const vec3& colour, float to) {
    const float from = mean(colour);
    return from > 0 ? colour * (to / from) : vec3(0);
}

}  // namespace

Nff::Parts Nff::shares(const Material& material) {
    const vec3 colour = material.colour * material.diffuse;
    const float highlight = 2 * material.specular / (material.shininess + 2);
    const Parts given{mean(colour), highlight, material.specular, material.transmittance};
    return given.scaled(energy_limit(given.sum() - given.diffuse + largest(colour)));
}

Nff::Nff(const Material& material, float index)
    : share_(shares(material)),
      diffuse_(brought_to(material.colour * material.diffuse, share_.diffuse)),
      highlight_{material.shininess},
      blur_{material.gloss},
      facets_{roughness_of(material.gloss)},
      index_(index),
      sharp_(!(material.gloss > 0)),
      matched_(std::abs(index_ - 1) < smallest_contrast) {}

bool Nff::totally_reflected(const vec3& direction) const {
    const float index = direction.z > 0 ? index_ : 1 / index_;
    return 1 - direction.z * direction.z > index * index;
}

Nff::Parts Nff::probabilities(const vec3& out) const {
    Parts parts = share_;
    if (totally_reflected(out)) {
        parts.mirror += parts.passing;
        parts.passing = 0;
    }
    const float sum = parts.sum();
    return sum > 0 ? parts.scaled(1 / sum) : Parts{};
}

/// Total reflection is symmetric here, as it must be: what passes for neither direction is
/// mirrored only where it passes for neither.
vec3 Nff::evaluate(const vec3& out, const vec3& in) const {
    if (in.z > 0) {
        float white = share_.highlight * highlight_.evaluate(out, in);
        if (!sharp_) {
            const bool total = totally_reflected(out) && totally_reflected(in);
            white += (share_.mirror + (total ? share_.passing : 0)) * blur_.evaluate(out, in);
        }
        return diffuse_.evaluate(out, in) + vec3(white);
    }
    if (sharp_ || totally_reflected(out) || totally_reflected(in)) return vec3(0);
    if (matched_) return vec3(share_.passing * blur_.evaluate(out, across_surface(in)));
    const auto facet = facet_refraction(facets_, index_, out, in);
    return facet ? vec3(share_.passing * facet->scattered) : vec3(0);
}

float Nff::pdf(const vec3& out, const vec3& in) const {
    const Parts by = probabilities(out);
    if (in.z > 0) {
        return by.diffuse * diffuse_.pdf(out, in) + by.highlight * highlight_.pdf(out, in) +
               (sharp_ ? 0 : by.mirror * blur_.pdf(out, in));
    }
    if (sharp_ || !(by.passing > 0)) return 0;
    if (matched_) return by.passing * blur_.pdf(out, across_surface(in));
    const auto facet = facet_refraction(facets_, index_, out, in);
    return facet ? by.passing * facet->density : 0;
}

bool Nff::only_deltas() const { return sharp_ && share_.diffuse == 0 && share_.highlight == 0; }

LobeSample Nff::sharp_reflection(const vec3& out, float probability) const {
    const float share = share_.mirror + (totally_reflected(out) ? share_.passing : 0);
    return {mirrored(out), vec3(share / probability), 0, true};
}

LobeSample Nff::sharp_refraction(const vec3& out, float probability) const {
    const float cosine = refraction(out.z, index_).transmitted_cosine;
    const vec3 in = refracted(out, {0, 0, 1}, out.z, index_, cosine);
    return {in, vec3(share_.passing / (probability * index_ * index_)), 0, true};
}

vec3 Nff::blurred_refraction(const vec3& out, Pair pair) const {
    if (matched_) return across_surface(blur_.sample(out, pair));
    const vec3 facet = facets_.visible_normal(out, pair);
    const float cosine = dot(out, facet);
    const auto [reflectance, transmitted_cosine] = refraction(cosine, index_);
    if (reflectance == 1) return {0, 0, 1};  // no way through this facet
    return refracted(out, facet, cosine, index_, transmitted_cosine);
}

std::optional<LobeSample> Nff::sample(const vec3& out, float choice, Pair pair) const {
    const Parts by = probabilities(out);
    const float reflecting = by.diffuse + by.highlight + by.mirror;
    vec3 in;
    if (choice < by.diffuse) {
        in = cosine_hemisphere(pair);
    } else if (choice < by.diffuse + by.highlight) {
        in = highlight_.sample(out, pair);
    } else if (choice < reflecting) {
        if (sharp_) return sharp_reflection(out, by.mirror);
        in = blur_.sample(out, pair);
    } else {
        if (!(by.passing > 0)) return std::nullopt;
        if (sharp_) return sharp_refraction(out, by.passing);
        in = blurred_refraction(out, pair);
    }
    if ((choice < reflecting) != (in.z > 0)) return std::nullopt;  // clipped at the surface
    const float density = pdf(out, in);
    if (!(density > 0)) return std::nullopt;
    return LobeSample{in, evaluate(out, in) / density, density};
}

}  // namespace rayshoot

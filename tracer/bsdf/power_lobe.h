#pragma once

#include <cmath>

#include "tracer/bsdf/frame.h"
#include "tracer/bsdf/lobe.h"
#include "tracer/sampling/warp.h"

namespace rayshoot {

/// Phong's lobe round the mirror direction, modified and normalised (Lafortune & Willems 1994):
/// f = (n + 2) / (2 pi) cos^n of the angle between `in` and the mirrored `out`. Reciprocal; its
/// albedo is 1 at normal incidence and less elsewhere, by what is clipped below the surface and by
/// the cosine. For n = 0 it is Lambert's. Sampled by (n + 1) / (2 pi) cos^n.
struct PowerLobe {
    float exponent = 1;  ///< n >= 0

    float evaluate(const vec3& out, const vec3& in) const {
        if (!(in.z > 0)) return 0;
        const float density = phong_lobe_pdf(dot(mirrored(out), in), exponent);
        return density * weight(in);
    }
    float pdf(const vec3& out, const vec3& in) const {
        return in.z > 0 ? phong_lobe_pdf(dot(mirrored(out), in), exponent) : 0;
    }
    /// Below the surface: z <= 0.
    vec3 sample(const vec3& out, Pair pair) const {
        return Frame(mirrored(out)).to_world(phong_lobe(pair, exponent));
    }
    /// evaluate / pdf.
    float weight(const vec3& in) const { return (exponent + 2) / (exponent + 1) * in.z; }
};

}  // namespace rayshoot

#pragma once

#include <optional>
#include <variant>

#include "data/scene.h"
#include "tracer/bsdf/coated.h"
#include "tracer/bsdf/conductor.h"
#include "tracer/bsdf/dielectric.h"
#include "tracer/bsdf/frame.h"
#include "tracer/bsdf/lambert.h"
#include "tracer/bsdf/nff.h"
#include "tracer/bsdf/oren_nayar.h"
#include "tracer/bsdf/phong.h"
#include "tracer/sampling/pair.h"
#include "tracer/surface.h"

/// How a surface scatters light at one hit, towards one direction.
namespace rayshoot {

/// Directions are unit vectors of the world that point away from the surface: `out` to where the
/// ray came from, `in` to where light may come from. Light leaks nowhere: an `in` that the shading
/// normal and the geometric one put on different sides is dark, to evaluate, pdf and sample alike.
/// Where the shading normal faces away from `out` the geometric one takes its place.
class Bsdf {
public:
    struct Sample {
        vec3 in;
        vec3 weight;         ///< f |cos in| / pdf; of a delta: what it passes on / its probability
        float pdf = 0;       ///< per solid angle, as pdf(in) is; of a delta 0
        bool delta = false;  ///< sharp: no other direction is near enough to be the same
    };

    Bsdf(const Material& material, const SurfacePoint& point, const vec3& out);

    /// f |cos in|, of all that is not a delta. Radiance: light that comes out of a medium of index
    /// n into one of index m is m^2 / n^2 times as strong.
    vec3 evaluate(const vec3& in) const;
    /// Density of sample() per solid angle, of all that is not a delta. Integrates to less than 1:
    /// the rest is the probability of a delta, or that nothing is sampled.
    float pdf(const vec3& in) const;
    /// Empty: absorbed. `choice` in [0, 1) picks the lobe, `direction` the direction within it.
    std::optional<Sample> sample(float choice, Pair direction) const;

    /// Nothing but deltas: evaluate and pdf are 0 everywhere, samples of lights are in vain.
    bool only_deltas() const;
    /// The reflectance of its Lambertian part, if it has one of its own: evaluate() less that part
    /// is what remains when indirect diffuse light is cached.
    vec3 diffuse_reflectance() const;
    /// The shading normal used, on the side of `out`.
    const vec3& normal() const { return frame_.normal; }

private:
    using AnyLobe =
        std::variant<Lambert, OrenNayar, Phong, CoatedDiffuser, Conductor, Dielectric, Nff>;
    static AnyLobe lobe_of(const Material& material, bool from_front);
    /// Whether both normals put `in` on the same side.
    bool consistent(const vec3& in, float cosine) const;

    Frame frame_;     ///< round the shading normal
    vec3 geometric_;  ///< on the side of `out`, as frame_.normal is
    vec3 out_;        ///< in the frame: z > 0
    AnyLobe lobe_;
};

/// Throws std::invalid_argument, naming the field and its range, for values that no model takes:
/// colours and shares outside [0, 1] (NFF's are scaled down where their sum is too large),
/// roughness outside [0, 1] (Oren-Nayar: [0, pi / 2]), negative powers, indices or radiances, what
/// is no number.
void require_physical(const Material& material);

}  // namespace rayshoot

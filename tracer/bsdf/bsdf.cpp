#include "tracer/bsdf/bsdf.h"

#include <algorithm>

namespace rayshoot {
namespace {

/// What is seen at a more grazing angle is taken for this one: cosines are divided by.
constexpr float smallest_cosine = 1e-6f;

/// The stored normal on the side of `out`.
vec3 facing(const vec3& normal, const vec3& out) { return dot(normal, out) < 0 ? -normal : normal; }

/// Turned to the geometric normal's side; that normal itself where `out` would be below.
vec3 usable(const vec3& shading, const vec3& geometric, const vec3& out) {
    const vec3 turned = facing(shading, geometric);
    return dot(turned, out) > 0 ? turned : geometric;
}

/// Of the medium beyond the surface / the one that it is seen from.
float index_of(const Material& material, bool from_front) {
    const float index = material.refraction_index > 0 ? material.refraction_index : 1;
    return from_front ? index : 1 / index;
}

}  // namespace

Bsdf::Bsdf(const Material& material, const SurfacePoint& point, const vec3& out)
    : geometric_(facing(point.geometric, out)),
      lobe_(lobe_of(material, dot(point.geometric, out) >= 0)) {
    frame_ = Frame(usable(point.shading, geometric_, out));
    out_ = frame_.to_local(out);
    out_.z = std::max(out_.z, smallest_cosine);
}

Bsdf::AnyLobe Bsdf::lobe_of(const Material& material, bool from_front) {
    const vec3 reflectance = material.colour * material.diffuse;
    switch (material.model) {
        case SurfaceModel::nff:
            return Nff(material, index_of(material, from_front));
        case SurfaceModel::lambert:
            return Lambert{reflectance};
        case SurfaceModel::oren_nayar:
            return OrenNayar(reflectance, material.roughness);
        case SurfaceModel::phong:
            return Phong(reflectance, material.specular, material.shininess);
        case SurfaceModel::cook_torrance:
            return CoatedDiffuser(reflectance, material.specular, index_of(material, true),
                                  material.roughness);
        case SurfaceModel::conductor:
            return Conductor(material.colour, material.eta, material.absorption,
                             material.roughness);
        case SurfaceModel::dielectric:
            return Dielectric(material.colour, index_of(material, from_front), material.roughness);
    }
    return Lambert{vec3(0)};
}

bool Bsdf::consistent(const vec3& in, float cosine) const {
    return dot(in, geometric_) * cosine > 0;
}

vec3 Bsdf::evaluate(const vec3& in) const {
    const vec3 local = frame_.to_local(in);
    if (!consistent(in, local.z)) return vec3(0);
    return std::visit([&](const auto& lobe) { return lobe.evaluate(out_, local); }, lobe_);
}

float Bsdf::pdf(const vec3& in) const {
    const vec3 local = frame_.to_local(in);
    if (!consistent(in, local.z)) return 0;
    return std::visit([&](const auto& lobe) { return lobe.pdf(out_, local); }, lobe_);
}

std::optional<Bsdf::Sample> Bsdf::sample(float choice, Pair direction) const {
    const auto local =
        std::visit([&](const auto& lobe) { return lobe.sample(out_, choice, direction); }, lobe_);
    if (!local) return std::nullopt;
    const vec3 in = normalised(frame_.to_world(local->in));
    if (!consistent(in, local->in.z)) return std::nullopt;
    return Sample{in, local->weight, local->pdf, local->delta};
}

bool Bsdf::only_deltas() const {
    return std::visit([](const auto& lobe) { return lobe.only_deltas(); }, lobe_);
}

vec3 Bsdf::diffuse_reflectance() const {
    return std::visit(
        [](const auto& lobe) {
            if constexpr (requires { lobe.reflectance(); }) return lobe.reflectance();
            else return vec3(0);
        },
        lobe_);
}

}  // namespace rayshoot

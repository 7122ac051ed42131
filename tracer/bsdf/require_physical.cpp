#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tracer/bsdf/bsdf.h"

namespace rayshoot {
namespace {

void require_between(const char* field, float value, float lo, float hi) {
    if (value >= lo && value <= hi && std::isfinite(value)) return;
    const std::string range = std::isfinite(hi)
                                  ? "from " + std::to_string(lo) + " to " + std::to_string(hi)
                                  : "of at least " + std::to_string(lo);
    throw std::invalid_argument("a material's " + std::string(field) + " is " +
                                std::to_string(value) + "; give a number " + range);
}

void require_between(const char* field, const vec3& value, float lo, float hi) {
    for (int channel = 0; channel < 3; ++channel) require_between(field, value[channel], lo, hi);
}

float largest_roughness(SurfaceModel model) {
    return model == SurfaceModel::oren_nayar ? std::numbers::pi_v<float> / 2 : 1;
}

}  // namespace

void require_physical(const Material& material) {
    const bool scaled =
        material.model == SurfaceModel::nff || material.model == SurfaceModel::phong;
    const float largest_share = scaled ? infinity : 1;
    require_between("colour", material.colour, 0, largest_share);
    require_between("diffuse", material.diffuse, 0, largest_share);
    require_between("specular", material.specular, 0, largest_share);
    require_between("transmittance", material.transmittance, 0, largest_share);
    require_between("shininess", material.shininess, 0, infinity);
    require_between("refraction index", material.refraction_index, 0, infinity);
    require_between("roughness", material.roughness, 0, largest_roughness(material.model));
    require_between("gloss", material.gloss, 0, infinity);
    require_between("eta", material.eta, 0, infinity);
    require_between("absorption", material.absorption, 0, infinity);
    require_between("emission", material.emission, 0, infinity);
}

}  // namespace rayshoot

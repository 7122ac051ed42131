#include "data/nff_surface.h"

#include "data/fields.h"

#include <array>
#include <limits>
#include <numbers>
#include <utility>

namespace rayshoot {
namespace {

constexpr std::array<std::pair<std::string_view, SurfaceModel>, 7> models{
    {{"nff", SurfaceModel::nff},
     {"lambert", SurfaceModel::lambert},
     {"oren_nayar", SurfaceModel::oren_nayar},
     {"phong", SurfaceModel::phong},
     {"cook_torrance", SurfaceModel::cook_torrance},
     {"conductor", SurfaceModel::conductor},
     {"dielectric", SurfaceModel::dielectric}}};

constexpr std::array<std::string_view, 11> fields{"colour",   "diffuse",    "specular", "shine",
                                                  "transmit", "index",      "gloss",    "roughness",
                                                  "eta",      "absorption", "emission"};

constexpr float unbounded = std::numeric_limits<float>::max();

SurfaceModel read_model(Tokens& tokens) {
    const std::string_view word = tokens.next();
    std::string known;
    for (const auto& [name, model] : models) {
        if (word == name) return model;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    tokens.refuse(quoted(word) + " is no model of a surface; there are " + known);
}

float in_range(Tokens& tokens, std::string_view field, float lowest, float highest) {
    const float value = tokens.number(field);
    if (!(value >= lowest && value <= highest))
        tokens.refuse(std::string(field) + " " + std::to_string(value) + " must be " +
                      (highest == unbounded
                           ? "at least " + std::to_string(lowest)
                           : "from " + std::to_string(lowest) + " to " + std::to_string(highest)));
    return value;
}

vec3 at_least_zero(Tokens& tokens, std::string_view field) {
    vec3 value{};
    for (int channel = 0; channel < 3; ++channel)
        value[channel] = in_range(tokens, field, 0, unbounded);
    return value;
}

void read_field(Tokens& tokens, std::string_view field, Material& material) {
    const float roughest = material.model == SurfaceModel::oren_nayar
                               ? static_cast<float>(std::numbers::pi / 2)  // sigma, radians
                               : 1;                                        // alpha
    const auto number = [&](float highest) { return in_range(tokens, field, 0, highest); };
    if (field == "colour") material.colour = at_least_zero(tokens, field);
    if (field == "diffuse") material.diffuse = number(unbounded);
    if (field == "specular") material.specular = number(unbounded);
    if (field == "shine") material.shininess = number(unbounded);
    if (field == "transmit") material.transmittance = number(unbounded);
    if (field == "index") material.refraction_index = number(unbounded);
    if (field == "gloss") material.gloss = number(unbounded);
    if (field == "roughness") material.roughness = number(roughest);
    if (field == "eta") material.eta = at_least_zero(tokens, field);
    if (field == "absorption") material.absorption = at_least_zero(tokens, field);
    if (field == "emission") material.emission = at_least_zero(tokens, field);
}

}  // namespace

Material read_surface(Tokens& tokens) {
    Material material;
    material.model = read_model(tokens);
    Fields given(tokens, "surface", fields);
    for (std::string_view field = given.next(); !field.empty(); field = given.next())
        read_field(tokens, field, material);
    if (material.model == SurfaceModel::dielectric) given.require({"index"});
    return material;
}

}  // namespace rayshoot

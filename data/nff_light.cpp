#include "data/nff_light.h"

#include "data/fields.h"

#include <array>
#include <cmath>
#include <numbers>

namespace rayshoot {
namespace {

constexpr int most_strata = 1024;  // along an axis
constexpr std::array<std::string_view, 2> fields{"strata", "visible"};

vec3 power(Tokens& tokens, std::string_view use) {
    const vec3 value = tokens.three(use);
    if (value.x < 0 || value.y < 0 || value.z < 0)
        tokens.refuse("a light's red, green and blue must not be negative");
    return value;
}

vec3 direction(Tokens& tokens, std::string_view use) {
    const dvec3 given(tokens.three(use));
    if (!(length(given) > 0)) tokens.refuse("a light's direction is zero; give one");
    return vec3(normalised(given));
}

float radius(Tokens& tokens, std::string_view use) {
    const float value = tokens.number(use);
    if (!(value > 0)) tokens.refuse("a light's radius must be more than 0");
    return value;
}

Light point(Tokens& tokens) {
    constexpr std::string_view use = "light point: x y z red green blue";
    Light light;
    light.position = tokens.three(use);
    light.intensity = power(tokens, use);
    light.samples.include(light.position);
    return light;
}

Light directional(Tokens& tokens) {
    constexpr std::string_view use = "light directional: direction x y z, red green blue";
    Light light;
    light.direction = direction(tokens, use);
    light.intensity = power(tokens, use);
    return light;
}

float cosine(Tokens& tokens, std::string_view use) {
    const double degrees = tokens.number(use);
    if (!(degrees >= 0 && degrees <= 90))
        tokens.refuse("the half-angles of a spot must be from 0 to 90 degrees");
    return static_cast<float>(std::cos(degrees * (std::numbers::pi / 180)));
}

Light spot(Tokens& tokens) {
    constexpr std::string_view use =
        "light spot: x y z, direction x y z, inner and outer half-angle, red green blue";
    Light light;
    light.position = tokens.three(use);
    light.direction = direction(tokens, use);
    light.cos_inner = cosine(tokens, use);
    light.cos_outer = cosine(tokens, use);
    if (light.cos_inner < light.cos_outer)
        tokens.refuse("the inner half-angle of a spot must not be larger than the outer");
    light.intensity = power(tokens, use);
    light.samples.include(light.position);
    return light;
}

Light rectangle(Tokens& tokens) {
    constexpr std::string_view use =
        "light rectangle: corner x y z, sides x y z and x y z, red green blue";
    Light light;
    light.position = tokens.three(use);
    light.edge_u = tokens.three(use);
    light.edge_v = tokens.three(use);
    const double size = length(dvec3(light.edge_u)) * length(dvec3(light.edge_v));
    const double slant = std::abs(dot(dvec3(light.edge_u), dvec3(light.edge_v)));
    if (!(size > 0) || !(slant <= 1e-4 * size))  // what rounded corners may come to
        tokens.refuse("the sides of a rectangle must be at right angles and not zero");
    light.intensity = power(tokens, use);
    for (const vec3& corner : {vec3(0), light.edge_u, light.edge_v, light.edge_u + light.edge_v})
        light.samples.include(light.position + corner);
    return light;
}

Light disc(Tokens& tokens) {
    constexpr std::string_view use =
        "light disc: centre x y z, normal x y z, radius, red green blue";
    Light light;
    light.position = tokens.three(use);
    light.direction = direction(tokens, use);
    light.radius = radius(tokens, use);
    light.intensity = power(tokens, use);
    vec3 reach{};
    for (int axis = 0; axis < 3; ++axis) {
        const float along_normal = light.direction[axis];
        reach[axis] = light.radius * std::sqrt(std::max(0.0f, 1 - along_normal * along_normal));
    }
    light.samples.include(light.position - reach);
    light.samples.include(light.position + reach);
    return light;
}

Light sphere(Tokens& tokens) {
    constexpr std::string_view use = "light sphere: centre x y z, radius, red green blue";
    Light light;
    light.position = tokens.three(use);
    light.radius = radius(tokens, use);
    light.intensity = power(tokens, use);
    light.samples.include(light.position - vec3(light.radius));
    light.samples.include(light.position + vec3(light.radius));
    return light;
}

struct Kind {
    std::string_view name;
    LightKind kind;
    Light (*read)(Tokens&);
    bool has_area, may_be_visible;
};
constexpr std::array<Kind, 6> kinds{
    {{"point", LightKind::point, point, false, false},
     {"directional", LightKind::directional, directional, false, false},
     {"spot", LightKind::spot, spot, false, false},
     {"rectangle", LightKind::rectangle, rectangle, true, true},
     {"disc", LightKind::disc, disc, true, false},
     {"sphere", LightKind::sphere, sphere, true, true}}};

const Kind& read_kind(Tokens& tokens) {
    const std::string_view word = tokens.next();
    std::string known;
    for (const Kind& kind : kinds) {
        if (word == kind.name) return kind;
        known += (known.empty() ? "" : ", ") + std::string(kind.name);
    }
    tokens.refuse(quoted(word) + " is no kind of light; there are " + known +
                  ", and surfaces with emission");
}

}  // namespace

NffLight read_light(Tokens& tokens) {
    const Kind& kind = read_kind(tokens);
    NffLight made{.light = kind.read(tokens)};
    made.light.kind = kind.kind;
    made.light.falloff = Falloff::inverse_square;
    if (!made.light.samples.empty() &&
        !(finite(made.light.samples.lo) && finite(made.light.samples.hi)))
        tokens.refuse("the light is too large for single precision; scale the scene down");
    if (!kind.has_area) return made;
    Fields given(tokens, "light", fields);
    for (std::string_view field = given.next(); !field.empty(); field = given.next()) {
        if (field == "strata") {
            constexpr std::string_view use = "strata of a light, across and down";
            made.light.strata_u = static_cast<int>(tokens.integer(use, 1, most_strata));
            made.light.strata_v = static_cast<int>(tokens.integer(use, 1, most_strata));
        } else if (kind.may_be_visible) {
            made.visible = true;
        } else {
            tokens.refuse("a light " + std::string(kind.name) +
                          " cannot be visible; a rectangle and a sphere can");
        }
    }
    return made;
}

}  // namespace rayshoot

#include "data/nff_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rayshoot {
namespace {

void read_view_field(Tokens& tokens, std::string_view field, Camera& camera) {
    if (field == "from") camera.from = tokens.three("from x y z");
    if (field == "at") camera.at = tokens.three("at x y z");
    if (field == "up") camera.up = tokens.three("up x y z");
    if (field == "angle") {
        camera.angle = tokens.number("angle, in degrees");
        if (!(camera.angle > 0 && camera.angle < 180))
            tokens.refuse("the angle must be between 0 and 180 degrees");
    }
    if (field == "hither") camera.hither = at_least_zero(tokens, "hither, a distance");
    if (field == "resolution") {
        constexpr int largest = 1 << 16;  // pixels a side
        camera.width = static_cast<int>(tokens.integer("resolution in x", 1, largest));
        camera.height = static_cast<int>(tokens.integer("resolution in y", 1, largest));
    }
}

/// Calls `corner` for each corner of a polygon.
template <class Corner>
void read_corners(Tokens& tokens, Corner&& corner) {
    constexpr std::int64_t shortest_corner = 6;  // characters: "0 0 0 "
    const std::int64_t most = std::max<std::int64_t>(3, most_to_come(tokens, shortest_corner));
    const std::int64_t count =
        tokens.integer("number of a polygon's corners, which all must follow", 3, most);
    for (std::int64_t i = 0; i < count; ++i) corner();
}

}  // namespace

void read_view(Tokens& tokens, Camera& camera) {
    constexpr std::array<std::string_view, 6> fields{"from",  "at",     "up",
                                                     "angle", "hither", "resolution"};
    std::vector<std::string_view> given;
    while (given.size() < fields.size()) {
        const std::string_view field = tokens.next();
        if (std::ranges::find(fields, field) == fields.end() ||
            std::ranges::find(given, field) != given.end())
            tokens.refuse(quoted(field) +
                          " in a view, which has from, at, up, angle, hither and resolution, "
                          "each once");
        given.push_back(field);
        read_view_field(tokens, field, camera);
    }
    const dvec3 gaze = dvec3(camera.at) - dvec3(camera.from);
    if (taxicab(cross(gaze, dvec3(camera.up))) == 0)
        tokens.refuse("the view has no direction: from equals at, or up is along the gaze");
}

Material read_fill(Tokens& tokens) {
    constexpr std::string_view use = "surface: f red green blue Kd Ks shine T index_of_refraction";
    Material material;
    material.colour = tokens.three(use);
    material.diffuse = at_least_zero(tokens, use);
    material.specular = at_least_zero(tokens, use);
    material.shininess = at_least_zero(tokens, use);
    material.transmittance = at_least_zero(tokens, use);
    material.refraction_index = at_least_zero(tokens, use);
    return material;
}

Sphere read_sphere(Tokens& tokens) {
    Sphere sphere;
    sphere.centre = tokens.three("sphere: s x y z radius");
    sphere.radius = std::abs(tokens.number("sphere: s x y z radius"));
    return sphere;
}

Frustum read_cone(Tokens& tokens) {
    constexpr std::string_view use = "cone: c base x y z radius apex x y z radius";
    Frustum frustum;
    frustum.base = tokens.three(use);
    frustum.base_radius = tokens.number(use);
    frustum.apex = tokens.three(use);
    frustum.apex_radius = tokens.number(use);
    if (std::min(frustum.base_radius, frustum.apex_radius) < 0 &&
        std::max(frustum.base_radius, frustum.apex_radius) > 0)
        tokens.refuse("one radius of this cone is negative; both may be, or none");
    frustum.base_radius = std::abs(frustum.base_radius);
    frustum.apex_radius = std::abs(frustum.apex_radius);
    return frustum;
}

Outline read_polygon(Tokens& tokens) {
    Outline outline;
    read_corners(tokens,
                 [&] { outline.corners.push_back(tokens.three("corner of a polygon: x y z")); });
    return outline;
}

Outline read_patch(Tokens& tokens) {
    Outline outline;
    read_corners(tokens, [&] {
        outline.corners.push_back(tokens.three("corner of a polygon: x y z"));
        outline.normals.push_back(tokens.three("normal at a corner of a patch: x y z"));
    });
    return outline;
}

std::int64_t most_to_come(const Tokens& tokens, std::int64_t shortest) {
    return static_cast<std::int64_t>(tokens.remaining()) / shortest + 1;
}

float at_least_zero(Tokens& tokens, std::string_view use) {
    const float value = tokens.number(use);
    if (value < 0) tokens.refuse("a negative number where none may stand: " + std::string(use));
    return value;
}

}  // namespace rayshoot

#include "data/nff.h"

#include "data/emitters.h"
#include "data/nff_reader.h"

#include <algorithm>

namespace rayshoot {

Scene NffReader::read(Precision precision) && {
    for (std::string_view word = tokens_.next(); !word.empty(); word = tokens_.next()) entity(word);
    if (!has_view_)
        tokens_.refuse(
            "there is no view in this file; NFF wants one: v from x y z at x y z "
            "up x y z angle degrees hither distance resolution x y");
    finish_lights();
    scene_.geometry = std::move(builder_).build(precision);
    finish_extension();
    return std::move(scene_);
}

void NffReader::entity(std::string_view keyword) {
    if (keyword == "v") return view();
    if (keyword == "b") return background();
    if (keyword == "l") return light();
    if (keyword == "f") return surface();
    if (keyword == "s") return sphere();
    if (keyword == "c") return cone();
    if (keyword == "p") return polygon(Corners::plain);
    if (keyword == "pp") return polygon(Corners::with_normals);
    if (extension(keyword)) return;
    if (parse_number(keyword))
        tokens_.refuse("a number too many: " + quoted(keyword) +
                       " stands where an entity begins; check the counts above it");
    tokens_.refuse("unknown entity " + quoted(keyword) +
                   "; NFF has v, b, l, f, s, c, p, pp and # for comments, our extension light, "
                   "surface, move, turn, rest, vmove, vturn, shutter and lens");
}

void NffReader::background() { scene_.background = three("background: b red green blue"); }

void NffReader::view() {
    if (has_view_) tokens_.refuse("a second view; keep one per file");
    has_view_ = true;
    constexpr std::array<std::string_view, 6> fields{"from",  "at",     "up",
                                                     "angle", "hither", "resolution"};
    std::vector<std::string_view> given;
    while (given.size() < fields.size()) {
        const std::string_view field = tokens_.next();
        if (std::ranges::find(fields, field) == fields.end() ||
            std::ranges::find(given, field) != given.end())
            tokens_.refuse(quoted(field) +
                           " in a view, which has from, at, up, angle, hither and resolution, "
                           "each once");
        given.push_back(field);
        view_field(field);
    }
    const Camera& camera = scene_.camera;
    const dvec3 gaze = dvec3(camera.at) - dvec3(camera.from);
    if (taxicab(cross(gaze, dvec3(camera.up))) == 0)
        tokens_.refuse("the view has no direction: from equals at, or up is along the gaze");
}

void NffReader::view_field(std::string_view field) {
    Camera& camera = scene_.camera;
    if (field == "from") camera.from = three("from x y z");
    if (field == "at") camera.at = three("at x y z");
    if (field == "up") camera.up = three("up x y z");
    if (field == "angle") {
        camera.angle = tokens_.number("angle, in degrees");
        if (!(camera.angle > 0 && camera.angle < 180))
            tokens_.refuse("the angle must be between 0 and 180 degrees");
    }
    if (field == "hither") camera.hither = at_least_zero("hither, a distance");
    if (field == "resolution") {
        constexpr int largest = 1 << 16;  // pixels a side
        camera.width = static_cast<int>(tokens_.integer("resolution in x", 1, largest));
        camera.height = static_cast<int>(tokens_.integer("resolution in y", 1, largest));
    }
}

void NffReader::light() {
    Light light;
    light.position = three("light: l x y z [red green blue]");
    light.samples.include(light.position);
    if (parse_number(tokens_.peek())) light.intensity = three("colour of a light: red green blue");
    else uncoloured_.push_back(scene_.lights.size());
    scene_.lights.push_back(light);
}

void NffReader::finish_lights() {
    for (const std::size_t i : uncoloured_)
        scene_.lights[i].intensity = vec3(nff_light_intensity(scene_.lights.size()));
}

void NffReader::surface() {
    constexpr std::string_view use = "surface: f red green blue Kd Ks shine T index_of_refraction";
    Material material;
    material.colour = three(use);
    material.diffuse = at_least_zero(use);
    material.specular = at_least_zero(use);
    material.shininess = at_least_zero(use);
    material.transmittance = at_least_zero(use);
    material.refraction_index = at_least_zero(use);
    paint_with(material);
}

/// NFF marks what is seen from the inside only by negative radii; here everything is two-sided.
void NffReader::sphere() {
    Sphere sphere;
    sphere.centre = three("sphere: s x y z radius");
    sphere.radius = std::abs(tokens_.number("sphere: s x y z radius"));
    add([&] { builder_.add_sphere(sphere, motion()); });
}

void NffReader::cone() {
    constexpr std::string_view use = "cone: c base x y z radius apex x y z radius";
    Frustum frustum;
    frustum.base = three(use);
    frustum.base_radius = tokens_.number(use);
    frustum.apex = three(use);
    frustum.apex_radius = tokens_.number(use);
    if (std::min(frustum.base_radius, frustum.apex_radius) < 0 &&
        std::max(frustum.base_radius, frustum.apex_radius) > 0)
        tokens_.refuse("one radius of this cone is negative; both may be, or none");
    frustum.base_radius = std::abs(frustum.base_radius);
    frustum.apex_radius = std::abs(frustum.apex_radius);
    if (emitting()) tokens_.refuse("a cone cannot emit light; make it of triangles");
    add([&] { builder_.add_frustum(frustum, motion()); });
}

void NffReader::polygon(Corners kind) {
    constexpr std::int64_t shortest_corner = 6;  // characters: "0 0 0 "
    const auto most = static_cast<std::int64_t>(tokens_.remaining()) / shortest_corner + 1;
    const std::int64_t count = tokens_.integer(
        "number of a polygon's corners, which all must follow", 3, std::max<std::int64_t>(3, most));
    std::vector<vec3> corners, normals;
    for (std::int64_t i = 0; i < count; ++i) {
        corners.push_back(three("corner of a polygon: x y z"));
        if (kind == Corners::with_normals)
            normals.push_back(three("normal at a corner of a patch: x y z"));
    }
    if (emitting() && count > 3 && !is_rectangle(corners))
        tokens_.refuse("a polygon that emits light must be a rectangle; cut it into triangles");
    add([&] { builder_.add_polygon(corners, normals, motion()); });
}

float NffReader::at_least_zero(std::string_view use) {
    const float value = tokens_.number(use);
    if (value < 0) tokens_.refuse("a negative number where none may stand: " + std::string(use));
    return value;
}

Scene read_nff(std::string_view text, const std::string& name, Precision precision,
               const Frame& frame) {
    return NffReader(text, name, frame).read(precision);
}

}  // namespace rayshoot

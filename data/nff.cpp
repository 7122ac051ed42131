#include "data/nff.h"

#include "data/emitters.h"
#include "data/nff_reader.h"
#include "data/nff_shapes.h"

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
    if (keyword == "f") return paint_with(read_fill(tokens_));
    if (keyword == "s") return sphere();
    if (keyword == "c") return cone();
    if (keyword == "p") return polygon(read_polygon(tokens_));
    if (keyword == "pp") return polygon(read_patch(tokens_));
    if (extension(keyword)) return;
    if (parse_number(keyword))
        tokens_.refuse("a number too many: " + quoted(keyword) +
                       " stands where an entity begins; check the counts above it");
    tokens_.refuse("unknown entity " + quoted(keyword) +
                   "; NFF has v, b, l, f, s, c, p, pp and # for comments, our extension light, "
                   "surface, move, turn, rest, vmove, vturn, shutter and lens");
}

void NffReader::background() { scene_.background = tokens_.three("background: b red green blue"); }

void NffReader::view() {
    if (has_view_) tokens_.refuse("a second view; keep one per file");
    has_view_ = true;
    read_view(tokens_, scene_.camera);
}

void NffReader::light() {
    Light light;
    light.position = tokens_.three("light: l x y z [red green blue]");
    light.samples.include(light.position);
    if (parse_number(tokens_.peek()))
        light.intensity = tokens_.three("colour of a light: red green blue");
    else uncoloured_.push_back(scene_.lights.size());
    scene_.lights.push_back(light);
}

void NffReader::finish_lights() {
    for (const std::size_t i : uncoloured_)
        scene_.lights[i].intensity = vec3(nff_light_intensity(scene_.lights.size()));
}

void NffReader::sphere() {
    const Sphere sphere = read_sphere(tokens_);
    add([&] { builder_.add_sphere(sphere, motion()); });
}

void NffReader::cone() {
    const Frustum frustum = read_cone(tokens_);
    if (emitting()) tokens_.refuse("a cone cannot emit light; make it of triangles");
    add([&] { builder_.add_frustum(frustum, motion()); });
}

void NffReader::polygon(const Outline& outline) {
    if (emitting() && outline.corners.size() > 3 && !is_rectangle(outline.corners))
        tokens_.refuse("a polygon that emits light must be a rectangle; cut it into triangles");
    add([&] { builder_.add_polygon(outline.corners, outline.normals, motion()); });
}

Scene read_nff(std::string_view text, const std::string& name, Precision precision,
               const Frame& frame) {
    return NffReader(text, name, frame).read(precision);
}

}  // namespace rayshoot

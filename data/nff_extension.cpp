#include "data/emitters.h"
#include "data/fields.h"
#include "data/nff_light.h"
#include "data/nff_reader.h"
#include "data/nff_surface.h"

#include <array>

namespace rayshoot {

bool NffReader::extension(std::string_view keyword) {
    if (keyword == "light") physical_light();
    else if (keyword == "surface") paint_with(read_surface(tokens_));
    else if (keyword == "lens") lens();
    else if (keyword == "shutter") shutter();
    else if (keyword == "vmove") camera_.read_shift(tokens_);
    else if (keyword == "vturn") camera_.read_turn(tokens_);
    else if (keyword == "rest") rest();
    else if (keyword == "move" || keyword == "turn") {
        keyword == "move" ? objects_.read_shift(tokens_) : objects_.read_turn(tokens_);
        motion_ = no_motion;
    } else return false;
    return true;
}

void NffReader::paint_with(const Material& material) {
    surface_ = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.push_back(material);
}

bool NffReader::emitting() const {
    return !scene_.materials.empty() && scene_.materials[surface_].emission != vec3(0);
}

void NffReader::physical_light() {
    const NffLight given = read_light(tokens_);
    scene_.lights.push_back(given.light);
    if (given.visible) show(given.light);
}

/// As a surface that reflects nothing.
void NffReader::show(const Light& light) {
    if (scene_.materials.empty()) scene_.materials.emplace_back();  // the surface of no `f`
    const std::uint32_t around = surface_;
    Material lamp;
    lamp.model = SurfaceModel::lambert;
    lamp.diffuse = 0;
    lamp.emission = light.intensity;
    paint_with(lamp);
    visible_.emplace_back(scene_.lights.size() - 1, builder_.size());
    add([&] {
        if (light.kind == LightKind::sphere) {
            builder_.add_sphere({light.position, light.radius}, motion());
            return;
        }
        const vec3 &corner = light.position, &u = light.edge_u, &v = light.edge_v;
        const std::array<vec3, 4> corners{corner, corner + u, corner + u + v, corner + v};
        builder_.add_polygon(corners, {}, motion());
    });
    surface_ = around;
}

void NffReader::lens() {
    constexpr std::array<std::string_view, 5> fields{"focal", "stop", "focus", "blades", "angle"};
    if (scene_.camera.lens) tokens_.refuse("a second lens; keep one per file");
    Lens lens;
    Fields given(tokens_, "lens", fields);
    for (std::string_view field = given.next(); !field.empty(); field = given.next()) {
        if (field == "focal") lens.focal_length = tokens_.number("focal length, scene units");
        if (field == "stop") lens.f_stop = tokens_.number("f-stop: focal length / diameter");
        if (field == "focus") lens.focus_distance = tokens_.number("distance in focus");
        if (field == "blades")
            lens.blades = static_cast<int>(tokens_.integer("blades of the aperture", 3, 64));
        if (field == "angle") lens.blade_angle = tokens_.number("angle of a corner, degrees");
    }
    given.require({"focal", "stop", "focus"});
    if (!(lens.focal_length > 0 && lens.f_stop > 0 && lens.focus_distance > lens.focal_length))
        tokens_.refuse(
            "a lens needs a focal length and a stop of more than 0 and a focus beyond "
            "the focal length");
    scene_.camera.lens = lens;
}

void NffReader::shutter() {
    constexpr std::string_view use = "shutter open close: shares of a frame's time";
    if (exposed_) tokens_.refuse("the shutter must be set before the first thing that moves");
    of_frame_.open = tokens_.number(use);
    of_frame_.close = tokens_.number(use);
    if (!(0 <= of_frame_.open && of_frame_.open <= of_frame_.close && of_frame_.close <= 1))
        tokens_.refuse("a shutter opens and closes in this order, from 0 to 1");
}

void NffReader::rest() {
    objects_ = {};
    motion_ = no_motion;
}

Exposure NffReader::exposure() {
    exposed_ = true;
    const double close = frame_.shutter ? of_frame_.open + *frame_.shutter : of_frame_.close;
    return {(frame_.number + of_frame_.open) / frames_, (frame_.number + close) / frames_};
}

std::uint32_t NffReader::motion() {
    if (objects_.moves() && motion_ == no_motion)
        motion_ = builder_.add_motion(objects_.over(exposure()));
    return motion_;
}

void NffReader::finish_extension() {
    try {
        if (camera_.moves()) scene_.camera.motion = camera_.over(exposure());
        for (const auto& [light, primitive] : visible_)
            occupy(scene_.lights[light], scene_.geometry, {primitive});
        add_emitters(scene_);
    } catch (const std::invalid_argument& error) {
        tokens_.refuse(error.what());
    }
}

}  // namespace rayshoot

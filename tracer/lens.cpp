#include "tracer/lens.h"

#include "tracer/sampling/warp.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace rayshoot {

void require_valid(const Lens& lens) {
    const auto positive = [](const char* what, float value) {
        if (value > 0 && std::isfinite(value)) return;
        throw std::invalid_argument("lens: " + std::string(what) + " " + std::to_string(value) +
                                    ": must be more than 0 and finite");
    };
    positive("focal length", lens.focal_length);
    positive("f-stop", lens.f_stop);
    positive("focus distance", lens.focus_distance);
    if (!(lens.focal_length < lens.focus_distance))
        throw std::invalid_argument(
            "lens: nothing nearer than the focal length can be in focus; "
            "make the focus distance " +
            std::to_string(lens.focus_distance) + " more than " +
            std::to_string(lens.focal_length));
    if (lens.blades < 0 || lens.blades == 1 || lens.blades == 2)
        throw std::invalid_argument("lens: " + std::to_string(lens.blades) +
                                    " blades; give 0 for a round aperture, or 3 or more");
    if (!std::isfinite(lens.blade_angle))
        throw std::invalid_argument("lens: the blades' angle must be finite");
}

Lens lens_for(const Camera& camera, float f_stop) {
    constexpr float focal_share = 1.0f / 40;
    Lens lens;
    lens.focus_distance = static_cast<float>(length(dvec3(camera.at) - dvec3(camera.from)));
    lens.focal_length = focal_share * lens.focus_distance;
    lens.f_stop = f_stop;
    return lens;
}

double lens_radius(const Lens& lens) { return lens.focal_length / (2.0 * lens.f_stop); }

double image_distance(const Lens& lens) {
    return 1 / (1.0 / lens.focal_length - 1.0 / lens.focus_distance);
}

double circle_of_confusion(const Lens& lens, double depth) {
    const double magnification =
        lens.focal_length / (double{lens.focus_distance} - lens.focal_length);
    return 2 * lens_radius(lens) * std::abs(depth - lens.focus_distance) / depth * magnification;
}

AperturePoint on_aperture(const Lens& lens, Pair pair) {
    constexpr float degree = static_cast<float>(std::numbers::pi / 180);
    const glm::vec2 on_unit = lens.blades == 0
                                  ? concentric_disc(pair)
                                  : regular_polygon(pair, lens.blades, lens.blade_angle * degree);
    const double radius = lens_radius(lens);
    return {radius * on_unit.x, radius * on_unit.y};
}

}  // namespace rayshoot

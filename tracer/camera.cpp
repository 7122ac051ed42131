#include "tracer/camera.h"

#include "accel/core/primitive/rounding.h"
#include "tracer/lens.h"
#include "tracer/sampling/warp.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace rayshoot {
namespace {

struct Frame {
    dvec3 right, up, forward;  ///< orthonormal, right-handed: forward = up x right
};

Frame frame_of(const Camera& camera) {
    const dvec3 axis = dvec3(camera.at) - dvec3(camera.from);
    if (!(length(axis) > 0)) {
        throw std::invalid_argument("camera: `from` and `at` are the same point; move one of them");
    }
    const dvec3 forward = normalised(axis);
    const dvec3 side = cross(forward, dvec3(camera.up));
    // sin of the angle between the axis and up; below it the rounding of the input decides.
    if (!(length(side) > 1e-6 * length(dvec3(camera.up)))) {
        throw std::invalid_argument(
            "camera: `up` is zero or parallel to the viewing axis; give another one");
    }
    const dvec3 right = normalised(side);
    return {right, cross(right, forward), forward};
}

void require_border(const ImageFormat& format, int border) {
    const int room = largest_image - std::max(format.width, format.height);
    if (border >= 0 && border <= room) return;
    throw std::invalid_argument("image border " + std::to_string(border) + ": must be from 0 to " +
                                std::to_string(room));
}

}  // namespace

void require_valid(const ImageFormat& format) {
    const auto check = [](const char* what, int value, int largest) {
        if (value >= 1 && value <= largest) return;
        throw std::invalid_argument(std::string(what) + " " + std::to_string(value) +
                                    ": must be from 1 to " + std::to_string(largest));
    };
    check("image width", format.width, largest_image);
    check("image height", format.height, largest_image);
    check("samples per pixel", format.spp, largest_spp);
}

View make_view(const Camera& camera, const ImageFormat& format, int border) {
    return CameraRays(camera, format, border).view();
}

BuildInput build_input(const Scene& scene, const ImageFormat& format, int border) {
    return {scene.geometry, make_view(scene.camera, format, border), scene.lights,
            scene.hierarchy ? &*scene.hierarchy : nullptr};
}

CameraRays::CameraRays(const Camera& camera, const ImageFormat& format, int border)
    : format_(format), lens_(camera.lens) {
    require_valid(format);
    require_border(format, border);
    if (!(camera.angle > 0 && camera.angle < 180)) {
        throw std::invalid_argument("camera: angle " + std::to_string(camera.angle) +
                                    ": must be more than 0 and less than 180 degrees");
    }
    const Frame frame = frame_of(camera);
    const double half = std::tan(camera.angle * (std::numbers::pi / 360));
    const int spans = format.raster == Raster::centres ? format.height : format.height - 1;
    const double cell = 2 * half / (spans > 0 ? spans : 1);  // edge of a cell at distance 1
    right_ = frame.right;
    up_ = frame.up;
    across_ = frame.right * cell;
    down_ = frame.up * -cell;
    to_corner_ = frame.forward - across_ * (0.5 * format.width) - down_ * (0.5 * format.height);
    view_.eye = camera.from;
    view_.right = vec3(frame.right);
    view_.up = vec3(frame.up);
    view_.forward = vec3(frame.forward);
    view_.to_corner = vec3(to_corner_);
    view_.across = vec3(across_);
    view_.down = vec3(down_);
    view_.width = format.width;
    view_.height = format.height;
    view_.border = border;
    open_lens(camera);
}

void CameraRays::open_lens(const Camera& camera) {
    if (camera.lens) {
        require_valid(*camera.lens);
        view_.lens_radius = rounded_up(lens_radius(*camera.lens));
        view_.focus_distance = camera.lens->focus_distance;
    }
    if (camera.motion) require_rigid(*camera.motion);
    view_.motion = camera.motion;
}

dvec3 CameraRays::on_lens(Pair lens) const {
    const AperturePoint on = on_aperture(*lens_, lens);
    return on.right * right_ + on.up * up_;
}

dvec3 CameraRays::moved(dvec3 at_rest, float time) const {
    return view_.motion ? move_to_world(*view_.motion, time, at_rest) : at_rest;
}

/// The origin is rounded first and the direction then aims from there at the point in focus, so
/// that the ray keeps to its raster cell wherever the coordinates' origin is.
vec3 CameraRays::focused(vec3 origin, dvec3 direction, float time) const {
    const double distance = view_.focus_distance;
    const dvec3 in_focus = moved(dvec3(view_.eye) + distance * direction, time);
    return vec3((in_focus - dvec3(origin)) / distance);
}

Ray CameraRays::ray(Pixel pixel) const {
    const dvec3 direction = to_corner_ + across_ * (pixel.x + 0.5) + down_ * (pixel.y + 0.5);
    return placed(dvec3(0), direction, 0);
}

}  // namespace rayshoot

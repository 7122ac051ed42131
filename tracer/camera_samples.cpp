#include "tracer/camera_samples.h"

namespace rayshoot {

Shutter shutter_of(const Scene& scene, ShutterWeight weight) {
    const Camera& camera = scene.camera;
    if (!scene.geometry.has_motion() && !camera.motion) return {0, 0, weight};
    return {camera.shutter_open, camera.shutter_close, weight};
}

CameraSample CameraSamples::sample(const Sampler& sampler, Pixel pixel,
                                   std::uint32_t sample) const {
    const Pair in_cell = sampler.pair(pixel, sample, {Use::pixel});
    CameraSample result;
    result.on_film = {.pixel = pixel, .x = in_cell.u, .y = in_cell.v};
    Filter::Offset from_middle{in_cell.u - 0.5, in_cell.v - 0.5};
    if (!splats()) {
        from_middle = reconstruction_ == Reconstruction::importance ? filter_.importance(in_cell)
                                                                    : filter_.uniform(in_cell);
        result.on_film.weight = static_cast<float>(from_middle.weight);
    }
    const double x = pixel.x + 0.5 + from_middle.x, y = pixel.y + 0.5 + from_middle.y;
    const bool lens = camera_.view().lens_radius > 0, exposure = shutter_.open < shutter_.close;
    const Pair on_lens = lens ? sampler.pair(pixel, sample, {Use::lens}) : Pair{};
    const float moment = exposure ? sampler.number(pixel, sample, {Use::time}) : 0.0f;
    result.shot.ray = camera_.ray(x, y, on_lens, shutter_.time(moment));
    result.shot.source = CameraRays::source(x, y);
    result.shot.sampler = &sampler;
    result.shot.pixel = pixel;
    result.shot.sample = sample;
    return result;
}

}  // namespace rayshoot

#include "tracer/camera_samples.h"

namespace rayshoot {

Shutter shutter_of(const Scene& scene, ShutterWeight weight) {
    const Camera& camera = scene.camera;
    if (!scene.geometry.has_motion() && !camera.motion) return {0, 0, weight};
    return {camera.shutter_open, camera.shutter_close, weight};
}

void CameraSamples::sample(const Sampler& sampler, Pixel pixel, std::vector<Shot>& shots,
                           std::vector<FilmSample>& on_film) const {
    const auto count = static_cast<std::uint32_t>(sampler.settings().spp);
    for (std::uint32_t sample = 0; sample < count; ++sample) {
        Shot& shot = shots.emplace_back();
        shot.sampler = &sampler;
        shot.pixel = pixel;
        shot.sample = sample;
        expose(shot, on_film.emplace_back());
    }
}

void CameraSamples::expose(Shot& shot, FilmSample& on_film) const {
    const Pair in_cell = shot.pair({Use::pixel});
    const Filter::Offset offset = from_middle(in_cell);
    on_film.pixel = shot.pixel;
    on_film.x = in_cell.u;
    on_film.y = in_cell.v;
    on_film.weight = static_cast<float>(offset.weight);
    const double x = shot.pixel.x + 0.5 + offset.x, y = shot.pixel.y + 0.5 + offset.y;
    const bool lens = camera_.view().lens_radius > 0, exposure = shutter_.open < shutter_.close;
    const Pair on_lens = lens ? shot.pair({Use::lens}) : Pair{};
    const float time = exposure ? shutter_.time(shot.number({Use::time})) : shutter_.open;
    shot.ray = camera_.ray(x, y, on_lens, time);
    shot.source = CameraRays::source(x, y);
}

Filter::Offset CameraSamples::from_middle(Pair in_cell) const {
    if (splats()) return {in_cell.u - 0.5, in_cell.v - 0.5};
    return reconstruction_ == Reconstruction::importance ? filter_.importance(in_cell)
                                                         : filter_.uniform(in_cell);
}

}  // namespace rayshoot

#pragma once

#include "tracer/camera.h"
#include "tracer/film/film.h"
#include "tracer/filter/filter.h"
#include "tracer/integrator/integrator.h"
#include "tracer/shutter.h"

/// Where a pixel's camera rays go through raster, lens and shutter.
namespace rayshoot {

/// The scene's shutter; where nothing moves, an instant.
Shutter shutter_of(const Scene& scene, ShutterWeight weight = ShutterWeight::box);

/// A camera sample, to be traced, and what of it goes to the film.
struct CameraSample {
    Shot shot;
    FilmSample on_film;  ///< its radiance is the shot's, once that was traced
};

/// Cook, Porter & Carpenter 1984: the samples of a pixel serve the filter, the lens and the time at
/// once, each with a stratification of its own.
class CameraSamples {
public:
    CameraSamples(const CameraRays& camera, const Filter& filter, Reconstruction reconstruction,
                  const Shutter& shutter)
        : camera_(camera), filter_(filter), reconstruction_(reconstruction), shutter_(shutter) {}

    /// Whether samples are splatted: their weights are shares of their cell's, 1 / its samples.
    bool splats() const {
        return reconstruction_ == Reconstruction::splat ||
               reconstruction_ == Reconstruction::splat_undivided;
    }
    /// Sample `sample` of those that `sampler` has for `pixel`.
    CameraSample sample(const Sampler& sampler, Pixel pixel, std::uint32_t sample) const;

private:
    const CameraRays& camera_;
    const Filter& filter_;
    Reconstruction reconstruction_;
    Shutter shutter_;
};

}  // namespace rayshoot

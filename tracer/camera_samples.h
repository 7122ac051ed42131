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
    /// Appends all samples that `sampler` has for `pixel`: to be traced, and what of them goes to
    /// the film, whose radiance is the shot's once that was traced.
    void sample(const Sampler& sampler, Pixel pixel, std::vector<Shot>& shots,
                std::vector<FilmSample>& on_film) const;

private:
    /// Fills in what differs from one sample of a pixel to the next.
    void expose(Shot& shot, FilmSample& on_film) const;
    Filter::Offset from_middle(Pair in_cell) const;

    const CameraRays& camera_;
    const Filter& filter_;
    Reconstruction reconstruction_;
    Shutter shutter_;
};

}  // namespace rayshoot

#include "tracer/tile_tracer.h"

namespace rayshoot {

TileTracer::TileTracer(const CameraSamples& samples, const Sampling& sampling, Film& film,
                       const Integrator& integrator, Session& session, std::size_t lights,
                       std::size_t batch)
    : camera_samples_(samples),
      sampling_(sampling),
      film_(film),
      wavefront_(integrator, session, lights, batch) {}

void TileTracer::trace(std::size_t number, std::span<const Pixel> tile) {
    states_.assign(tile.size(), {});
    on_film_.clear();
    pixels_on_film_.clear();
    for (int round = 0; sample_round(round, tile); ++round) {
        wavefront_.trace(shots_);
        keep_round(round);
    }
    if (camera_samples_.splats()) {
        for (std::size_t i = 0; i < on_film_.size(); ++i)
            on_film_[i].weight = 1.0f / static_cast<float>(states_[pixels_on_film_[i]].taken);
    }
    film_.add(number, on_film_);
}

/// False when no pixel of the tile needs any more.
bool TileTracer::sample_round(int round, std::span<const Pixel> tile) {
    shots_.clear();
    exposed_.clear();
    pixels_.clear();
    for (std::uint32_t pixel = 0; pixel < tile.size(); ++pixel) {
        PixelState& state = states_[pixel];
        const int count = state.done ? 0 : samples_of(round, state.seen);
        state.done = count == 0;
        if (state.done) continue;
        const Sampler& numbers = sampler(count, round);
        for (int sample = 0; sample < count; ++sample) {
            const CameraSample made =
                camera_samples_.sample(numbers, tile[pixel], static_cast<std::uint32_t>(sample));
            shots_.push_back(made.shot);
            exposed_.push_back(made.on_film);
            pixels_.push_back(pixel);
        }
    }
    return !shots_.empty();
}

void TileTracer::keep_round(int round) {
    const bool keeps = !sampling_.adaptive || sampling_.adaptive->keeps(round);
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        PixelState& state = states_[pixels_[i]];
        if (sampling_.adaptive) state.seen.add(shots_[i].radiance);
        if (!keeps) continue;
        ++state.taken;
        exposed_[i].radiance = shots_[i].radiance;
        on_film_.push_back(exposed_[i]);
        pixels_on_film_.push_back(pixels_[i]);
    }
}

int TileTracer::samples_of(int round, const SampleStatistics& seen) const {
    if (sampling_.adaptive) return sampling_.adaptive->next(round, seen);
    return round == 0 ? sampling_.sampler.spp : 0;
}

/// Each round is stratified by itself, and has numbers of its own.
const Sampler& TileTracer::sampler(int count, int round) {
    const auto found = samplers_.find({count, round});
    if (found != samplers_.end()) return found->second;
    SamplerSettings settings = sampling_.sampler;
    settings.spp = count;
    settings.seed += static_cast<std::uint32_t>(round);
    return samplers_.emplace(std::pair{count, round}, Sampler(settings)).first->second;
}

}  // namespace rayshoot

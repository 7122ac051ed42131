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
    runs_.clear();
    for (int round = 0; sample_round(round, tile); ++round) {
        wavefront_.trace(shots_);
        end_round(round);
    }
    if (camera_samples_.splats()) share_cells();
    film_.add(number, on_film_);
}

/// False when no pixel of the tile needs any more.
bool TileTracer::sample_round(int round, std::span<const Pixel> tile) {
    shots_.clear();
    runs_before_ = runs_.size();
    for (std::uint32_t pixel = 0; pixel < tile.size(); ++pixel) {
        PixelState& state = states_[pixel];
        const int count = state.done ? 0 : samples_of(round, state.seen);
        state.done = count == 0;
        if (state.done) continue;
        camera_samples_.sample(sampler(count, round), tile[pixel], shots_, on_film_);
        runs_.push_back({pixel, static_cast<std::uint32_t>(count)});
    }
    return !shots_.empty();
}

void TileTracer::end_round(int round) {
    const std::size_t before = on_film_.size() - shots_.size();
    for (std::size_t i = 0; i < shots_.size(); ++i)
        on_film_[before + i].radiance = shots_[i].radiance;
    if (!sampling_.adaptive) return;
    auto shot = shots_.begin();
    for (const Run& run : std::span(runs_).subspan(runs_before_)) {
        for (std::uint32_t i = 0; i < run.samples; ++i)
            states_[run.pixel].seen.add((shot++)->radiance);
    }
    if (sampling_.adaptive->keeps(round)) return;
    on_film_.resize(before);
    runs_.resize(runs_before_);
}

/// Each sample is given its share of its cell.
void TileTracer::share_cells() {
    for (const Run& run : runs_) states_[run.pixel].taken += run.samples;
    auto sample = on_film_.begin();
    for (const Run& run : runs_) {
        const float share = 1.0f / static_cast<float>(states_[run.pixel].taken);
        for (std::uint32_t i = 0; i < run.samples; ++i) (sample++)->weight = share;
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

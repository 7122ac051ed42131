#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tracer/camera_samples.h"
#include "tracer/film/adaptive.h"
#include "tracer/wavefront.h"

namespace rayshoot {

/// How many samples the pixels of an image take, and of which sampler.
struct Sampling {
    SamplerSettings sampler;  ///< spp: of every pixel, where it is not adaptive
    std::optional<AdaptiveSampling> adaptive;
};

/// One lane's work on a tile: samples its pixels, in as many rounds as they need, and hands what
/// came back to the film.
class TileTracer {
public:
    TileTracer(const CameraSamples& samples, const Sampling& sampling, Film& film,
               const Integrator& integrator, Session& session, std::size_t lights,
               std::size_t batch);

    void trace(std::size_t number, std::span<const Pixel> tile);
    const RayCounts& counts() const { return wavefront_.counts(); }
    std::chrono::nanoseconds answering() const { return wavefront_.answering(); }

private:
    struct PixelState {
        SampleStatistics seen;
        std::uint32_t taken = 0;  ///< samples that went to the film, when splatting
        bool done = false;        ///< the stopping rule has said so, and is not asked again
    };
    /// Samples of a round that follow each other.
    struct Run {
        std::uint32_t pixel;  ///< whose they are, in the tile
        std::uint32_t samples;
    };
    const Sampler& sampler(int count, int round);
    int samples_of(int round, const SampleStatistics& seen) const;
    bool sample_round(int round, std::span<const Pixel> tile);
    void end_round(int round);
    void share_cells();

    const CameraSamples& camera_samples_;
    const Sampling& sampling_;
    Film& film_;
    Wavefront wavefront_;
    std::map<std::pair<int, int>, Sampler> samplers_;  ///< by number of samples and round
    std::vector<PixelState> states_;                   ///< of the tile's pixels
    std::vector<Shot> shots_;                          ///< of the round
    std::vector<FilmSample> on_film_;                  ///< of the rounds that are kept
    std::vector<Run> runs_;                            ///< whose those are
    std::size_t runs_before_ = 0;                      ///< of the rounds before this one
};

}  // namespace rayshoot

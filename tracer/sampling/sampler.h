#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "tracer/sampling/dimension.h"
#include "tracer/sampling/pair.h"
#include "tracer/sampling/permutations.h"
#include "tracer/sampling/pixel_ranks.h"
#include "tracer/sampling/strata.h"
#include "tracer/sampling/sub_frames.h"
#include "tracer/sampling/truncated_gaussian.h"

/// The random numbers of camera samples. All are pure functions of (seed, pixel, sample,
/// dimension), made by integer arithmetic: alike on every machine, for any number of threads, any
/// order of tiles and any size of image. README.md says how each kind works.
namespace rayshoot {

struct Pixel;  // tracer/camera.h

enum class SamplerKind : std::uint8_t {
    random,    ///< independent numbers
    regular,   ///< centres of the pixel's strata; other dimensions as jitter
    jitter,    ///< one number, uniform, in each stratum
    gaussian,  ///< truncated Gaussian in the pixel's strata; other dimensions as jitter
    sobol,     ///< Sobol' points, Owen-scrambled; stratified best if spp is a power of two
};

/// Throws std::invalid_argument, listing the names, for one that is none of them.
SamplerKind sampler_kind(std::string_view name);
std::string_view name(SamplerKind kind);

struct SamplerSettings {
    SamplerKind kind = SamplerKind::jitter;
    int spp = 1;              ///< samples per pixel, 1 to largest_spp (tracer/camera.h)
    bool blue_noise = false;  ///< of sobol: neighbouring pixels' errors differ, so noise is fine
    bool cook_time = false;   ///< times follow a prototype, least correlated with the strata
    std::uint32_t seed = 0;
    bool operator==(const SamplerSettings&) const = default;
};

class Sampler {
public:
    /// Throws std::invalid_argument, saying what is accepted, for an spp out of range, blue_noise
    /// of another kind than sobol, and cook_time of a kind without strata of the pixel.
    explicit Sampler(const SamplerSettings& settings);

    /// `sample` is less than spp. Over the samples of a pixel the pairs of a dimension are
    /// stratified as the kind says; both are multiples of 2^-24. Where the pixel has strata they
    /// are in rows, and for Use::pixel sample s is in stratum s. With one sample regular and
    /// jitter give (0.5, 0.5) there: one point per pixel, the image without antialiasing.
    Pair pair(Pixel pixel, std::uint32_t sample, Dimension dimension) const;

    /// Likewise, one number to each of spp strata of [0, 1).
    float number(Pixel pixel, std::uint32_t sample, Dimension dimension) const;

    const SamplerSettings& settings() const { return settings_; }
    /// The pixel's strata of regular, jitter and gaussian: the most nearly square factors of spp.
    int strata_across() const { return static_cast<int>(columns_.count()); }
    int strata_down() const { return static_cast<int>(rows_.count()); }

private:
    std::uint64_t key(Pixel pixel, Dimension dimension) const;
    Pair of_pixel(std::uint32_t sample, std::uint64_t key) const;
    Pair in_cell(std::uint32_t stratum, std::uint64_t bits) const;
    std::uint32_t sobol_index(Pixel pixel, std::uint32_t sample) const;

    SamplerSettings settings_;
    std::uint64_t seed_;                         ///< hashed
    Strata rows_, columns_, line_;               ///< of a pair; of a number
    Permutations permutations_;                  ///< of samples
    int sample_bits_;                            ///< of the largest sample's number
    std::optional<TruncatedGaussian> gaussian_;  ///< of kind gaussian
    std::optional<PixelRanks> ranks_;            ///< of blue_noise
    std::optional<SubFrames> sub_frames_;        ///< of cook_time
};

}  // namespace rayshoot

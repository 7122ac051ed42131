#include "tracer/sampling/sampler.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <stdexcept>
#include <string>

#include "tracer/camera.h"
#include "tracer/random.h"
#include "tracer/sampling/number.h"
#include "tracer/sampling/sobol.h"

namespace rayshoot {
namespace {

/// By SamplerKind.
constexpr std::array<std::string_view, 5> names{"random", "regular", "jitter", "gaussian", "sobol"};

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;   // 2^64 / golden ratio, odd
constexpr std::uint64_t middle = 0x80000000'80000000u;  // of both numbers

/// 64 random bits, 32 for each number of a pair.
constexpr std::uint64_t random_bits(std::uint64_t key, std::uint32_t sample) {
    return scrambled(key + (sample + std::uint64_t{1}) * golden);
}
constexpr std::uint32_t high(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }
constexpr std::uint32_t low(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }

constexpr bool has_pixel_strata(SamplerKind kind) {
    return kind != SamplerKind::random && kind != SamplerKind::sobol;
}

void require_valid(const SamplerSettings& settings) {
    if (settings.spp < 1 || settings.spp > largest_spp) {
        throw std::invalid_argument("samples per pixel " + std::to_string(settings.spp) +
                                    ": must be from 1 to " + std::to_string(largest_spp));
    }
    const std::string kind(name(settings.kind));
    if (settings.blue_noise && settings.kind != SamplerKind::sobol) {
        throw std::invalid_argument(
            "sampler " + kind + ": blue noise orders a sequence over pixels, so it needs sobol");
    }
    if (settings.cook_time && !has_pixel_strata(settings.kind)) {
        throw std::invalid_argument("sampler " + kind +
                                    ": Cook's times belong to strata of the pixel, so they need "
                                    "regular, jitter or gaussian");
    }
}

/// A word for each cell of the raster.
constexpr std::uint32_t packed(int x, int y) {
    return std::uint32_t{static_cast<std::uint16_t>(y)} << 16 | static_cast<std::uint16_t>(x);
}

/// Of the first dimension of a scrambled and shuffled Sobol sequence.
float first_number(std::uint32_t index, std::uint32_t seed) {
    return unit_number(reversed_bits(owen_scrambled(index, seed)));
}
float second_number(std::uint32_t index, std::uint32_t seed) {
    return unit_number(reversed_bits(owen_scrambled(sobol_second(index), seed)));
}

}  // namespace

SamplerKind sampler_kind(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return static_cast<SamplerKind>(found - names.begin());
    std::string known;
    for (const std::string_view one : names) known += " " + std::string(one);
    throw std::invalid_argument("sampler `" + std::string(name) + "` is not known; there are" +
                                known);
}

std::string_view name(SamplerKind kind) { return names[static_cast<std::size_t>(kind)]; }

Sampler::Sampler(const SamplerSettings& settings)
    : settings_((require_valid(settings), settings)),
      seed_(scrambled(settings.seed + golden)),
      rows_(smaller_factor(static_cast<std::uint32_t>(settings.spp))),
      columns_(static_cast<std::uint32_t>(settings.spp) / rows_.count()),
      line_(static_cast<std::uint32_t>(settings.spp)),
      permutations_(line_.count(), seed_),
      sample_bits_(std::bit_width(line_.count() - 1)) {
    if (settings.kind == SamplerKind::gaussian) gaussian_.emplace();
    if (settings.blue_noise) ranks_.emplace(seed_);
    if (settings.cook_time) sub_frames_.emplace(strata_across(), strata_down(), seed_);
}

/// 64 random bits for the samples of a dimension of a pixel. With blue noise of a whole tile.
std::uint64_t Sampler::key(Pixel pixel, Dimension dimension) const {
    assert(dimension.place < Dimension::place_limit);
    const int shift = settings_.blue_noise ? PixelRanks::levels : 0;
    const std::uint64_t cell = packed(pixel.x >> shift, pixel.y >> shift);
    const std::uint32_t use = static_cast<std::uint32_t>(dimension.use);
    return scrambled(seed_ ^ (cell << 32 | dimension.place * uses | use));
}

Pair Sampler::pair(Pixel pixel, std::uint32_t sample, Dimension dimension) const {
    assert(sample < line_.count());
    const std::uint64_t key = this->key(pixel, dimension);
    if (settings_.kind == SamplerKind::random) {
        const std::uint64_t bits = random_bits(key, sample);
        return {unit_number(high(bits)), unit_number(low(bits))};
    }
    if (settings_.kind == SamplerKind::sobol) {
        const std::uint32_t index = shuffled(sobol_index(pixel, sample), low(key));
        const std::uint64_t seeds = random_bits(key, 0);
        return {first_number(index, high(seeds)), second_number(index, low(seeds))};
    }
    if (dimension.use == Use::pixel) return of_pixel(sample, key);
    return in_cell(permutations_(sample, key), random_bits(key, sample));
}

float Sampler::number(Pixel pixel, std::uint32_t sample, Dimension dimension) const {
    assert(sample < line_.count());
    const std::uint64_t key = this->key(pixel, dimension);
    const std::uint64_t bits = random_bits(key, sample);
    if (settings_.kind == SamplerKind::random) return unit_number(high(bits));
    if (settings_.kind == SamplerKind::sobol) {
        const std::uint32_t index = shuffled(sobol_index(pixel, sample), low(key));
        return first_number(index, high(random_bits(key, 0)));
    }
    const std::uint32_t stratum = sub_frames_ && dimension.use == Use::time
                                      ? sub_frames_->of(sample, key)
                                      : permutations_(sample, key);
    return line_.point(stratum, high(bits));
}

Pair Sampler::of_pixel(std::uint32_t sample, std::uint64_t key) const {
    const std::uint64_t bits = random_bits(key, sample);
    if (settings_.kind == SamplerKind::gaussian) {
        const std::uint64_t bell = (*gaussian_)(high(bits));
        return in_cell(sample, bell << 32 | (*gaussian_)(low(bits)));
    }
    const bool centred = settings_.kind == SamplerKind::regular || line_.count() == 1;
    return in_cell(sample, centred ? middle : bits);
}

/// In the stratum of the square, counted by row, by `bits` uniform in it.
Pair Sampler::in_cell(std::uint32_t stratum, std::uint64_t bits) const {
    const std::uint32_t row = columns_.quotient(stratum);
    return {columns_.point(stratum - row * columns_.count(), high(bits)),
            rows_.point(row, low(bits))};
}

/// Of a sample in the sequence of its pixel, or with blue noise of the pixel's tile.
std::uint32_t Sampler::sobol_index(Pixel pixel, std::uint32_t sample) const {
    return ranks_ ? (*ranks_)(pixel.x, pixel.y) << sample_bits_ | sample : sample;
}

}  // namespace rayshoot

#include "tracer/film/film.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

#include "tracer/film/patch.h"

namespace rayshoot {
namespace {

bool splats(Reconstruction way) {
    return way == Reconstruction::splat || way == Reconstruction::splat_undivided;
}

/// A little more than half the diagonal of a pixel: a smaller disc may lie between all middles.
constexpr double smallest_splat = 0.75;

void require_valid(int width, int height, const Filter& filter, Reconstruction way) {
    for (const int size : {width, height}) {
        if (size < 1 || size > largest_image) {
            throw std::invalid_argument("film of " + std::to_string(width) + " x " +
                                        std::to_string(height) + ": both must be from 1 to " +
                                        std::to_string(largest_image));
        }
    }
    if (splats(way) && !filter.separable() && filter.reach() < smallest_splat) {
        throw std::invalid_argument(
            "splats of radius " + std::to_string(filter.reach()) +
            " may fall between all pixels: take a radius of 0.75 or more, or " +
            "reconstruction=importance");
    }
}

vec3 light(const Sum& sum) { return {sum.of[0], sum.of[1], sum.of[2]}; }

/// Float by float, in the order of samples: so that the mean of a box filter is what adding up in
/// the image and multiplying by 1 / samples gives, bit for bit.
void add_rounded(Sum& sum, std::span<const FilmSample> samples) {
    vec3 rounded = light(sum);
    for (const FilmSample& sample : samples) rounded += sample.radiance * sample.weight;
    sum.of = {rounded.x, rounded.y, rounded.z, sum.of[3] + static_cast<double>(samples.size())};
}

void add_exact(Sum& sum, std::span<const FilmSample> samples) {
    for (const auto& [pixel, x, y, radiance, weight] : samples)
        sum.add({radiance.x, radiance.y, radiance.z, 1}, weight);
}

/// The samples from the first on that are of its pixel.
std::span<const FilmSample> first_run(std::span<const FilmSample> samples) {
    const auto end = std::ranges::find_if_not(
        samples, [&](const FilmSample& sample) { return sample.pixel == samples.front().pixel; });
    return samples.first(static_cast<std::size_t>(end - samples.begin()));
}

vec3 mean(const Sum& sum) {
    if (sum.of[3] == 0) return vec3(0);
    return light(sum) * (1 / static_cast<float>(sum.of[3]));
}

/// With negative lobes weights may cancel where there are few samples; there the sum of weights,
/// which is 1 (splat) or the number of samples (weighted) on average, is taken to be
/// `least_weight`.
vec3 quotient(const Sum& sum, double least_weight) {
    const double weight = std::max(sum.of[3], least_weight);
    if (weight == 0) return vec3(0);
    return {sum.of[0] / weight, sum.of[1] / weight, sum.of[2] / weight};
}

}  // namespace

Reconstruction reconstruction(std::string_view name) {
    const auto found = std::ranges::find(reconstruction_names, name);
    if (found != reconstruction_names.end()) {
        return static_cast<Reconstruction>(found - reconstruction_names.begin());
    }
    std::string all;
    for (const std::string_view known : reconstruction_names) all += " " + std::string(known);
    throw std::invalid_argument("reconstruction '" + std::string(name) + "': must be one of" + all);
}

std::string_view name(Reconstruction way) {
    return reconstruction_names[static_cast<std::size_t>(way)];
}

/// All that lanes share, and its lock.
class Film::Sums {
public:
    Sums(int width, int height, const Filter& filter, Reconstruction way)
        : footprint_(filter),
          way_(way),
          least_weight_(filter.negative_lobes() ? 0.5 : 0),
          pixels_({0, 0, width, height}) {}

    const SplatFootprint& footprint() const { return footprint_; }
    bool splats() const { return rayshoot::splats(way_); }
    std::size_t waiting() {
        const std::lock_guard lock(mutex_);
        return waiting_.size();
    }
    void add(std::size_t tile, std::span<const FilmSample> samples) {
        splats() ? add_footprints(tile, samples) : add_own(samples);
    }
    Image image();

private:
    void add_own(std::span<const FilmSample> samples);
    void add_footprints(std::size_t tile, std::span<const FilmSample> samples);
    void merge(const std::vector<Patch>& patches) {
        for (const Patch& patch : patches) pixels_.add(patch);
    }
    vec3 value(const Sum& sum) const;

    const SplatFootprint footprint_;
    const Reconstruction way_;
    const double least_weight_;
    std::mutex mutex_;
    Patch pixels_;                                       ///< the tiles before next_
    std::map<std::size_t, std::vector<Patch>> waiting_;  ///< those after it
    std::size_t next_ = 0;
};

void Film::Sums::add_own(std::span<const FilmSample> samples) {
    const std::lock_guard lock(mutex_);
    while (!samples.empty()) {
        const auto run = first_run(samples);
        samples = samples.subspan(run.size());
        Sum* sum = pixels_.find(run.front().pixel.x, run.front().pixel.y);
        if (sum == nullptr) continue;
        if (way_ == Reconstruction::importance) {
            add_rounded(*sum, run);
        } else {
            add_exact(*sum, run);
        }
    }
}

void Film::Sums::add_footprints(std::size_t tile, std::span<const FilmSample> samples) {
    std::vector<Patch> patches = splat(samples, footprint_, pixels_.pixels());
    const std::lock_guard lock(mutex_);
    assert(tile >= next_ && !waiting_.contains(tile));
    if (tile != next_) {
        waiting_.emplace(tile, std::move(patches));
        return;
    }
    merge(patches);
    ++next_;
    for (; !waiting_.empty() && waiting_.begin()->first == next_; ++next_) {
        merge(waiting_.begin()->second);
        waiting_.erase(waiting_.begin());
    }
}

vec3 Film::Sums::value(const Sum& sum) const {
    switch (way_) {
        case Reconstruction::importance:
            return mean(sum);
        case Reconstruction::splat_undivided:
            return light(sum);
        default:
            return quotient(sum, least_weight_);
    }
}

Image Film::Sums::image() {
    std::unique_lock lock(mutex_);
    Patch pixels = pixels_;
    for (const auto& [tile, patches] : waiting_) {
        for (const Patch& patch : patches) pixels.add(patch);
    }
    lock.unlock();
    const Rectangle& all = pixels.pixels();
    Image image(all.right, all.bottom);
    for (int y = 0; y < all.bottom; ++y) {
        const Sum* sums = pixels.row(0, y);
        for (int x = 0; x < all.right; ++x) image.at(x, y) = value(sums[x]);
    }
    return image;
}

Film::Film(int width, int height, const Filter& filter, Reconstruction way) {
    require_valid(width, height, filter, way);
    sums_ = std::make_unique<Sums>(width, height, filter, way);
}
Film::~Film() = default;
Film::Film(Film&&) noexcept = default;
Film& Film::operator=(Film&&) noexcept = default;

int Film::border() const { return sums_->footprint().border(); }

int Film::traced_border() const { return sums_->splats() ? border() : 0; }

void Film::add(std::size_t tile, std::span<const FilmSample> samples) { sums_->add(tile, samples); }

Image Film::image() const { return sums_->image(); }

std::size_t Film::waiting() const { return sums_->waiting(); }

}  // namespace rayshoot

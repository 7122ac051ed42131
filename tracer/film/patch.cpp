#include "tracer/film/patch.h"

#include <algorithm>

namespace rayshoot {
namespace {

/// Samples next to each other in a tile share a patch if they are in the same block of cells. Of
/// the blocks that a Morton curve goes through, this is what one batch of one sample a cell fills.
constexpr int block_bits = 5;

bool same_block(Pixel a, Pixel b) {
    return a.x >> block_bits == b.x >> block_bits && a.y >> block_bits == b.y >> block_bits;
}

/// The samples from the first on that share a patch.
std::span<const FilmSample> first_run(std::span<const FilmSample> samples) {
    const auto end = std::ranges::find_if_not(samples, [&](const FilmSample& sample) {
        return same_block(sample.pixel, samples.front().pixel);
    });
    return samples.first(static_cast<std::size_t>(end - samples.begin()));
}

Rectangle cells_of(std::span<const FilmSample> samples) {
    const Pixel first = samples.front().pixel;
    Rectangle cells{first.x, first.y, first.x + 1, first.y + 1};
    for (const FilmSample& sample : samples) {
        cells.left = std::min(cells.left, int{sample.pixel.x});
        cells.top = std::min(cells.top, int{sample.pixel.y});
        cells.right = std::max(cells.right, sample.pixel.x + 1);
        cells.bottom = std::max(cells.bottom, sample.pixel.y + 1);
    }
    return cells;
}

/// Adds samples to a patch, one after the other.
class Splatter {
public:
    Splatter(const SplatFootprint& footprint, Patch& patch)
        : footprint_(footprint), patch_(patch), weights_(together * footprint.room()) {}

    void add(std::span<const FilmSample> samples) {
        while (!samples.empty()) {
            const auto group = samples.first(std::min(together, samples.size()));
            for (std::size_t i = 0; i < group.size(); ++i) {
                corners_[i] = footprint_.weigh(group[i].x, group[i].y, weights_of(i));
            }
            for (std::size_t i = 0; i < group.size(); ++i)
                add(group[i], corners_[i], weights_of(i));
            samples = samples.subspan(group.size());
        }
    }

private:
    /// Samples are weighed so many at a time: a processor works at several of them at once, while
    /// it would wait for the weights of each that it adds.
    static constexpr std::size_t together = 16;

    std::span<float> weights_of(std::size_t i) {
        return std::span(weights_).subspan(i * footprint_.room(), footprint_.room());
    }
    void add(const FilmSample& sample, SplatFootprint::Corner corner,
             std::span<const float> weights) {
        const int left = sample.pixel.x + corner.left, top = sample.pixel.y + corner.top;
        const int edge = footprint_.edge();
        const Rectangle inside =
            intersection({left, top, left + edge, top + edge}, patch_.pixels());
        if (inside.empty()) return;
        const std::array<double, 4> light{sample.radiance.x, sample.radiance.y, sample.radiance.z,
                                          1};
        for (int y = inside.top; y < inside.bottom; ++y) {
            const float* weight = weights.data() + (y - top) * edge + (inside.left - left);
            Sum* sums = patch_.row(inside.left, y);
            for (int i = 0; i < inside.width(); ++i) {
                sums[i].add(light, double{weight[i]} * sample.weight);
            }
        }
    }

    const SplatFootprint& footprint_;
    Patch& patch_;
    std::vector<float> weights_;
    std::array<SplatFootprint::Corner, together> corners_;
};

}  // namespace

Rectangle intersection(const Rectangle& a, const Rectangle& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

void Patch::add(const Patch& other) {
    const Rectangle& pixels = other.pixels();
    for (int y = pixels.top; y < pixels.bottom; ++y) {
        const Sum* from = other.row(pixels.left, y);
        Sum* to = row(pixels.left, y);
        for (int i = 0; i < pixels.width(); ++i) to[i] += from[i];
    }
}

std::vector<Patch> splat(std::span<const FilmSample> samples, const SplatFootprint& footprint,
                         const Rectangle& image) {
    std::vector<Patch> patches;
    while (!samples.empty()) {
        const auto run = first_run(samples);
        samples = samples.subspan(run.size());
        const Rectangle reached = cells_of(run).widened(footprint.border());
        const Rectangle pixels = intersection(reached, image);
        if (pixels.empty()) continue;
        Splatter(footprint, patches.emplace_back(pixels)).add(run);
    }
    return patches;
}

}  // namespace rayshoot

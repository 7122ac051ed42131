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
    Splatter(const Footprint& footprint, Patch& patch)
        : footprint_(footprint), patch_(patch), weights_(footprint.largest()) {}

    void add(const FilmSample& sample) {
        const Cover cover = footprint_.weigh(sample.x, sample.y, weights_);
        const int left = sample.pixel.x + cover.left, top = sample.pixel.y + cover.top;
        const Rectangle inside =
            intersection({left, top, left + cover.columns, top + cover.rows}, patch_.pixels());
        if (inside.empty()) return;
        const std::array<double, 4> light{sample.radiance.x, sample.radiance.y, sample.radiance.z,
                                          1};
        for (int y = inside.top; y < inside.bottom; ++y) {
            const float* weights =
                weights_.data() + (y - top) * cover.columns + (inside.left - left);
            Sum* sums = patch_.row(inside.left, y);
            for (int i = 0; i < inside.width(); ++i) {
                sums[i].add(light, double{weights[i]} * sample.weight);
            }
        }
    }

private:
    const Footprint& footprint_;
    Patch& patch_;
    std::vector<float> weights_;
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

std::vector<Patch> splat(std::span<const FilmSample> samples, const Footprint& footprint,
                         const Rectangle& image) {
    std::vector<Patch> patches;
    while (!samples.empty()) {
        const auto run = first_run(samples);
        samples = samples.subspan(run.size());
        const Rectangle reached = cells_of(run).widened(footprint.border());
        const Rectangle pixels = intersection(reached, image);
        if (pixels.empty()) continue;
        Splatter splatter(footprint, patches.emplace_back(pixels));
        for (const FilmSample& sample : run) splatter.add(sample);
    }
    return patches;
}

}  // namespace rayshoot

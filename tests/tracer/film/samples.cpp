#include "tests/tracer/film/samples.h"

#include <cmath>

#include "tracer/tiles.h"

namespace rayshoot::film_tests {
namespace {

constexpr int cells_per_tile = 50;  // no power of two: tiles lie across the blocks of patches

/// In [0, 1)^2, for spp = n x n strata if jittered.
Pair pair_of(const RandomSequence& random, int sample, const Sampling& sampling) {
    Pair pair{random.number(0), random.number(1)};
    if (!sampling.jittered) return pair;
    const int edge = static_cast<int>(std::lround(std::sqrt(sampling.spp)));
    const auto within = [edge](int stratum, float u) {
        return std::min((static_cast<float>(stratum) + u) / static_cast<float>(edge), 1 - 0x1p-24f);
    };
    return {within(sample % edge, pair.u), within(sample / edge, pair.v)};
}

FilmSample make_sample(Pixel pixel, int index, const Filter& filter, const Way& way,
                       const Sampling& sampling) {
    const auto key = static_cast<std::uint32_t>((pixel.y + 4096) * 8192 + pixel.x + 4096);
    const RandomSequence random(sampling.seed, key, static_cast<std::uint32_t>(index));
    const Pair pair = pair_of(random, index, sampling);
    FilmSample sample{pixel, pair.u, pair.v, flat_light, 1.0f / static_cast<float>(sampling.spp)};
    double x = pixel.x + double{pair.u}, y = pixel.y + double{pair.v};
    if (!way.splats()) {
        const Filter::Offset offset = way.reconstruction == Reconstruction::importance
                                          ? filter.importance(pair)
                                          : filter.uniform(pair);
        x = pixel.x + 0.5 + offset.x;
        y = pixel.y + 0.5 + offset.y;
        sample.weight = static_cast<float>(offset.weight);
    }
    if (sampling.light) {
        sample.radiance = sampling.light(x, y);
    } else if (!sampling.flat) {
        sample.radiance = {random.number(2), 10 * random.number(3), random.number(4) / 1000};
    }
    return sample;
}

}  // namespace

std::string Way::label() const {
    return std::string(name(filter.kind)) + " " + std::to_string(filter.radius) + " " +
           std::string(name(reconstruction));
}

std::vector<Way> every_way() {
    std::vector<Way> ways;
    using enum Reconstruction;
    for (const Reconstruction way : {importance, weighted, splat, splat_undivided}) {
        for (const FilterSettings& filter : {FilterSettings{FilterKind::box, 1},
                                             {FilterKind::cone, 1.7},
                                             {FilterKind::raised_cosine, 1.7},
                                             {FilterKind::gaussian, 1.5},
                                             {FilterKind::mitchell, 2},
                                             {FilterKind::blackman_harris, 2}}) {
            ways.push_back({filter, way});
        }
    }
    return ways;
}

std::vector<Tile> make_tiles(const Film& film, const Way& way, const Sampling& sampling) {
    const Filter filter(way.filter);
    const Image image = film.image();
    const int border = film.traced_border();
    std::vector<Tile> tiles;
    int cells = 0;
    for (const Pixel cell : morton_order(image.width() + 2 * border, image.height() + 2 * border)) {
        if (cells++ % cells_per_tile == 0) tiles.emplace_back();
        const Pixel pixel{static_cast<std::int16_t>(cell.x - border),
                          static_cast<std::int16_t>(cell.y - border)};
        for (int i = 0; i < sampling.spp; ++i) {
            tiles.back().push_back(make_sample(pixel, i, filter, way, sampling));
        }
    }
    return tiles;
}

void hand_in(Film& film, const std::vector<Tile>& tiles, std::span<const std::size_t> order) {
    for (const std::size_t tile : order) film.add(tile, tiles[tile]);
}

void hand_in(Film& film, const std::vector<Tile>& tiles) {
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) film.add(tile, tiles[tile]);
}

}  // namespace rayshoot::film_tests

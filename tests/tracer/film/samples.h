#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tracer/film/film.h"
#include "tracer/random.h"

/// Samples of made-up images, as a renderer would hand them in.
namespace rayshoot::film_tests {

/// A filter and what is done with it.
struct Way {
    FilterSettings filter;
    Reconstruction reconstruction = Reconstruction::importance;

    Film film(int width, int height) const {
        return {width, height, Filter(filter), reconstruction};
    }
    bool splats() const {
        return reconstruction == Reconstruction::splat ||
               reconstruction == Reconstruction::splat_undivided;
    }
    std::string label() const;
};
/// Every filter in every way, at its usual radius.
std::vector<Way> every_way();

inline const vec3 flat_light{0.1f, 0.3f, 7.7e-5f};  ///< no short binary fractions

using Tile = std::vector<FilmSample>;

/// Radiance at a place of the raster.
using Light = std::function<vec3(double x, double y)>;

struct Sampling {
    int spp = 1;
    bool flat = false;      ///< flat_light everywhere, else random light
    bool jittered = false;  ///< one sample to each of spp strata; else independent ones
    std::uint32_t seed = 0;
    Light light = {};  ///< instead of either
};

/// All samples that a film needs, in tiles along the Morton curve that share no cell.
std::vector<Tile> make_tiles(const Film& film, const Way& way, const Sampling& sampling);

void hand_in(Film& film, const std::vector<Tile>& tiles, std::span<const std::size_t> order);
void hand_in(Film& film, const std::vector<Tile>& tiles);

}  // namespace rayshoot::film_tests

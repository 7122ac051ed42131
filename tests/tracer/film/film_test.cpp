#include "tracer/film/film.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "tests/tracer/film/samples.h"
#include "tracer/tiles.h"

namespace rayshoot {
namespace {

using film_tests::every_way;
using film_tests::hand_in;
using film_tests::make_tiles;
using film_tests::Tile;
using film_tests::Way;

constexpr int width = 45, height = 37;

std::vector<std::size_t> in_order(std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return order;
}

/// Whatever comes first: backwards, inside out, or shuffled.
std::vector<std::vector<std::size_t>> orders(std::size_t count) {
    std::vector<std::vector<std::size_t>> all(3, in_order(count));
    std::ranges::reverse(all[0]);
    std::ranges::rotate(all[1], all[1].begin() + static_cast<std::ptrdiff_t>(count / 2));
    std::ranges::sort(all[2], {}, [](std::size_t i) { return scrambled(i); });
    return all;
}

TEST(Film, the_order_of_tiles_changes_no_bit) {
    for (const Way& way : every_way()) {
        Film film = way.film(width, height);
        const std::vector<Tile> tiles = make_tiles(film, way, {.spp = 3});
        ASSERT_GT(tiles.size(), 10u);
        hand_in(film, tiles, in_order(tiles.size()));
        for (const auto& order : orders(tiles.size())) {
            Film other = way.film(width, height);
            hand_in(other, tiles, order);
            EXPECT_EQ(other.image(), film.image()) << way.label();
            EXPECT_EQ(other.waiting(), 0u);
        }
    }
}

TEST(Film, lanes_change_no_bit) {
    for (const Way& way : every_way()) {
        Film film = way.film(width, height);
        const std::vector<Tile> tiles = make_tiles(film, way, {.spp = 3});
        hand_in(film, tiles, in_order(tiles.size()));
        for (int repeat = 0; repeat < 3; ++repeat) {
            Film other = way.film(width, height);
            tbb::parallel_for(std::size_t{0}, tiles.size(),
                              [&](std::size_t tile) { other.add(tile, tiles[tile]); });
            EXPECT_EQ(other.image(), film.image()) << way.label();
        }
    }
}

/// The image of some tiles is the same whether those between them come later or never.
TEST(Film, partial_images_are_of_the_tiles_so_far) {
    for (const Way& way : every_way()) {
        Film early = way.film(width, height), late = way.film(width, height);
        const std::vector<Tile> tiles = make_tiles(early, way, {.spp = 2});
        std::vector<std::size_t> some{0, 1, 2, 5, 6, 9};
        hand_in(early, tiles, some);
        std::ranges::reverse(some);
        hand_in(late, tiles, some);
        EXPECT_EQ(early.image(), late.image()) << way.label();
        std::vector<std::size_t> rest;
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            if (std::ranges::find(some, i) == some.end()) rest.push_back(i);
        }
        hand_in(early, tiles, rest);
        Film whole = way.film(width, height);
        hand_in(whole, tiles, in_order(tiles.size()));
        EXPECT_EQ(early.image(), whole.image()) << way.label();
    }
}

TEST(Film, images_may_be_taken_while_lanes_add) {
    const Way way{{FilterKind::cone, 1.7}, Reconstruction::splat};
    Film film = way.film(width, height);
    const std::vector<Tile> tiles = make_tiles(film, way, {.spp = 4, .flat = true});
    tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t tile) {
        film.add(tile, tiles[tile]);
        const Image image = film.image();
        for (const vec3& pixel : image.pixels()) {
            ASSERT_TRUE(pixel == vec3(0) || pixel == film_tests::flat_light);
        }
    });
    const Image image = film.image();
    for (const vec3& pixel : image.pixels()) EXPECT_EQ(pixel, film_tests::flat_light);
}

TEST(Film, an_empty_film_is_black) {
    for (const Way& way : every_way()) {
        EXPECT_EQ(way.film(7, 5).image(), Image(7, 5)) << way.label();
    }
}

/// As many tiles wait as came before the first one, and none from then on.
TEST(Film, tiles_wait_for_those_before_them_only_when_splatting) {
    for (const Way& way : every_way()) {
        Film film = way.film(width, height);
        const std::vector<Tile> tiles = make_tiles(film, way, {.spp = 1});
        const bool splats = film.traced_border() > 0;
        for (std::size_t i = tiles.size(); i-- > 1;) film.add(i, tiles[i]);
        EXPECT_EQ(film.waiting(), splats ? tiles.size() - 1 : 0) << way.label();
        film.add(0, tiles[0]);
        EXPECT_EQ(film.waiting(), 0u) << way.label();
    }
}

/// The image without a film: float by float in the order of samples, times 1 / samples.
TEST(Film, a_box_of_one_pixel_is_the_plain_mean_bit_for_bit) {
    const Way way{{FilterKind::box, 0.5}, Reconstruction::importance};
    for (const int spp : {1, 3, 16, 100}) {
        Film film = way.film(width, height);
        const std::vector<Tile> tiles = make_tiles(film, way, {.spp = spp});
        Image plain(width, height);
        for (const Tile& tile : tiles) {
            for (const FilmSample& sample : tile) {
                plain.at(sample.pixel.x, sample.pixel.y) += sample.radiance;
            }
        }
        const float share = 1.0f / static_cast<float>(spp);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) plain.at(x, y) *= share;
        }
        hand_in(film, tiles, in_order(tiles.size()));
        EXPECT_EQ(film.image(), plain) << spp;
        EXPECT_EQ(film.border(), 0);
    }
}

/// Splatting a box of one pixel gives that mean, too, but for the rounding of floats.
TEST(Film, a_splatted_box_of_one_pixel_is_the_mean) {
    const Way plain{{FilterKind::box, 0.5}, Reconstruction::importance};
    Film mean = plain.film(width, height);
    const std::vector<Tile> tiles = make_tiles(mean, plain, {.spp = 8});
    hand_in(mean, tiles, in_order(tiles.size()));
    for (const auto way : {Reconstruction::splat, Reconstruction::splat_undivided}) {
        Film film = Way{{FilterKind::box, 0.5}, way}.film(width, height);
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            Tile tile = tiles[i];
            for (FilmSample& sample : tile) sample.weight = 1.0f / 8;
            film.add(i, tile);
        }
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                EXPECT_NEAR(film.image().at(x, y).x, mean.image().at(x, y).x, 1e-5f);
            }
        }
    }
}

TEST(Film, samples_out_of_reach_are_ignored) {
    for (const Way& way : every_way()) {
        Film film = way.film(8, 8);
        const std::vector<FilmSample> far{{.pixel = {-20, 3}, .radiance = vec3(1)},
                                          {.pixel = {3, 30}, .radiance = vec3(1)},
                                          {.pixel = {32000, -32000}, .radiance = vec3(1)}};
        film.add(0, far);
        EXPECT_EQ(film.image(), Image(8, 8)) << way.label();
    }
}

TEST(Film, what_cannot_work_is_refused) {
    const Filter filter({FilterKind::cone, 0.6});
    EXPECT_THROW(Film(8, 8, filter, Reconstruction::splat), std::invalid_argument);
    EXPECT_NO_THROW(Film(8, 8, filter, Reconstruction::importance));
    EXPECT_THROW(Film(0, 8, Filter(), Reconstruction::importance), std::invalid_argument);
    EXPECT_THROW(Film(8, 40000, Filter(), Reconstruction::importance), std::invalid_argument);
    EXPECT_THROW(reconstruction("sum"), std::invalid_argument);
    EXPECT_EQ(reconstruction("splat_undivided"), Reconstruction::splat_undivided);
    EXPECT_EQ(name(Reconstruction::weighted), "weighted");
}

TEST(Film, only_splatting_traces_its_border) {
    const Filter filter({FilterKind::cone, 1.7});
    EXPECT_EQ(Film(8, 8, filter, Reconstruction::splat).traced_border(), 2);
    EXPECT_EQ(Film(8, 8, filter, Reconstruction::splat).border(), 2);
    EXPECT_EQ(Film(8, 8, filter, Reconstruction::importance).traced_border(), 0);
    EXPECT_EQ(Film(8, 8, filter, Reconstruction::importance).border(), 2);
}

}  // namespace
}  // namespace rayshoot

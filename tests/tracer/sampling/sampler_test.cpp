#include "tracer/sampling/sampler.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "tests/tracer/sampling/kinds.h"
#include "tracer/camera.h"

namespace rayshoot {
namespace {

constexpr int counts[] = {1, 2, 4, 6, 7, 9, 16, 25, 36};

bool has_strata(SamplerKind kind) {
    return kind != SamplerKind::random && kind != SamplerKind::sobol;
}

TEST(Sampler, numbers_lie_in_the_half_open_unit_interval) {
    for (const SamplerSettings& settings : every_kind(16)) {
        const Sampler sampler(settings);
        for (std::int16_t x = -300; x < 300; ++x) {
            for (const Use use : every_use) {
                const Pair pair = sampler.pair({x, -1}, 7, {use, 3});
                const float number = sampler.number({x, 32767}, 15, {use, 1});
                for (const float value : {pair.u, pair.v, number}) {
                    ASSERT_GE(value, 0.0f);
                    ASSERT_LT(value, 1.0f);
                    ASSERT_EQ(value * 0x1p24f, std::floor(value * 0x1p24f));
                }
            }
        }
    }
}

TEST(Sampler, each_stratum_is_met_once) {
    for (const int spp : counts) {
        for (const SamplerSettings& settings : every_kind(spp)) {
            const Sampler sampler(settings);
            if (!has_strata(settings.kind)) continue;
            const auto across = static_cast<std::size_t>(sampler.strata_across());
            const auto down = static_cast<std::size_t>(sampler.strata_down());
            EXPECT_EQ(across * down, static_cast<std::size_t>(spp));
            for (const Use use : every_use) {
                std::set<std::size_t> cells, intervals;
                for (const std::uint32_t s : samples(spp)) {
                    const Pair pair = sampler.pair({-2, 40}, s, {use});
                    cells.insert(cell(pair.v, down) * across + cell(pair.u, across));
                    const float number = sampler.number({-2, 40}, s, {use});
                    intervals.insert(cell(number, static_cast<std::size_t>(spp)));
                }
                EXPECT_EQ(cells.size(), samples(spp).size()) << name(settings.kind) << " " << spp;
                EXPECT_EQ(intervals.size(), samples(spp).size()) << name(settings.kind);
            }
        }
    }
}

TEST(Sampler, strata_of_the_pixel_are_in_rows) {
    for (const SamplerSettings& settings : every_kind(12)) {
        const Sampler sampler(settings);
        if (!has_strata(settings.kind)) continue;
        EXPECT_EQ(sampler.strata_across(), 4);
        EXPECT_EQ(sampler.strata_down(), 3);
        for (const std::uint32_t s : samples(12)) {
            const Pair pair = sampler.pair({5, 6}, s, {});
            EXPECT_EQ(cell(pair.v, 3) * 4 + cell(pair.u, 4), s);
        }
    }
}

TEST(Sampler, every_elementary_interval_of_sobol_is_met_once) {
    for (int k = 0; k <= 8; ++k) {
        for (const bool blue_noise : {false, true}) {
            const int spp = 1 << k;
            const Sampler sampler({SamplerKind::sobol, spp, blue_noise});
            for (const Use use : every_use) {
                for (int i = 0; i <= k; ++i) {
                    const std::size_t across = std::size_t{1} << i, down = 1u << (k - i);
                    std::set<std::size_t> cells;
                    for (const std::uint32_t s : samples(spp)) {
                        const Pair pair = sampler.pair({7, -9}, s, {use, 5});
                        cells.insert(cell(pair.v, down) * across + cell(pair.u, across));
                    }
                    EXPECT_EQ(cells.size(), samples(spp).size());
                }
            }
        }
    }
}

/// As adaptive sampling takes them: the first 2^j samples of 2^k are stratified, too.
TEST(Sampler, the_first_samples_of_sobol_are_stratified) {
    for (const bool blue_noise : {false, true}) {
        const Sampler sampler({SamplerKind::sobol, 64, blue_noise});
        for (const int first : {2, 4, 8, 16, 32}) {
            std::set<std::size_t> intervals;
            for (const std::uint32_t s : samples(first)) {
                const float number = sampler.number({7, 9}, s, {Use::light});
                intervals.insert(cell(number, static_cast<std::size_t>(first)));
            }
            EXPECT_EQ(intervals.size(), samples(first).size());
        }
    }
}

TEST(Sampler, one_sample_goes_through_the_middle) {
    for (const SamplerKind kind : {SamplerKind::regular, SamplerKind::jitter}) {
        const Sampler sampler({kind, 1});
        EXPECT_EQ(sampler.pair({3, 4}, 0, {}), (Pair{0.5f, 0.5f}));
        EXPECT_NE(sampler.pair({3, 4}, 0, {Use::lens}), sampler.pair({4, 4}, 0, {Use::lens}));
    }
}

TEST(Sampler, regular_samples_are_the_lattice) {
    const Sampler sampler({SamplerKind::regular, 6});
    for (const std::uint32_t s : samples(6)) {
        const Pair pair = sampler.pair({3, 4}, s, {});
        EXPECT_NEAR(pair.u, (s % 3 + 0.5) / 3, 0x1p-24);
        EXPECT_EQ(pair.v, (static_cast<float>(s / 3) + 0.5f) / 2);
    }
}

TEST(Sampler, dimensions_and_pixels_are_permuted_differently) {
    const Sampler sampler({SamplerKind::jitter, 16});
    const auto order = [&](Pixel pixel, Dimension dimension) {
        std::vector<std::size_t> strata;
        for (const std::uint32_t s : samples(16)) {
            strata.push_back(cell(sampler.number(pixel, s, dimension), 16));
        }
        return strata;
    };
    std::set<std::vector<std::size_t>> orders;
    for (std::int16_t x = -16; x < 16; ++x) {
        for (const Use use : every_use) {
            for (const std::uint32_t place : {1u, 2u, 3u}) {
                orders.insert(order({x, 7}, {use, place}));
            }
        }
    }
    // Of 768. There are 2^16: 256 rows of a table, turned round in 16 x 16 ways.
    EXPECT_GE(orders.size(), 755u);
}

TEST(Sampler, samples_are_the_same_in_any_order_and_from_any_sampler) {
    for (const SamplerSettings& settings : every_kind(9)) {
        const Sampler once(settings), again(settings);
        std::vector<Pair> pairs;
        for (const std::uint32_t s : samples(9)) pairs.push_back(once.pair({1, 2}, s, {Use::lens}));
        for (std::uint32_t s = 9; s-- > 0;) {
            EXPECT_EQ(again.pair({1, 2}, s, {Use::lens}), pairs[s]);
        }
        SamplerSettings other = settings;
        other.seed = 1;
        EXPECT_NE(Sampler(other).pair({1, 2}, 0, {Use::lens}), pairs[0]);
    }
}

/// As whole multiples of 2^-24: of the pixel, of a light, of time. An image's digest hangs on them.
std::vector<std::uint32_t> some_numbers(const SamplerSettings& settings) {
    const Sampler sampler(settings);
    const auto [x, y] = sampler.pair({-3, 500}, 11, {});
    const auto [u, v] = sampler.pair({-3, 500}, 11, {Use::light, 6});
    std::vector<std::uint32_t> multiples;
    for (const float number : {x, y, u, v, sampler.number({-3, 500}, 11, {Use::time})}) {
        multiples.push_back(static_cast<std::uint32_t>(number * 0x1p24f));
    }
    return multiples;
}

TEST(Sampler, numbers_never_change) {
    using enum SamplerKind;
    using Numbers = std::vector<std::uint32_t>;
    EXPECT_EQ(some_numbers({random, 16}), (Numbers{6965556, 4718750, 6264758, 10010071, 745983}));
    EXPECT_EQ(some_numbers({regular, 16}),
              (Numbers{14680064, 10485760, 9954797, 10891125, 13678111}));
    EXPECT_EQ(some_numbers({jitter, 16}),
              (Numbers{14324301, 9568295, 9954797, 10891125, 13678111}));
    EXPECT_EQ(some_numbers({gaussian, 16}),
              (Numbers{14465784, 9909203, 9954797, 10891125, 13678111}));
    EXPECT_EQ(some_numbers({jitter, 16, false, true}),
              (Numbers{14324301, 9568295, 9954797, 10891125, 3192351}));
    EXPECT_EQ(some_numbers({sobol, 16}), (Numbers{5463750, 15959727, 1143971, 1655385, 1392309}));
    EXPECT_EQ(some_numbers({sobol, 16, true}),
              (Numbers{8949439, 16105699, 382102, 4846102, 8587343}));
}

TEST(Sampler, places_are_a_binary_tree_then_hashed) {
    constexpr Dimension root{Use::light};
    EXPECT_EQ(root.child(0), (Dimension{Use::light, 2}));
    EXPECT_EQ(root.child(1).child(0), (Dimension{Use::light, 6}));
    std::set<std::uint32_t> places;
    Dimension deep = root;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        deep = deep.child(i & 1);
        places.insert(deep.place);
        places.insert(deep.child(2 + i).place);  // of a light's own
        EXPECT_LT(deep.place, Dimension::place_limit);
    }
    EXPECT_EQ(places.size(), 2000u);
}

TEST(Sampler, kinds_have_names) {
    for (const SamplerSettings& settings : every_kind(1)) {
        EXPECT_EQ(sampler_kind(name(settings.kind)), settings.kind);
    }
    EXPECT_THROW(sampler_kind("halton"), std::invalid_argument);
}

TEST(Sampler, settings_out_of_range_are_refused) {
    EXPECT_THROW(Sampler({SamplerKind::jitter, 0}), std::invalid_argument);
    EXPECT_THROW(Sampler({SamplerKind::jitter, largest_spp + 1}), std::invalid_argument);
    EXPECT_NO_THROW(Sampler({SamplerKind::jitter, largest_spp}));
    EXPECT_THROW(Sampler({SamplerKind::jitter, 4, true}), std::invalid_argument);
    EXPECT_THROW(Sampler({SamplerKind::sobol, 4, false, true}), std::invalid_argument);
    EXPECT_THROW(Sampler({SamplerKind::random, 4, false, true}), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot

#include "bench/textbook/figures.h"
#include "bench/textbook/pictures.h"
#include "bench/textbook/shots.h"

#include "data/nff.h"
#include "data/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Motion blur: an edge that moves while the shutter is open becomes the shutter's integral.
namespace rayshoot::textbook {
namespace {

/// A bright sheet whose edge goes from x = -1 to x = 1, before black. Without lights a surface has
/// half its colour.
Scene moving_edge() {
    return read_nff(
        "v from 0 0 10 at 0 0 0 up 0 1 0 angle 17 hither 0 resolution 1 1\n"
        "f 2 2 2 1 0 1 0 1\n"
        "move -1 0 0  1 0 0\n"
        "p 4  -50 -50 0  0 -50 0  0 50 0  -50 50 0\n",
        "a moving edge");
}

/// Shares of the light that come in before a share u of the exposure.
double alike(double u) { return u; }
double rising_and_falling(double u) { return u < 0.5 ? 2 * u * u : 1 - 2 * (1 - u) * (1 - u); }
double raised_cosine(double u) {
    return u - std::sin(2 * std::numbers::pi * u) / (2 * std::numbers::pi);
}

struct Exposed {
    std::string_view name, settings;
    double open, close;
    double (*integral)(double);

    /// The sheet covers x from when its edge has passed it.
    double expected(double x) const {
        const double passing = (x + 1) / 2;
        return 1 - integral(std::clamp((passing - open) / (close - open), 0.0, 1.0));
    }
};
constexpr std::array<Exposed, 4> exposures{
    {{"box", "shutter=box", 0, 1, alike},
     {"triangle", "shutter=triangle", 0, 1, rising_and_falling},
     {"raised cosine", "shutter=raised_cosine", 0, 1, raised_cosine},
     {"box, open for the middle half", "open=0.25,close=0.75", 0.25, 0.75, alike}}};

Profile coverage(const Studio& studio, const Exposed& exposed) {
    const int size = studio.edge;
    const Scene scene = moving_edge();
    const Image image =
        shot(studio, scene, "sampler=jitter,spp=64," + std::string(exposed.settings), size, size);
    Profile profile;
    for (int x = 0; x < size; ++x) {
        const Ray ray = middle_ray(scene, size, size, x, size / 2);
        const double t = -double{ray.origin.z} / double{ray.direction.z};
        profile.push_back({t * double{ray.direction.x}, column_mean(image, x)});
    }
    return profile;
}

}  // namespace

void motion_blur(const Studio& studio, Sheet& sheet) {
    const Scene scene = load_scene("gallery/motion_blur");
    const Image instant = gallery_shot(studio, scene, "sampler=sobol,spp=16,close=0");
    const Image open = gallery_shot(studio, scene, "sampler=sobol,spp=64");
    sheet.add(Picture{"motion_blur", "An instant; the shutter open all the time"},
              tiled(std::array{instant, open}, 2));

    Chart chart{
        "moving_edge", "An edge that moves while the shutter is open", "place", "light", {}};
    for (const Exposed& exposed : exposures) {
        const Profile measured = coverage(studio, exposed);
        const auto expected = [&](double x) { return exposed.expected(x); };
        const std::string name(exposed.name);
        const double departure = largest_departure(measured, expected);
        sheet.add(Check{"shutter " + name + ": departure from its integral, of 1, at most 0.02", "",
                        number_cell(departure, 2), agrees_if(departure <= 0.02)});
        chart.series.push_back({name, Series::Mark::line, at_places_of(measured, expected)});
        chart.series.push_back({name + ", rendered", Series::Mark::points, measured});
    }
    sheet.add(std::move(chart));
}

}  // namespace rayshoot::textbook

#include "bench/textbook/figures.h"
#include "bench/textbook/pictures.h"
#include "bench/textbook/shots.h"

#include "data/nff.h"
#include "data/scenes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

/// Soft shadows: the penumbra of a straight edge under a strip light.
namespace rayshoot::textbook {
namespace {

// Scene units, and shares of the lamp's height.
constexpr double lamp_height = 10, lamp_width = 0.5;
constexpr double edge_height = 5;
/// By similar triangles with their common point on the edge.
constexpr double penumbra = lamp_width * edge_height / (lamp_height - edge_height);

/// A floor, a lamp above x = 0, and between them, at `edge_height`, a sheet over x < 0. The camera
/// looks below the sheet from the side; rows of its image are lines of equal x.
Scene edge_scene(bool with_sheet) {
    std::ostringstream text;
    text << "v from 3 3 0 at 0 0 0 up 0 1 0 angle 12 hither 0 resolution 1 1\n"
            "surface lambert colour 0.8 0.8 0.8\n"
            "p 4  -50 0 -50  -50 0 50  50 0 50  50 0 -50\n";
    if (with_sheet)
        text << "p 4  -50 " << edge_height << " -50  -50 " << edge_height << " 50  0 "
             << edge_height << " 50  0 " << edge_height << " -50\n";
    text << "light rectangle " << lamp_width / 2 << ' ' << lamp_height << " -1  0 0 2  "
         << -lamp_width << " 0 0  100 100 100\n";
    return read_nff(text.str(), "an edge under a strip light");
}

/// The share of the lamp's light that comes past the edge, by x on the floor.
Profile lit_share(const Studio& studio) {
    constexpr std::string_view settings = "method=path,depth=2,sampler=sobol,spp=64";
    const int size = studio.edge;
    const Scene scene = edge_scene(true);
    const Image lit = shot(studio, scene, settings, size, size);
    const Image open = shot(studio, edge_scene(false), settings, size, size);
    Profile profile;
    for (int y = size - 1; y >= 0; --y) {
        const Ray ray = middle_ray(scene, size, size, size / 2, y);
        const double t = -double{ray.origin.y} / double{ray.direction.y};
        profile.push_back({double{ray.origin.x} + t * double{ray.direction.x},
                           row_mean(lit, y) / row_mean(open, y)});
    }
    std::ranges::sort(profile);
    return profile;
}

double ramp(double x) { return std::clamp(0.5 + x / penumbra, 0.0, 1.0); }

}  // namespace

void soft_shadow(const Studio& studio, Sheet& sheet) {
    const Image hard = gallery_shot(studio, load_scene("gallery/hard_shadow"),
                                    "method=path,depth=2,sampler=sobol,spp=16");
    const Image soft = gallery_shot(studio, load_scene("gallery/soft_shadow"),
                                    "method=path,depth=2,sampler=sobol,spp=64");
    sheet.add(Picture{"soft_shadow", "A point lamp; a square one"},
              tiled(std::array{hard, soft}, 2));

    const Profile measured = lit_share(studio);
    sheet.add(Chart{"penumbra",
                    "Light past a straight edge under a strip light",
                    "place on the floor",
                    "share of the lamp",
                    {{"similar triangles", Series::Mark::line, at_places_of(measured, ramp)},
                     {"rendered", Series::Mark::points, measured}}});
    constexpr double of_a_ramp = 0.8;  // of its width lie between a tenth and nine tenths
    const double width = tenth_to_ninth_width(measured) / of_a_ramp;
    sheet.add(Check{"width of the penumbra, by similar triangles " + number_cell(penumbra, 4), "",
                    number_cell(width, 4), agrees_within(width, penumbra, 0.03)});
    const double departure = largest_departure(measured, ramp);
    sheet.add(Check{"departure from a linear ramp, of 1, at most 0.03", "",
                    number_cell(departure, 2), agrees_if(departure <= 0.03)});
}

}  // namespace rayshoot::textbook

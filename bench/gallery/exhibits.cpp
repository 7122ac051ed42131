#include "bench/gallery/exhibits.h"

#include <algorithm>
#include <stdexcept>

namespace rayshoot::gallery {
namespace {

constexpr Exhibit in_order[]{
    {"Antialiasing", "point_sampled", "spd/teapot", "240x240", "sampler=regular",
     "one ray through the middle of each pixel"},
    {"Antialiasing", "filtered", "spd/teapot", "240x240", "spp=64,filter=hann,radius=1.6",
     "64 samples, a raised cosine of radius 1.6 by importance"},
    {"Antialiasing", "adaptive", "spd/teapot", "240x240",
     "filter=hann,radius=1.6,least=8,round=8,most=128,tolerance=0.01",
     "adaptive: 8 to 128 samples, until the error of a pixel is 1 % of white"},

    {"Order of noise", "white_noise", "gallery/soft_shadow", "240x180",
     "method=path,depth=2,sampler=random,spp=4", "4 independent samples a pixel"},
    {"Order of noise", "stratified", "gallery/soft_shadow", "240x180",
     "method=path,depth=2,sampler=jitter,spp=4", "4 stratified samples"},
    {"Order of noise", "blue_noise", "gallery/soft_shadow", "240x180",
     "method=path,depth=2,sampler=sobol,order=blue_noise,spp=4",
     "4 samples of a scrambled Sobol' sequence in blue-noise order"},

    {"Shadows", "hard_shadow", "gallery/hard_shadow", "240x180",
     "method=path,depth=2,sampler=sobol,spp=16", "a point lamp"},
    {"Shadows", "soft_shadow", "gallery/soft_shadow", "240x180",
     "method=path,depth=2,sampler=sobol,spp=256", "a square lamp of the same power"},

    {"Blurred reflection", "blurred_reflection", "gallery/blurred_reflection", "320x240",
     "sampler=sobol,spp=256",
     "mirrors with a lobe of no width, of Phong exponent 400 and of 60: the farther, the duller"},

    {"Depth of field", "pinhole", "gallery/depth_of_field", "240x180",
     "sampler=sobol,spp=16,lens=f1000", "an aperture too small to blur"},
    {"Depth of field", "depth_of_field", "gallery/depth_of_field", "240x180",
     "sampler=sobol,spp=256", "f/2, six blades, focused on the green ball"},

    {"Moving objects", "shutter_closed", "gallery/motion_blur", "240x180",
     "sampler=sobol,spp=16,close=0", "an instant"},
    {"Moving objects", "motion_blur", "gallery/motion_blur", "240x180", "sampler=sobol,spp=256",
     "the shutter open all the time"},
    {"Moving objects", "motion_blur_weighted", "gallery/motion_blur", "240x180",
     "sampler=sobol,spp=256,shutter=raised_cosine", "the shutter weighted by a raised cosine"},

    {"Moving camera", "camera_at_rest", "gallery/camera_motion", "240x180",
     "sampler=sobol,spp=16,open=0.5,close=0.5", "an instant"},
    {"Moving camera", "camera_motion", "gallery/camera_motion", "240x180", "sampler=sobol,spp=256",
     "the camera moves past and keeps its eye on the middle column"},

    {"Wagon wheel", "wagon_wheel_instant", "gallery/wagon_wheel", "80x80",
     "sampler=sobol,spp=16,close=0",
     "12 frames, an instant each: the wheel turns by 27.5° a frame, its spokes seem to turn by "
     "-2.5°",
     12},
    {"Wagon wheel", "wagon_wheel", "gallery/wagon_wheel:shutter=1", "80x80", "sampler=sobol,spp=64",
     "the shutter open all the time: the spokes melt, the red one shows where it goes", 12},

    {"Surfaces", "metals", "gallery/metals", "320x128", "method=path,sampler=sobol,spp=256",
     "gold by GGX, roughness 0, 0.1, 0.2, 0.4, 0.8"},
    {"Surfaces", "glass", "gallery/glass", "320x128", "method=path,sampler=sobol,spp=1024",
     "glass by GGX, roughness 0, 0.1, 0.2, 0.4, and a coated diffuser"},
    {"Surfaces", "matt", "gallery/matt", "320x128", "method=path,sampler=sobol,spp=16",
     "Lambert's law, and Oren and Nayar's with σ = 0.3, 0.6, 0.9, 1.2"},

    {"Global illumination", "cornell_box_direct", "gallery/cornell_box", "160x160",
     "method=path,depth=2,sampler=sobol,spp=64", "light from the lamp alone"},
    {"Global illumination", "cornell_box_path", "gallery/cornell_box", "160x160",
     "method=path,sampler=sobol,spp=512", "paths of any length"},
    {"Global illumination", "cornell_box_irradiance", "gallery/cornell_box", "160x160",
     "method=irradiance,sampler=sobol,spp=64,gather=1024,cache_error=0.1",
     "an irradiance cache of error 0.1"},
};

std::string names_of_exhibits() {
    std::string names;
    for (const Exhibit& exhibit : in_order)
        names += (names.empty() ? "" : ", ") + std::string(exhibit.name);
    return names;
}

}  // namespace

std::span<const Exhibit> exhibits() { return in_order; }

std::vector<Exhibit> chosen_exhibits(std::span<const std::string> names) {
    if (names.empty()) return {exhibits().begin(), exhibits().end()};
    for (const std::string& name : names) {
        if (std::ranges::find(in_order, name, &Exhibit::name) == std::end(in_order))
            throw std::invalid_argument("no picture \"" + name + "\"; there are " +
                                        names_of_exhibits());
    }
    std::vector<Exhibit> chosen;
    std::ranges::copy_if(in_order, std::back_inserter(chosen), [&](const Exhibit& exhibit) {
        return std::ranges::find(names, exhibit.name) != names.end();
    });
    return chosen;
}

}  // namespace rayshoot::gallery

#include "bench/textbook/figures.h"
#include "bench/textbook/pictures.h"

#include "data/scenes.h"
#include "tracer/colour_map.h"
#include "tracer/image_difference.h"
#include "tracer/render.h"

#include <algorithm>

/// "No antialiasing" against "3 x 3 supersampling", and both close up.
namespace rayshoot::textbook {
namespace {

constexpr const char* aliased_scene = "spd/teapot";  // edges, and a chequered floor
constexpr int supersamples = 9;                      // 3 x 3 strata of the pixel, box filter
constexpr int reference_samples = 144;               // its own error is a tenth of what is measured
constexpr int close_up_share = 8;  // of the picture's edge, and how much the close-up is enlarged

Image image_of(const Scene& scene, const Accel& accel, const Studio& studio, int samples) {
    RenderSettings settings;
    settings.format = {studio.edge, studio.edge, samples, Raster::centres, 0};
    settings.threads = studio.threads;
    return render(scene, accel, settings).image;
}

struct Corner {
    int x = 0, y = 0;
};

/// Where a square of this edge has the largest sum, on a lattice of half its edge.
Corner worst_square(const ScalarImage& map, int edge) {
    Corner worst;
    double largest = -1;
    const int step = std::max(1, edge / 2);
    for (int top = 0; top + edge <= map.height(); top += step) {
        for (int left = 0; left + edge <= map.width(); left += step) {
            double sum = 0;
            for (int y = top; y < top + edge; ++y) {
                for (int x = left; x < left + edge; ++x) sum += map.at(x, y);
            }
            if (sum <= largest) continue;
            largest = sum;
            worst = {left, top};
        }
    }
    return worst;
}

}  // namespace

void antialiasing(const Studio& studio, Sheet& sheet) {
    const Scene scene = load_scene(aliased_scene);
    const ImageFormat format{studio.edge, studio.edge, 1, Raster::centres, 0};
    const auto accel = build(studio.catalogue, "bvh8", build_input(scene, format));
    const Image none = image_of(scene, *accel, studio, 1);
    const Image three = image_of(scene, *accel, studio, supersamples);
    const Image reference = image_of(scene, *accel, studio, reference_samples);

    const int part = std::max(1, studio.edge / close_up_share);
    const Corner worst = worst_square(difference_map(none, reference), part);
    const auto close_up = [&](const Image& image) {
        return magnified(cropped(image, worst.x, worst.y, part, part), close_up_share);
    };
    sheet.add(Picture{"antialiasing", "No antialiasing; 3 x 3 supersampling"},
              tiled(std::array{none, three}, 2));
    sheet.add(Picture{"antialiasing_close_up", "Close up: no antialiasing; 3 x 3 supersampling"},
              tiled(std::array{close_up(none), close_up(three)}, 2));

    const double of_none = compare_images(none, reference).rms;
    const double of_three = compare_images(three, reference).rms;
    // Nine samples without strata would be three times nearer than one; of an edge, strata do
    // better.
    constexpr double without_strata = 3;
    sheet.add(Check{
        "rms error of one sample over that of 3 x 3, at least " + short_number(without_strata), "",
        number_cell(of_none / of_three, 3), agrees_if(of_none >= without_strata * of_three)});
}

}  // namespace rayshoot::textbook

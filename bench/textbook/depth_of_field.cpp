#include "bench/textbook/figures.h"
#include "bench/textbook/pictures.h"
#include "bench/textbook/shots.h"

#include "data/nff.h"
#include "data/scenes.h"
#include "tracer/lens.h"

#include <cmath>
#include <numbers>
#include <sstream>

/// Depth of field: a small bright ball out of focus is a disc as large as the thin lens says.
namespace rayshoot::textbook {
namespace {

constexpr Lens lens{.focal_length = 0.5f, .f_stop = 2, .focus_distance = 6};
constexpr std::array<double, 5> depths{3, 4, 8, 12, 20};  // scene units
constexpr double angle = 8;                               // degrees, of the image's height
constexpr double ball_share = 0.008;                      // radius of the ball, of its depth
constexpr int size = 64;                                  // pixels; the discs cover up to 19

/// The image's height at distance 1.
double image_height() { return 2 * std::tan(angle * std::numbers::pi / 360); }

/// As a share of the image's height.
double blur_by_formula(double depth) {
    return circle_of_confusion(lens, depth) / (image_distance(lens) * image_height());
}

/// Alone before black; without lights a surface has half its colour.
Scene ball_at(double depth) {
    std::ostringstream text;
    text << "v from 0 0 0 at 0 0 -1 up 0 1 0 angle " << angle << " hither 0 resolution 1 1\n"
         << "f 2 2 2 1 0 1 0 1\n"
         << "s 0 0 " << -depth << ' ' << ball_share * depth << '\n';
    Scene scene = read_nff(text.str(), "a ball before a lens");
    scene.camera.lens = lens;
    return scene;
}

/// Of the light's places along x, pixels squared.
double variance(const Image& image) {
    double sum = 0, first = 0, second = 0;
    for (int x = 0; x < image.width(); ++x) {
        const double light = column_mean(image, x), place = x + 0.5;
        sum += light;
        first += light * place;
        second += light * place * place;
    }
    return second / sum - (first / sum) * (first / sum);
}

/// As a share of the image's height. A disc of diameter d has the variance d^2 / 16; the ball's own
/// disc and the pixel's square add theirs.
double blur_measured(const Studio& studio, double depth) {
    const Image image = shot(studio, ball_at(depth), "sampler=sobol,spp=256", size, size);
    const double ball = 2 * ball_share / image_height() * size;
    const double of_lens = variance(image) - ball * ball / 16 - 1.0 / 12;
    return 4 * std::sqrt(of_lens) / size;
}

}  // namespace

void depth_of_field(const Studio& studio, Sheet& sheet) {
    Scene scene = load_scene("gallery/depth_of_field");
    const Image blurred = gallery_shot(studio, scene, "sampler=sobol,spp=64");
    scene.camera.lens.reset();
    const Image sharp = gallery_shot(studio, scene, "sampler=sobol,spp=16");
    sheet.add(Picture{"depth_of_field", "A pinhole; a lens of f/2 with six blades"},
              tiled(std::array{sharp, blurred}, 2));

    Series formula{"thin lens", Series::Mark::line, {}};
    for (double depth = 2.5; depth <= 22; depth += 0.25)
        formula.values.push_back({depth, blur_by_formula(depth)});
    Series measured{"rendered", Series::Mark::points, {}};
    for (const double depth : depths) {
        const double expected = blur_by_formula(depth), ours = blur_measured(studio, depth);
        measured.values.push_back({depth, ours});
        sheet.add(Check{"disc of a ball at " + number_cell(depth, 3) + ", focus at " +
                            number_cell(double{lens.focus_distance}, 3) +
                            ", of the image's height, by the thin lens " + number_cell(expected, 4),
                        "", number_cell(ours, 4), agrees_within(ours, expected, 0.03)});
    }
    sheet.add(Chart{"circle_of_confusion",
                    "The disc that a point is blurred to",
                    "depth",
                    "diameter, of the image's height",
                    {formula, measured}});
}

}  // namespace rayshoot::textbook

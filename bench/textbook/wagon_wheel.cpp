#include "bench/textbook/figures.h"
#include "bench/textbook/pictures.h"
#include "bench/textbook/shots.h"

#include "data/scenes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

/// The wagon wheel: frames alias in time, and an open shutter is the filter against it.
namespace rayshoot::textbook {
namespace {

constexpr std::string_view wheel = "gallery/wagon_wheel:shutter=1";  // open all the time
constexpr int frame_count = 12, spokes = 12;
constexpr double step = 330.0 / frame_count;  // degrees a frame, clockwise
constexpr double spoke_angle = 360.0 / spokes;
constexpr double turn = 2 * std::numbers::pi;
constexpr std::string_view instant = "sampler=jitter,spp=16,close=0";
constexpr std::string_view open = "sampler=jitter,spp=36";
// The spokes between hub and rim, as shares of the image's height.
constexpr double inner = 0.09, outer = 0.36;

int frame_size(const Studio& studio) { return std::max(48, studio.edge / 3); }

std::vector<Image> frames(const Studio& studio, std::string_view settings, bool lit) {
    std::vector<Image> images;
    for (int frame = 0; frame < frame_count; ++frame) {
        Scene scene = load_frame(wheel, frame, frame_count);
        if (!lit) scene.lights.clear();  // a flat picture, which turns as a whole
        images.push_back(shot(studio, scene, settings, frame_size(studio), frame_size(studio)));
    }
    return images;
}

using Channel = double (*)(const vec3&);
double darkness(const vec3& colour) { return -double{colour.y}; }
double redness(const vec3& colour) { return double{colour.x} - double{colour.z}; }

/// How a ring of spokes varies with the angle, clockwise: its harmonic of so many periods a turn,
/// under a window that falls to 0 at the ring's edges. What is the background's is left out.
std::complex<double> harmonic(const Image& image, int periods, Channel channel) {
    const double middle = 0.5 * image.width();
    const double background = channel(image.at(0, 0));
    std::complex<double> sum = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double right = x + 0.5 - middle, down = y + 0.5 - middle;
            const double radius = std::hypot(right, down) / image.height();
            if (radius <= inner || radius >= outer) continue;
            const double window =
                std::pow(std::sin(turn / 2 * (radius - inner) / (outer - inner)), 2);
            sum += window * (channel(image.at(x, y)) - background) *
                   std::polar(1.0, -periods * std::atan2(down, right));
        }
    }
    return sum;
}

/// The mean turn from frame to frame that a pattern of so many periods seems to make: the nearest.
double apparent_step(const std::vector<Image>& images, int periods, Channel channel) {
    std::complex<double> turned = 0;
    for (std::size_t i = 1; i < images.size(); ++i)
        turned += harmonic(images[i], periods, channel) *
                  std::conj(harmonic(images[i - 1], periods, channel));
    return -std::arg(turned) / periods * 360 / turn;
}

double contrast(const std::vector<Image>& images) {
    double sum = 0;
    for (const Image& image : images) sum += std::abs(harmonic(image, spokes, darkness));
    return sum / static_cast<double>(images.size());
}

/// The mean of a wave of the spokes' period over the turn of one frame.
double factor_of_shutter() {
    const double half = turn / 2 * step / spoke_angle;
    return std::abs(std::sin(half) / half);
}

}  // namespace

void wagon_wheel(const Studio& studio, Sheet& sheet) {
    constexpr int columns = 6;
    sheet.add(
        Picture{"wagon_wheel_instant", "Twelve frames, each an instant: spokes turn backwards"},
        tiled(frames(studio, instant, true), columns));
    sheet.add(Picture{"wagon_wheel_open", "The shutter open from frame to frame: spokes melt"},
              tiled(frames(studio, open, true), columns));

    const std::vector<Image> sharp = frames(studio, instant, false);
    const std::vector<Image> blurred = frames(studio, open, false);
    const double seeming = step - spoke_angle;
    const double of_spokes = apparent_step(sharp, spokes, darkness);
    sheet.add(Check{
        "turn of the spokes from frame to frame as it seems, degrees: " + number_cell(seeming, 3),
        "", number_cell(of_spokes, 3), agrees_within(of_spokes, seeming, 0.05)});
    const double of_red = apparent_step(sharp, 1, redness);
    sheet.add(Check{"turn of the red spoke from frame to frame, degrees: " + number_cell(step, 3),
                    "", number_cell(of_red, 3), agrees_within(of_red, step, 0.02)});
    const double fallen = contrast(blurred) / contrast(sharp);
    sheet.add(Check{"contrast of the spokes with the shutter open, of that in an instant: " +
                        number_cell(factor_of_shutter(), 3),
                    "", number_cell(fallen, 3), agrees_within(fallen, factor_of_shutter(), 0.1)});
}

}  // namespace rayshoot::textbook

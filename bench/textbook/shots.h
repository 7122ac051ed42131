#pragma once

#include "bench/textbook/figures.h"
#include "bench/textbook/sheet.h"
#include "data/scene.h"
#include "tracer/camera.h"
#include "tracer/image.h"

#include <functional>
#include <string_view>

/// Scenes as figures take pictures of them, and what is read off the pictures.
namespace rayshoot::textbook {

/// An image through pixel centres; `settings` as apply_settings takes them.
Image shot(const Studio& studio, Scene scene, std::string_view settings, int width, int height);
/// Of the scenes of the gallery, `studio.edge` wide.
Image gallery_shot(const Studio& studio, const Scene& scene, std::string_view settings);

/// The camera ray through the middle of a pixel, of the lens's middle, when the shutter opens.
Ray middle_ray(const Scene& scene, int width, int height, int x, int y);

/// The mean of a row or of a column of an image of greys.
double row_mean(const Image& image, int y);
double column_mean(const Image& image, int x);

/// Points of a curve, by rising x.
using Profile = std::vector<std::array<double, 2>>;

/// Where the profile first crosses `level`, between its points by a straight line. Throws
/// std::runtime_error when it does not.
double crossing(const Profile& profile, double level);
/// From where an edge has risen, or fallen, to a tenth of its height 1 to where it has to nine.
double tenth_to_ninth_width(const Profile& profile);

/// The largest distance of the points from a curve.
double largest_departure(const Profile& profile, const std::function<double(double)>& curve);
/// `curve` at the points' places.
Profile at_places_of(const Profile& profile, const std::function<double(double)>& curve);

/// Whether `ours` is `expected` to a share of it.
Verdict agrees_within(double ours, double expected, double share);

}  // namespace rayshoot::textbook

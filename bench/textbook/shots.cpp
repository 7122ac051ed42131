#include "bench/textbook/shots.h"

#include "tracer/render.h"
#include "tracer/settings.h"

#include <cmath>
#include <stdexcept>

namespace rayshoot::textbook {

Image shot(const Studio& studio, Scene scene, std::string_view settings, int width, int height) {
    ImageSettings image;
    apply_settings(settings, image);
    apply_to(scene.camera, image);
    RenderSettings& how = image.render;
    how.format.width = width;
    how.format.height = height;
    how.format.raster = Raster::centres;
    how.threads = studio.threads;
    const auto accel = build(studio.catalogue, "bvh8", build_input(scene, how));
    return render(scene, *accel, how).image;
}

Image gallery_shot(const Studio& studio, const Scene& scene, std::string_view settings) {
    return shot(studio, scene, settings, studio.edge, studio.edge * 3 / 4);
}

Ray middle_ray(const Scene& scene, int width, int height, int x, int y) {
    const CameraRays rays(scene.camera, {width, height, 1, Raster::centres, 0});
    return rays.ray(x + 0.5, y + 0.5, {0, 0}, 0);
}

double row_mean(const Image& image, int y) {
    double sum = 0;
    for (int x = 0; x < image.width(); ++x) sum += double{image.at(x, y).x};
    return sum / image.width();
}

double column_mean(const Image& image, int x) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y) sum += double{image.at(x, y).x};
    return sum / image.height();
}

double crossing(const Profile& profile, double level) {
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const auto& [x0, y0] = profile[i - 1];
        const auto& [x1, y1] = profile[i];
        if ((y0 < level) == (y1 < level)) continue;
        return x0 + (x1 - x0) * (level - y0) / (y1 - y0);
    }
    throw std::runtime_error("a profile never crosses " + std::to_string(level));
}

double tenth_to_ninth_width(const Profile& profile) {
    return std::abs(crossing(profile, 0.9) - crossing(profile, 0.1));
}

double largest_departure(const Profile& profile, const std::function<double(double)>& curve) {
    double largest = 0;
    for (const auto& [x, y] : profile) largest = std::max(largest, std::abs(y - curve(x)));
    return largest;
}

Profile at_places_of(const Profile& profile, const std::function<double(double)>& curve) {
    Profile values;
    for (const auto& point : profile) values.push_back({point[0], curve(point[0])});
    return values;
}

Verdict agrees_within(double ours, double expected, double share) {
    return agrees_if(std::abs(ours - expected) <= share * std::abs(expected));
}

}  // namespace rayshoot::textbook

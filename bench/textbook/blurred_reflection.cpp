#include "bench/textbook/figures.h"
#include "bench/textbook/pictures.h"
#include "bench/textbook/shots.h"

#include "data/nff.h"
#include "data/scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

/// Blurred reflection: the mirrored image of an edge is as wide as the lobe says.
namespace rayshoot::textbook {
namespace {

constexpr std::array<int, 2> exponents{50, 400};  // of Phong's lobe
constexpr double wall = -4;                       // z of the white sheet
constexpr double degree = std::numbers::pi / 180;

/// A mirror on the floor, and behind it a white sheet over x < 0, before black. Without lights a
/// surface has half its colour, of which a mirror without diffuse reflection has none.
Scene mirrored_edge(int exponent) {
    std::ostringstream text;
    text << "v from 0 3 4 at 0 0 0 up 0 1 0 angle 34 hither 0 resolution 1 1\n"
            "surface nff colour 1 1 1 diffuse 0 specular 1 gloss "
         << exponent << "\np 4  -50 0 -3  -50 0 3  50 0 3  50 0 -3\n"
         << "f 2 2 2 1 0 1 0 1\n"
         << "p 4  -400 0 " << wall << "  0 0 " << wall << "  0 400 " << wall << "  -400 400 "
         << wall << '\n';
    return read_nff(text.str(), "an edge in a dull mirror");
}

/// The angle from the plane through the eye's point on the mirror and the edge to the mirrored ray,
/// in radians, more than 0 on the side of the sheet.
double angle_into_sheet(const Ray& ray) {
    const dvec3 origin(ray.origin), direction = normalised(dvec3(ray.direction));
    const dvec3 point = origin - direction * (origin.y / direction.y);
    const dvec3 mirrored(direction.x, -direction.y, direction.z);
    const dvec3 to_edge = dvec3(0, 0, wall) - point;
    return std::asin(dot(mirrored, normalised(cross(to_edge, dvec3(0, -1, 0)))));
}

/// The part of a lobe (n + 1) / 2 pi cos^n on the positive side of a plane that passes its axis at
/// `angle`: rings of equal probability, of each of which an arc lies there.
double share_of_lobe(int exponent, double angle) {
    constexpr int rings = 2000;
    double sum = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const double cosine = std::pow((ring + 0.5) / rings, 1.0 / (exponent + 1));
        const double tangent = std::sqrt(1 - cosine * cosine) / cosine;
        const double least = std::clamp(-std::tan(angle) / tangent, -1.0, 1.0);
        sum += std::acos(least) / std::numbers::pi;
    }
    return sum / rings;
}

/// The share of light against the angle in degrees, over the rows in the middle of the image.
Profile blurred_edge(const Studio& studio, int exponent) {
    const int size = studio.edge;
    const Scene scene = mirrored_edge(exponent);
    const Image image = shot(studio, scene, "sampler=sobol,spp=64", size, size);
    const int rows = size / 8, top = (size - rows) / 2;
    Profile profile;
    for (int x = 0; x < size; ++x) {
        double angle = 0, light = 0;
        for (int y = top; y < top + rows; ++y) {
            angle += angle_into_sheet(middle_ray(scene, size, size, x, y)) / rows;
            light += double{image.at(x, y).x} / rows;
        }
        profile.push_back({angle / degree, light});
    }
    std::ranges::sort(profile);
    return profile;
}

Image without_blur(const Studio& studio, Scene scene) {
    for (Material& material : scene.materials) material.gloss = 0;
    return gallery_shot(studio, scene, "sampler=sobol,spp=16");
}

}  // namespace

void blurred_reflection(const Studio& studio, Sheet& sheet) {
    const Scene scene = load_scene("gallery/blurred_reflection");
    sheet.add(
        Picture{"blurred_reflection", "Mirrors; lobes of exponents 400 and 60 on two of them"},
        tiled(std::array{without_blur(studio, scene),
                         gallery_shot(studio, scene, "sampler=sobol,spp=64")},
              2));

    Chart chart{"mirrored_edge",
                "The image of an edge in a dull mirror",
                "angle of the mirrored ray into the sheet, degrees",
                "light",
                {}};
    for (const int exponent : exponents) {
        const Profile measured = blurred_edge(studio, exponent);
        const Profile expected =
            at_places_of(measured, [&](double x) { return share_of_lobe(exponent, x * degree); });
        const double width = tenth_to_ninth_width(measured);
        const double by_lobe = tenth_to_ninth_width(expected);
        const std::string name = "exponent " + std::to_string(exponent);
        sheet.add(Check{name + ": degrees from a tenth to nine tenths of the light, by the lobe " +
                            number_cell(by_lobe, 4),
                        "", number_cell(width, 4), agrees_within(width, by_lobe, 0.04)});
        chart.series.push_back({name + ", lobe", Series::Mark::line, expected});
        chart.series.push_back({name + ", rendered", Series::Mark::points, measured});
    }
    sheet.add(std::move(chart));
}

}  // namespace rayshoot::textbook

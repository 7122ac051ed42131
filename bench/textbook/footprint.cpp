#include "bench/textbook/figures.h"
#include "bench/textbook/filtered.h"
#include "bench/textbook/pictures.h"
#include "tracer/colour_map.h"

#include <cmath>

/// "The footprint of the Hamming filter (r = 1.7)": the weights that a sample gives to the pixels
/// round it.
namespace rayshoot::textbook {
namespace {

constexpr double footprint_radius = 1.7;
constexpr double half_width = 2;             // pixels, of the picture
constexpr double published_integral = 2.70;  // w(0) = 1; in the table of sample sums

/// Of a picture with so many dots along an edge.
double dot_area(int edge) { return (2 * half_width / edge) * (2 * half_width / edge); }

}  // namespace

void footprint(const Studio& studio, Sheet& sheet) {
    const Filter filter({FilterKind::raised_cosine, footprint_radius});
    const Signal weights = [&](double x, double y) {
        const double scale = 2 * half_width / studio.edge;
        return filter(x * scale - half_width, y * scale - half_width);
    };
    const ScalarImage image = point_sampled(weights, studio.edge, studio.edge);
    sheet.add(Picture{"footprint", "The footprint on 4 x 4 pixels, its middle in theirs"},
              coloured(image, {}));
    Series profile{"weight", Series::Mark::line, {}};
    constexpr int points = 400;
    for (int i = 0; i <= points; ++i) {
        const double x = std::lerp(-half_width, half_width, static_cast<double>(i) / points);
        profile.values.push_back({x, filter(x, 0)});
    }
    sheet.add(Chart{"footprint_profile", "Through its middle", "pixels", "weight", {profile}});

    double volume = 0;
    for (const double weight : image.values()) volume += weight * dot_area(studio.edge);
    // The rule of dots: the weight falls to 0 with no slope, so no edge is cut.
    constexpr double last_digit = 0.005;
    sheet.add(Check{"integral, summed over the picture", short_number(published_integral, 3),
                    short_number(volume, 4),
                    agrees_if(std::abs(volume - published_integral) <= last_digit)});
    sheet.add(Check{"weight in the middle, and at 1.7", "1, 0",
                    short_number(filter(0, 0)) + ", " + short_number(filter(footprint_radius, 0)),
                    agrees_if(filter(0, 0) == 1 && filter(footprint_radius, 0) == 0)});
}

}  // namespace rayshoot::textbook

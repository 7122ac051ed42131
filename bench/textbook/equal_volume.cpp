#include "tracer/filter/regions.h"

#include "bench/textbook/figures.h"
#include "bench/textbook/filtered.h"
#include "tracer/colour_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// "4 quadrants, four annuli => 16 regions. Integral of filter = 1/16 for each region. UDOO:
/// compute the radii of the annuli and the normalization constant k."
namespace rayshoot::textbook {
namespace {

constexpr int annuli = 4, quadrants = 4;
constexpr double filter_radius = 1.7;

/// Integral of the filter over a region by the midpoint rule in polar coordinates: knows nothing of
/// how the radii were found.
double volume(const Filter& filter, const Region& region) {
    constexpr int cells = 1000;  // error below 10^-6
    double sum = 0;
    const double step = (region.outer - region.inner) / cells;
    for (int i = 0; i < cells; ++i) {
        const double r = region.inner + (i + 0.5) * step;
        sum += filter.profile(r) * r * step;
    }
    return sum * (region.to - region.from);
}

bool is_inside(const Region& region, double r, double azimuth) {
    return r >= region.inner && r < region.outer && azimuth >= region.from && azimuth < region.to;
}

/// Each region in a colour of its own, as bright as the filter is high.
Image picture_of(const Filter& filter, const std::vector<Region>& regions, int edge) {
    Image image(edge, edge);
    for (int row = 0; row < edge; ++row) {
        for (int column = 0; column < edge; ++column) {
            const double x = filter_radius * (2 * (column + 0.5) / edge - 1);
            const double y = filter_radius * (1 - 2 * (row + 0.5) / edge);
            const double turn = std::atan2(y, x);
            const double azimuth = turn < 0 ? turn + 2 * std::numbers::pi : turn;
            const auto region = std::ranges::find_if(
                regions, [&](const Region& r) { return is_inside(r, std::hypot(x, y), azimuth); });
            if (region == regions.end()) continue;
            // Steps of 7 out of 16: neighbours get colours far apart.
            const auto colour = static_cast<int>(region - regions.begin()) * 7 % 16;
            image.at(column, row) =
                map_colour((colour + 0.5) / 16) * static_cast<float>(std::sqrt(filter(x, y)));
        }
    }
    return image;
}

std::string radii_text(const std::vector<double>& radii) {
    std::string text;
    for (const double radius : radii) text += (text.empty() ? "" : ", ") + number_cell(radius, 6);
    return text;
}

}  // namespace

void equal_volume(const Studio& studio, Sheet& sheet) {
    const Filter filter({FilterKind::raised_cosine, filter_radius});
    const std::vector<Region> regions = equal_volume_regions(filter, annuli, quadrants);
    sheet.add(Picture{"equal_volume", "16 regions of equal volume, as bright as the filter's root"},
              picture_of(filter, regions, studio.edge));

    const double normalisation = raised_cosine_normalisation(filter_radius);
    double least = 1, greatest = 0, sum = 0;
    for (const Region& region : regions) {
        // Ours is (1 + cos) / 2, the book's k (1 + cos).
        const double share = 2 * normalisation * volume(filter, region);
        least = std::min(least, share);
        greatest = std::max(greatest, share);
        sum += share;
    }
    constexpr double accuracy = 1e-6;
    const double each = 1.0 / (annuli * quadrants);
    sheet.add(Check{
        "integral of each region, within " + short_number(accuracy), "1/16",
        number_cell(least, 7) + " to " + number_cell(greatest, 7),
        agrees_if(regions.size() == 16 && least > each - accuracy && greatest < each + accuracy)});
    sheet.add(Check{"total integral, with k = " + number_cell(normalisation, 6), "1",
                    number_cell(sum, 7), agrees_if(std::abs(sum - 1) < accuracy)});
    const std::vector<double> radii = equal_volume_radii(FilterKind::raised_cosine, annuli);
    const double spacing_at_least = radii[0], spacing_at_most = 1 - radii[2];
    sheet.add(Check{"outer radii of the annuli over the filter's", "not equally spaced",
                    radii_text(radii), agrees_if(spacing_at_most > 1.2 * spacing_at_least)});
    const double factor = normalisation * filter_radius * filter_radius;
    const double derived = 1 / (std::numbers::pi - 4 / std::numbers::pi);
    sheet.add(Check{"k times the radius squared, 1 / (pi - 4 / pi) = " + number_cell(derived, 7),
                    "left to the reader", number_cell(factor, 7),
                    agrees_if(std::abs(factor - derived) < 1e-12)});
}

}  // namespace rayshoot::textbook

#include "tracer/filter/regions.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tracer/filter/shape.h"

namespace rayshoot {
namespace {

void require_disc(FilterKind kind, int annuli, int sectors) {
    if (shape::separable(kind)) {
        throw std::invalid_argument("regions of " + std::string(name(kind)) +
                                    ": its support is a square; take cone, hann or gaussian");
    }
    if (annuli < 1 || sectors < 1) {
        throw std::invalid_argument(std::to_string(annuli) + " annuli, " + std::to_string(sectors) +
                                    " sectors: must be 1 or more of each");
    }
}

/// `radii` are outer ones / R.
std::vector<Region> cut(const std::vector<double>& radii, double radius, int sectors) {
    std::vector<Region> regions;
    const double angle = 2 * std::numbers::pi / sectors;
    double inner = 0;
    for (const double outer : radii) {
        for (int sector = 0; sector < sectors; ++sector) {
            regions.push_back(
                {radius * inner, radius * outer, angle * sector, angle * (sector + 1)});
        }
        inner = outer;
    }
    return regions;
}

}  // namespace

/// "UDOO: compute the radii of the annuli." The share of the volume within r is the integral of
/// 2 pi r w(r) from 0 to r, over the whole volume (shape.cpp); the i-th radius is where it is i /
/// n. Four annuli of the raised cosine end at 0.286936, 0.433572, 0.585817 and 1 times R: not
/// equally spaced, as the rings grow with r while the weight falls.
std::vector<double> equal_volume_radii(FilterKind kind, int annuli) {
    require_disc(kind, annuli, 1);
    std::vector<double> radii;
    for (int i = 1; i < annuli; ++i) {
        radii.push_back(shape::quantile(kind, static_cast<double>(i) / annuli));
    }
    radii.push_back(1);
    return radii;
}

std::vector<Region> equal_volume_regions(const Filter& filter, int annuli, int sectors) {
    const auto [kind, radius] = filter.settings();
    require_disc(kind, annuli, sectors);
    return cut(equal_volume_radii(kind, annuli), radius, sectors);
}

std::vector<Region> equal_area_regions(const Filter& filter, int annuli, int sectors) {
    const auto [kind, radius] = filter.settings();
    require_disc(kind, annuli, sectors);
    std::vector<double> radii;
    for (int i = 1; i <= annuli; ++i) radii.push_back(std::sqrt(static_cast<double>(i) / annuli));
    return cut(radii, radius, sectors);
}

/// "... and the normalization constant k": the integral of 2 pi r (1 + cos(pi r / R)) from 0 to R
/// is R^2 (pi - 4 / pi), so k is 0.5352307 / R^2.
double raised_cosine_normalisation(double radius) {
    return 1 / ((std::numbers::pi - 4 / std::numbers::pi) * radius * radius);
}

}  // namespace rayshoot

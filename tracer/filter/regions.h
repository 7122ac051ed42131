#pragma once

#include <vector>

#include "tracer/filter/filter.h"

/// A filter's disc cut into annuli and sectors: the strata of Filter::importance and
/// Filter::uniform. All functions throw std::invalid_argument for a filter on a square, and for
/// less than one annulus or sector.
namespace rayshoot {

/// A piece of a disc: `inner` <= r < `outer` in pixels, `from` <= azimuth < `to` in radians.
struct Region {
    double inner = 0, outer = 0;
    double from = 0, to = 0;
};

/// Outer radii / R of annuli with equal volume below the filter; the last is 1.
std::vector<double> equal_volume_radii(FilterKind kind, int annuli);

/// Pieces with equal volume below the filter, annulus by annulus from the middle. Offsets of
/// Filter::importance lie in piece (i, q) for pairs with u in [i, i + 1) / annuli and v in
/// [q, q + 1) / sectors.
std::vector<Region> equal_volume_regions(const Filter& filter, int annuli, int sectors);
/// Pieces of equal area; likewise for Filter::uniform.
std::vector<Region> equal_area_regions(const Filter& filter, int annuli, int sectors);

/// The factor k that makes the integral of k (1 + cos(pi r / R)) 1: the textbook's normalisation
/// constant of the raised cosine.
double raised_cosine_normalisation(double radius);

}  // namespace rayshoot

#pragma once

#include <span>

#include "tracer/filter/filter.h"

/// "Variation of sample sum with sample centre": what a splatted sample gives to all pixels
/// together, which would be 1 wherever it lies if the sum over pixels were the filter's integral.
namespace rayshoot {

/// Weights, over the filter's integral, of all pixels for a sample at (x, y) from the corner of its
/// cell, in [0, 1].
double sample_sum(const Filter& filter, double x, double y);

/// A sum, and where in the cell it is: 0 <= x <= y <= 1/2 by symmetry, (0, 0) being the corner of
/// the cell and (1/2, 1/2) the middle of the pixel.
struct SampleSumAt {
    double sum = 1, x = 0, y = 0;
};

/// Over all places in the cell. The mean is exactly 1; `ripple` is the root mean square deviation
/// from it.
struct SampleSums {
    SampleSumAt least, greatest;
    double ripple = 0;
};
/// least and greatest to 10^-7, ripple to 10^-5 (10^-3 for box and gaussian, which step).
SampleSums sample_sums(const Filter& filter);

/// An entry of the textbook's table, with two decimals; `misprint` if the true value rounds to
/// another number, for a reason that README.md gives.
struct PrintedValue {
    double value = 0;
    bool misprint = false;
};
struct PrintedSampleSums {
    FilterKind kind = FilterKind::raised_cosine;
    double radius = 0;
    PrintedValue integral, least, greatest;
};
/// The six rows of the table, in its order.
std::span<const PrintedSampleSums> printed_sample_sums();

}  // namespace rayshoot

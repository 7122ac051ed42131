#pragma once

#include "tracer/filter/filter.h"

/// Filters of radius 1: weights, integrals and inverse distributions over s in [0, 1], which is the
/// distance from the middle, on a square along one axis.
namespace rayshoot::shape {

bool separable(FilterKind kind);

/// The weight at s; 1 at 0, but 8/9 for mitchell. Some step to 0 beyond s = 1.
double weight(FilterKind kind, double s);

/// Of the weight, and of its magnitude: over the disc, or over [-1, 1] of one axis.
struct Integral {
    double signed_part, magnitude;
};
Integral integral(FilterKind kind);

/// The share of the magnitude's integral that lies within s.
double cumulative(FilterKind kind, double s);

/// The inverse of cumulative, for u in [0, 1]: it is off by less than 10^-12 in u.
double quantile(FilterKind kind, double u);

}  // namespace rayshoot::shape

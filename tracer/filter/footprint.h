#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tracer/filter/filter.h"

/// The footprint of a splatted sample (Smits): the filter, centred on the sample, weighs the
/// middles of the pixels that it covers.
namespace rayshoot {

/// Pixels that a sample reaches, as offsets from the cell it is in.
struct Cover {
    int left = 0, top = 0;
    int columns = 0, rows = 0;
};

/// A filter's weights over its integral, from a table.
class Footprint {
public:
    explicit Footprint(const Filter& filter);

    /// How far from its cell a sample reaches, in pixels.
    int border() const { return border_; }
    /// Most weights that weigh() writes.
    std::size_t largest() const;

    /// For a sample at (x, y) from the top left corner of its cell, in [0, 1]: the pixels it covers
    /// and, row by row, their weights, each within `table_error` / integral of the filter's.
    Cover weigh(double x, double y, std::span<float> weights) const;
    static constexpr double table_error = 2e-6;  ///< where the filter is 1 in the middle

private:
    /// The filter between two entries of the table: value + slope * (place - entry).
    struct Piece {
        float value, slope;
    };
    /// Over distances in units of R / pieces; 0 beyond the filter's edge.
    float looked_up(float place) const;
    void weigh_disc(const Cover& cover, double x, double y, float* weights) const;
    void weigh_square(const Cover& cover, double x, double y, float* weights) const;

    double radius_;
    bool separable_;
    int border_;
    std::vector<Piece> table_;
};

}  // namespace rayshoot

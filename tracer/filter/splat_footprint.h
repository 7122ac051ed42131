#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tracer/filter/filter.h"

/// The footprint of a splatted sample (Smits): the filter, centred on the sample, weighs the
/// middles of the pixels that it covers.
namespace rayshoot {

/// A filter's weights over its integral: on a disc by a polynomial in r, on a square by a table for
/// each axis.
class SplatFootprint {
public:
    explicit SplatFootprint(const Filter& filter);

    /// Edge of the square of pixels around every sample that has all that it reaches.
    int edge() const { return edge_; }
    /// How far from its cell a sample reaches, in pixels.
    int border() const { return border_; }
    /// What weigh() needs to write to.
    std::size_t room() const;

    /// Where the square begins, as an offset from the sample's cell.
    struct Corner {
        int left = 0, top = 0;
    };
    /// For a sample at (x, y) from the top left corner of its cell, in [0, 1): the square and, row
    /// by row, edge x edge weights, each within largest_error / integral of the filter's. (Where a
    /// gaussian ends in a step, at the edge of its disc, a float tells the two sides apart.)
    Corner weigh(double x, double y, std::span<float> weights) const;
    static constexpr double largest_error = 2e-6;  ///< where the filter is 1 in the middle

private:
    template <class Edge>
    void weigh(Edge edge, double x, double y, float* weights) const;
    template <class Edge>
    void weigh_disc(Edge edge, float x, float y, float* weights) const;
    template <class Edge>
    void weigh_square(Edge edge, double x, double y, float* weights) const;

    static constexpr std::size_t terms = 13;  ///< the gaussian needs them, others fewer

    double radius_;
    bool separable_;
    int edge_, border_;
    std::array<float, terms> disc_{};     ///< Chebyshev coefficients over 2 r / R - 1
    std::vector<float> values_, slopes_;  ///< of a square's axis, from the middle outwards
};

}  // namespace rayshoot

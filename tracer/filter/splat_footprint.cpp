#include "tracer/filter/splat_footprint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "tracer/filter/shape.h"

namespace rayshoot {
namespace {

/// Of the table. Linear in each piece: off by at most max |w''| / (8 pieces^2), and w'' over |x| /
/// R is 16 for mitchell, the most.
constexpr int pieces = 2048;
constexpr float last_place = pieces * (1 - 0x1p-24f);

constexpr int largest_edge = 2 * static_cast<int>(largest_radius);
/// Of one row or column of the square.
using Line = std::array<float, largest_edge>;

/// Weights are computed so many at a time, in vectors.
constexpr int block = 16;
constexpr int in_blocks(int count) { return (count + block - 1) / block * block; }

/// Interpolates f over [0, 1] at the Chebyshev nodes; coefficients over 2 s - 1.
template <std::size_t terms, class F>
std::array<float, terms> chebyshev_coefficients(F&& f) {
    std::array<float, terms> coefficients;
    for (std::size_t k = 0; k < terms; ++k) {
        double sum = 0;
        for (std::size_t node = 0; node < terms; ++node) {
            const double angle = std::numbers::pi * (static_cast<double>(node) + 0.5) / terms;
            sum += f((std::cos(angle) + 1) / 2) * std::cos(static_cast<double>(k) * angle);
        }
        coefficients[k] = static_cast<float>((k == 0 ? 1 : 2) * sum / terms);
    }
    return coefficients;
}

/// Clenshaw 1955.
template <std::size_t terms>
float chebyshev_sum(const std::array<float, terms>& coefficients, float z) {
    float one = 0, two = 0;
    for (std::size_t k = terms - 1; k > 0; --k) {
        const float next = coefficients[k] + (2 * z * one - two);
        two = one;
        one = next;
    }
    return coefficients[0] + (z * one - two);
}

}  // namespace

SplatFootprint::SplatFootprint(const Filter& filter)
    : radius_(filter.reach()),
      separable_(filter.separable()),
      edge_(static_cast<int>(std::ceil(2 * filter.reach()))),
      border_(static_cast<int>(std::ceil(filter.reach() - 0.5))) {
    const double whole =  // along an axis, or over the disc
        separable_ ? std::sqrt(filter.integral()) : filter.integral();
    const auto weight = [&](double s) { return shape::weight(filter.settings().kind, s) / whole; };
    if (!separable_) {
        disc_ = chebyshev_coefficients<terms>(weight);
        return;
    }
    for (int piece = 0; piece < pieces; ++piece) {
        const double from = weight(1.0 * piece / pieces), to = weight((piece + 1.0) / pieces);
        values_.push_back(static_cast<float>(from));
        slopes_.push_back(static_cast<float>(to - from));
    }
}

std::size_t SplatFootprint::room() const {
    return static_cast<std::size_t>(in_blocks(edge_ * edge_));
}

/// (x, y) is from the middle of the first pixel, here and below. An Edge is a number, or a type
/// that has it as its value: then all loops have constant lengths.
template <class Edge>
void SplatFootprint::weigh_disc(Edge edge, float x, float y, float* weights) const {
    const auto scale = static_cast<float>(1 / radius_);
    Line squares;
    for (int column = 0; column < edge; ++column) {
        const float across = (x - static_cast<float>(column)) * scale;
        squares[static_cast<std::size_t>(column)] = across * across;
    }
    std::array<float, in_blocks(largest_edge * largest_edge)> distances;  // squares of r / R
    float* distance = distances.data();
    for (int row = 0; row < edge; ++row) {
        const float down = (y - static_cast<float>(row)) * scale;
        for (int column = 0; column < edge; ++column) {
            *distance++ = squares[static_cast<std::size_t>(column)] + down * down;
        }
    }
    std::fill(distance, distances.data() + in_blocks(edge * edge), 1.0f);
    const auto disc = disc_;  // which weights may not lie in
    for (int i = 0; i < in_blocks(edge * edge); ++i) {
        const float square = distances[static_cast<std::size_t>(i)];
        const float weight = std::max(chebyshev_sum(disc, 2 * std::sqrt(square) - 1), 0.0f);
        weights[i] = square < 1 ? weight : 0;
    }
}

template <class Edge>
void SplatFootprint::weigh_square(Edge edge, double x, double y, float* weights) const {
    const double scale = pieces / radius_;
    const auto along_axis = [this, scale](double at) {
        const float place = std::min(static_cast<float>(std::abs(at) * scale), last_place);
        const auto piece = static_cast<std::size_t>(static_cast<int>(place));
        const float weight = values_[piece] + slopes_[piece] * (place - static_cast<float>(piece));
        return at < -radius_ ? 0 : weight;  // the last pixel, if the filter is not so wide here
    };
    Line across;
    for (int column = 0; column < edge; ++column) {
        across[static_cast<std::size_t>(column)] = along_axis(x - column);
    }
    for (int row = 0; row < edge; ++row) {
        const float down = along_axis(y - row);
        for (int column = 0; column < edge; ++column) {
            *weights++ = across[static_cast<std::size_t>(column)] * down;
        }
    }
}

template <class Edge>
void SplatFootprint::weigh(Edge edge, double x, double y, float* weights) const {
    if (separable_) {
        weigh_square(edge, x, y, weights);
    } else {
        weigh_disc(edge, static_cast<float>(x), static_cast<float>(y), weights);
    }
}

SplatFootprint::Corner SplatFootprint::weigh(double x, double y, std::span<float> weights) const {
    // The first pixel whose middle is less than R to the left of the sample, or above it.
    const auto first = [this](double at) {
        return static_cast<int>(std::floor(at - 0.5 - radius_)) + 1;
    };
    const Corner corner{first(x), first(y)};
    const double right = x - 0.5 - corner.left, down = y - 0.5 - corner.top;
    switch (edge_) {  // the usual radii, up to 2
        case 3:
            weigh(std::integral_constant<int, 3>(), right, down, weights.data());
            break;
        case 4:
            weigh(std::integral_constant<int, 4>(), right, down, weights.data());
            break;
        default:
            weigh(edge_, right, down, weights.data());
    }
    return corner;
}

}  // namespace rayshoot

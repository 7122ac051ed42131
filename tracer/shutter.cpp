#include "tracer/shutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace rayshoot {
namespace {

constexpr std::array<std::pair<std::string_view, ShutterWeight>, 3> weights{
    {{"box", ShutterWeight::box},
     {"triangle", ShutterWeight::triangle},
     {"raised_cosine", ShutterWeight::raised_cosine}}};

constexpr double turn = 2 * std::numbers::pi;

double triangle_distribution(double t) { return t < 0.5 ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t); }

double triangle_quantile(double u) {
    return u < 0.5 ? std::sqrt(u / 2) : 1 - std::sqrt((1 - u) / 2);
}

double cosine_distribution(double t) { return t - std::sin(turn * t) / turn; }

/// Kepler's equation for a parabolic orbit's limit, E - sin E = M: Newton's method for the half
/// below 1/2, where the function is convex, from a start above the root, so that it falls
/// monotonically.
double cosine_quantile(double u) {
    if (u > 0.5) return 1 - cosine_quantile(1 - u);
    if (u <= 0) return 0;
    constexpr int most_steps = 60;  // quadratic: a handful; the bound guards the loop
    double t = std::min(0.5, std::cbrt(6 * u / (turn * turn)) * 1.2);  // t - ... = (2 pi)^2 t^3 / 6
    for (int step = 0; step < most_steps; ++step) {
        const double next = t - (cosine_distribution(t) - u) / (1 - std::cos(turn * t));
        if (!(next < t)) break;
        t = std::max(next, 0.0);
    }
    return t;
}

}  // namespace

ShutterWeight shutter_weight(std::string_view wanted) {
    std::string known;
    for (const auto& [name, weight] : weights) {
        if (name == wanted) return weight;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    throw std::invalid_argument("'" + std::string(wanted) +
                                "' is no weight of a shutter; there are " + known);
}

std::string_view name(ShutterWeight weight) {
    return weights[static_cast<std::size_t>(weight)].first;
}

float Shutter::time(float u) const {
    double t = u;
    if (weight == ShutterWeight::triangle) t = triangle_quantile(t);
    if (weight == ShutterWeight::raised_cosine) t = cosine_quantile(t);
    return static_cast<float>(open + (double{close} - open) * t);
}

double Shutter::distribution(double time) const {
    const double t = std::clamp((time - open) / (double{close} - open), 0.0, 1.0);
    if (weight == ShutterWeight::triangle) return triangle_distribution(t);
    if (weight == ShutterWeight::raised_cosine) return cosine_distribution(t);
    return t;
}

void require_valid(const Shutter& shutter) {
    if (shutter.open >= 0 && shutter.open <= shutter.close && shutter.close <= 1) return;
    throw std::invalid_argument("the shutter opens at " + std::to_string(shutter.open) +
                                " and closes at " + std::to_string(shutter.close) +
                                "; give ray times with 0 <= open <= close <= 1");
}

}  // namespace rayshoot

#include "tracer/filter/filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tracer/filter/shape.h"

namespace rayshoot {
namespace {

/// The side of an axis that u in [0, 1) is on, and how far out: -1 to 1 for a quantile of |2u - 1|.
double both_sides(FilterKind kind, double u) {
    const double side = 2 * u - 1;
    return std::copysign(shape::quantile(kind, std::abs(side)), side);
}

Filter::Offset polar(double r, double turns) {
    const double azimuth = 2 * std::numbers::pi * turns;
    return {r * std::cos(azimuth), r * std::sin(azimuth), 1};
}

}  // namespace

std::string_view name(FilterKind kind) { return filter_names[static_cast<std::size_t>(kind)]; }

FilterKind filter_kind(std::string_view name) {
    if (name == "hamming") return FilterKind::raised_cosine;
    const auto found = std::ranges::find(filter_names, name);
    if (found != filter_names.end()) return static_cast<FilterKind>(found - filter_names.begin());
    std::string all;
    for (const std::string_view known : filter_names) all += " " + std::string(known);
    throw std::invalid_argument("filter '" + std::string(name) + "': must be one of" + all);
}

Filter::Filter(const FilterSettings& settings) : settings_(settings) {
    const double radius = settings.radius;
    if (!(radius >= smallest_radius && radius <= largest_radius)) {
        throw std::invalid_argument("filter radius " + std::to_string(radius) +
                                    ": must be from 0.5 to 16 pixels");
    }
    const shape::Integral unit = shape::integral(settings.kind);
    const double power = separable() ? 2 : 1;  // of two axes, or of the disc
    integral_ = std::pow(unit.signed_part, power) * radius * radius;
    of_magnitude_ = std::pow(unit.magnitude, power) * radius * radius;
}

bool Filter::separable() const { return shape::separable(settings_.kind); }

double Filter::profile(double distance) const {
    const double radius = settings_.radius, at = std::abs(distance);
    return at < radius ? shape::weight(settings_.kind, at / radius) : 0;
}

double Filter::operator()(double x, double y) const {
    const double radius = settings_.radius;
    if (!separable()) return profile(std::hypot(x, y));
    const auto along_axis = [this, radius](double at) {
        const bool inside = at >= -radius && at < radius;
        return inside ? shape::weight(settings_.kind, std::abs(at) / radius) : 0;
    };
    return along_axis(x) * along_axis(y);
}

Filter::Offset Filter::by_quantiles(Pair pair) const {
    const double radius = settings_.radius;
    const FilterKind kind = settings_.kind;
    if (!separable()) return polar(radius * shape::quantile(kind, pair.u), pair.v);
    Offset offset{radius * both_sides(kind, pair.u), radius * both_sides(kind, pair.v), 1};
    if (negative_lobes()) {
        const double sign = profile(offset.x) * profile(offset.y) < 0 ? -1 : 1;
        offset.weight = sign * of_magnitude_ / integral_;
    }
    return offset;
}

Filter::Offset Filter::uniform(Pair pair) const {
    const double radius = settings_.radius;
    Offset offset;
    double area = 4 * radius * radius;
    if (separable()) {
        offset = {radius * (2.0 * pair.u - 1), radius * (2.0 * pair.v - 1), 1};
    } else {
        offset = polar(radius * std::sqrt(double{pair.u}), pair.v);
        area = std::numbers::pi * radius * radius;
    }
    offset.weight = (*this)(offset.x, offset.y) * area / integral_;
    return offset;
}

}  // namespace rayshoot

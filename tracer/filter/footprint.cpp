#include "tracer/filter/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/filter/shape.h"

namespace rayshoot {
namespace {

/// Linear between entries: off by at most max |w''| / (8 pieces^2). w'' over r / R is 16 for
/// mitchell, the most: 5 * 10^-7 along each axis. Places in float add about as much.
constexpr int pieces = 2048;
constexpr float last_place = pieces * (1 - 0x1p-24f);

constexpr int largest_columns = 2 * static_cast<int>(largest_radius) + 1;

}  // namespace

Footprint::Footprint(const Filter& filter)
    : radius_(filter.settings().radius),
      separable_(filter.separable()),
      border_(static_cast<int>(std::ceil(filter.reach() - 0.5))) {
    const double scale =
        1 / (separable_ ? std::sqrt(filter.integral()) : filter.integral());  // per axis, or both
    const auto value = [&](int entry) {
        return scale * shape::weight(filter.settings().kind, 1.0 * entry / pieces);
    };
    for (int entry = 0; entry < pieces; ++entry) {
        table_.push_back({static_cast<float>(value(entry)),
                          static_cast<float>(value(entry + 1) - value(entry))});
    }
    table_.push_back({0, 0});
}

std::size_t Footprint::largest() const {
    const auto columns = static_cast<std::size_t>(2 * border_ + 1);
    return columns * columns;
}

float Footprint::looked_up(float place) const {
    const float entry = std::min(std::floor(place), static_cast<float>(pieces));
    const Piece piece = table_[static_cast<std::size_t>(entry)];
    return piece.value + piece.slope * (place - entry);
}

void Footprint::weigh_disc(const Cover& cover, double x, double y, float* weights) const {
    const auto scale = static_cast<float>(pieces / radius_);
    for (int row = 0; row < cover.rows; ++row) {
        const auto down = static_cast<float>(y - 0.5 - (cover.top + row));
        for (int column = 0; column < cover.columns; ++column) {
            const auto right = static_cast<float>(x - 0.5 - (cover.left + column));
            *weights++ = looked_up(scale * std::sqrt(right * right + down * down));
        }
    }
}

void Footprint::weigh_square(const Cover& cover, double x, double y, float* weights) const {
    const auto scale = static_cast<float>(pieces / radius_);
    const auto along_axis = [&](double at) {
        return looked_up(std::min(scale * static_cast<float>(std::abs(at)), last_place));
    };
    std::array<float, largest_columns> across;
    for (int column = 0; column < cover.columns; ++column) {
        across[static_cast<std::size_t>(column)] = along_axis(x - 0.5 - (cover.left + column));
    }
    for (int row = 0; row < cover.rows; ++row) {
        const float down = along_axis(y - 0.5 - (cover.top + row));
        for (int column = 0; column < cover.columns; ++column) {
            *weights++ = across[static_cast<std::size_t>(column)] * down;
        }
    }
}

Cover Footprint::weigh(double x, double y, std::span<float> weights) const {
    // Those whose middle is at most R to the right of the sample, and less than R to the left.
    const auto first = [this](double at) {
        return static_cast<int>(std::floor(at - 0.5 - radius_)) + 1;
    };
    const auto count = [&](double at) {
        return static_cast<int>(std::floor(at - 0.5 + radius_)) - first(at) + 1;
    };
    const Cover cover{first(x), first(y), count(x), count(y)};
    if (separable_) {
        weigh_square(cover, x, y, weights.data());
    } else {
        weigh_disc(cover, x, y, weights.data());
    }
    return cover;
}

}  // namespace rayshoot

#include "bench/textbook/filtered.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace rayshoot::textbook {
namespace {

struct Tap {
    std::ptrdiff_t offset;  ///< in the lattice, from the first point right of and below the middle
    double weight;
};

/// The signal on a lattice that reaches `border` pixels beyond the image.
struct Lattice {
    int width, height;
    std::vector<double> values;

    Lattice(const Signal& signal, int pixels_across, int pixels_down, int border, int subdivisions)
        : width((pixels_across + 2 * border) * subdivisions),
          height((pixels_down + 2 * border) * subdivisions) {
        values.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        const auto place = [&](int i) { return (i + 0.5) / subdivisions - border; };
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) values.push_back(signal(place(x), place(y)));
        }
    }
};

/// The lattice points under the filter; weights sum to 1.
std::vector<Tap> taps_of(const Filter& filter, int subdivisions, int lattice_width) {
    std::vector<Tap> taps;
    double sum = 0;
    const int reach = static_cast<int>(std::ceil(filter.reach() * subdivisions));
    for (int y = -reach; y < reach; ++y) {
        for (int x = -reach; x < reach; ++x) {
            const double weight = filter((x + 0.5) / subdivisions, (y + 0.5) / subdivisions);
            if (weight == 0) continue;
            taps.push_back({std::ptrdiff_t{y} * lattice_width + x, weight});
            sum += weight;
        }
    }
    for (Tap& tap : taps) tap.weight /= sum;
    return taps;
}

constexpr int quadrature_cells = 512;  // of the midpoint rule: 10^-5 of waves up to 2 cycles

double hankel(const Filter& filter, double frequency) {
    double sum = 0, whole = 0;
    for (int i = 0; i < quadrature_cells; ++i) {
        const double r = filter.reach() * (i + 0.5) / quadrature_cells;
        const double weight = filter.profile(r) * r;
        sum += weight * std::cyl_bessel_j(0, 2 * std::numbers::pi * frequency * r);
        whole += weight;
    }
    return sum / whole;
}

double cosine_transform(const Filter& filter, double frequency) {
    double sum = 0, whole = 0;
    for (int i = 0; i < quadrature_cells; ++i) {
        const double x = filter.reach() * (i + 0.5) / quadrature_cells;
        sum += filter.profile(x) * std::cos(2 * std::numbers::pi * frequency * x);
        whole += filter.profile(x);
    }
    return sum / whole;
}

}  // namespace

ScalarImage point_sampled(const Signal& signal, int width, int height) {
    ScalarImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image.at(x, y) = signal(x + 0.5, y + 0.5);
    }
    return image;
}

ScalarImage filtered(const Signal& signal, const Filter& filter, int width, int height,
                     int subdivisions) {
    assert(subdivisions > 0 && subdivisions % 2 == 0);
    const int border = static_cast<int>(std::ceil(filter.reach()));
    const Lattice lattice(signal, width, height, border, subdivisions);
    const std::vector<Tap> taps = taps_of(filter, subdivisions, lattice.width);
    ScalarImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::ptrdiff_t row = (y + border) * subdivisions + subdivisions / 2;
            const std::ptrdiff_t column = (x + border) * subdivisions + subdivisions / 2;
            const double* middle = lattice.values.data() + row * lattice.width + column;
            double sum = 0;
            for (const Tap& tap : taps) sum += tap.weight * middle[tap.offset];
            image.at(x, y) = sum;
        }
    }
    return image;
}

double response(const Filter& filter, double along_x, double along_y) {
    if (filter.separable()) {
        return cosine_transform(filter, along_x) * cosine_transform(filter, along_y);
    }
    return hankel(filter, std::hypot(along_x, along_y));
}

}  // namespace rayshoot::textbook

#include "tracer/filter/sample_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace rayshoot {
namespace {

/// The best place of a fine grid round the best so far, again and again. The sum has creases where
/// a pixel enters the filter's reach, and its least value may lie in one.
SampleSumAt refined(const Filter& filter, SampleSumAt best, double step, auto better) {
    constexpr double shortest_step = 1e-9;
    constexpr int fineness = 5;  // points a step; twice as many either way
    for (; step > shortest_step; step /= 4) {
        const SampleSumAt middle = best;
        for (int right = -2 * fineness; right <= 2 * fineness; ++right) {
            for (int down = -2 * fineness; down <= 2 * fineness; ++down) {
                const double x = std::clamp(middle.x + right * step / fineness, 0.0, 0.5);
                const double y = std::clamp(middle.y + down * step / fineness, 0.0, 0.5);
                const double sum = sample_sum(filter, x, y);
                if (better(sum, best.sum)) best = {sum, x, y};
            }
        }
    }
    if (best.x > best.y) std::swap(best.x, best.y);
    return best;
}

}  // namespace

double sample_sum(const Filter& filter, double x, double y) {
    const int reach = static_cast<int>(std::ceil(filter.reach())) + 1;
    double sum = 0;
    for (int row = -reach; row <= reach; ++row) {
        for (int column = -reach; column <= reach; ++column) {
            sum += filter(x - column - 0.5, y - row - 0.5);
        }
    }
    return sum / filter.integral();
}

SampleSums sample_sums(const Filter& filter) {
    constexpr int steps = 128;  // over half a cell; the shortest ripple is some tenths of a cell
    constexpr double step = 0.5 / steps;
    SampleSumAt least{sample_sum(filter, 0, 0)}, greatest = least;
    double squares = 0;
    for (int row = 0; row < steps; ++row) {
        for (int column = 0; column <= row; ++column) {
            const double x = (column + 0.5) * step, y = (row + 0.5) * step;
            const SampleSumAt here{sample_sum(filter, x, y), x, y};
            if (here.sum < least.sum) least = here;
            if (here.sum > greatest.sum) greatest = here;
            const int places = column < row ? 2 : 1;  // (x, y) and (y, x)
            squares += places * (here.sum - 1) * (here.sum - 1);
        }
    }
    return {refined(filter, least, step, std::less()),
            refined(filter, greatest, step, std::greater()), std::sqrt(squares) / steps};
}

std::span<const PrintedSampleSums> printed_sample_sums() {
    using enum FilterKind;
    static constexpr std::array<PrintedSampleSums, 6> table{{
        {raised_cosine, 1.5, {2.10}, {0.97}, {1.04}},
        {raised_cosine, 1.7, {2.70}, {0.97}, {1.01}},
        {raised_cosine, 2.0, {2.74, true}, {0.99}, {1.01}},
        {cone, 1.5, {2.36}, {0.90, true}, {1.09}},
        {cone, 1.7, {3.03}, {0.95}, {1.10}},
        {cone, 2.0, {4.19}, {0.98}, {1.02}},
    }};
    return table;
}

}  // namespace rayshoot

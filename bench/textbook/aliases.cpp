#include "bench/textbook/figures.h"

#include <cmath>
#include <numbers>

/// "Both signals give the same sample sets! They are said to be aliases of each other."
namespace rayshoot::textbook {
namespace {

constexpr int last_sample = 16;
/// Cycles between one sample and the next. Powers of two, so that frequency times place is exact.
constexpr double low = 1.0 / last_sample, high = low + 1;
constexpr int points_per_sample = 40;

double signal(double frequency, double x) {
    return std::sin(2 * std::numbers::pi * (frequency * x));
}

/// What rounding alone may make of two sines whose arguments are whole turns apart: each argument
/// has two roundings (2 pi, and the product), and the result is no more off than the argument.
const double rounding = 4 * 0x1p-53 * (2 * std::numbers::pi * high * last_sample);

/// At `per_unit` samples where the figure has one.
double largest_difference(int per_unit) {
    double largest = 0;
    for (int i = 0; i <= last_sample * per_unit; ++i) {
        const double x = static_cast<double>(i) / per_unit;
        largest = std::max(largest, std::abs(signal(low, x) - signal(high, x)));
    }
    return largest;
}

Series curve(std::string name, double frequency, int per_unit, Series::Mark mark) {
    Series series{std::move(name), mark, {}};
    for (int i = 0; i <= last_sample * per_unit; ++i) {
        const double x = static_cast<double>(i) / per_unit;
        series.values.push_back({x, signal(frequency, x)});
    }
    return series;
}

}  // namespace

void aliases(const Studio&, Sheet& sheet) {
    sheet.add(Chart{"aliases",
                    "17/16 and 1/16 cycles a sample: the samples are the same",
                    "sample",
                    "signal",
                    {curve("17/16 cycles", high, points_per_sample, Series::Mark::line),
                     curve("1/16 cycle", low, points_per_sample, Series::Mark::line),
                     curve("samples", high, 1, Series::Mark::points)}});
    const double at_samples = largest_difference(1);
    sheet.add(Check{"largest difference of the two sample sets: no more than rounding, " +
                        short_number(rounding, 2),
                    "the same", short_number(at_samples, 2), agrees_if(at_samples <= rounding)});
    const double between = largest_difference(points_per_sample);
    sheet.add(Check{"largest difference of the two signals", "", short_number(between, 3),
                    agrees_if(between > 1)});
    // The sampling theorem: more than twice the highest frequency, 17/16.
    const double finer = largest_difference(3);
    sheet.add(Check{"of samples at 3 a unit, more than twice the higher frequency", "not the same",
                    short_number(finer, 3), agrees_if(finer > 0.5)});
}

}  // namespace rayshoot::textbook

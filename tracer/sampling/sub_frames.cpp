#include "tracer/sampling/sub_frames.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracer/random.h"
#include "tracer/sampling/permutation.h"

namespace rayshoot {
namespace {

using Times = std::vector<std::uint16_t>;

/// Made per prototype until one is good enough, else the best of them is taken.
constexpr std::uint64_t candidates = 64;
constexpr double good_correlation = 0.02;
/// Tried per stratum, and in all: with 256 x 256 strata few are needed, a random permutation's
/// correlation is 0.004.
constexpr std::uint64_t swaps_each = 64, most_swaps = 1 << 14;

/// Sums of centred times over each column, or each row.
struct Sums {
    std::vector<std::int64_t> columns, rows;
};

Sums sums(std::span<const std::uint16_t> times, std::size_t across) {
    Sums sums{std::vector<std::int64_t>(across), std::vector<std::int64_t>(times.size() / across)};
    const auto last = static_cast<std::int64_t>(times.size()) - 1;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const std::int64_t centred = 2 * std::int64_t{times[i]} - last;  // doubled: an integer
        sums.columns[i % across] += centred;
        sums.rows[i / across] += centred;
    }
    return sums;
}

/// The change of the sum of squares if `a` grows by `step` and `b` shrinks by it.
std::int64_t change(std::int64_t a, std::int64_t b, std::int64_t step) {
    return 2 * step * (a - b + step);
}

/// Swaps times until all columns have almost the same sum, and all rows: then no shift correlates
/// time with x or y. As in a magic square, if it comes to that.
void balance(Times& times, std::size_t across, std::uint64_t seed) {
    auto [columns, rows] = sums(times, across);
    const std::uint64_t size = times.size();
    for (std::uint64_t i = 0; i < std::min(swaps_each * size, most_swaps); ++i) {
        const std::uint64_t random = scrambled(seed + i);
        const std::size_t a = (random >> 32) * size >> 32, b = (random & 0xffffffffu) * size >> 32;
        const std::int64_t step = 2 * (std::int64_t{times[b]} - times[a]);
        auto &column_a = columns[a % across], &column_b = columns[b % across];
        auto &row_a = rows[a / across], &row_b = rows[b / across];
        std::int64_t growth = 0;
        if (&column_a != &column_b) growth += change(column_a, column_b, step);
        if (&row_a != &row_b) growth += change(row_a, row_b, step);
        if (growth > 0) continue;
        std::swap(times[a], times[b]);
        column_a += step, column_b -= step;
        row_a += step, row_b -= step;
    }
}

/// Correlation of time with one axis from the sums of its lines; a shift by one takes the last
/// line to the front, which changes the product sum by count times that line's sum.
double axis_correlation(std::span<const std::int64_t> lines, std::size_t size) {
    const auto count = static_cast<double>(lines.size()), all = static_cast<double>(size);
    double product = 0, largest = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        product += static_cast<double>(lines[i]) * (2 * static_cast<double>(i) - count + 1);
    }
    for (std::size_t i = lines.size(); i-- > 0;) {
        product -= 2 * count * static_cast<double>(lines[i]);
        largest = std::max(largest, std::abs(product));
    }
    // Sums of squares of the doubled, centred times and places.
    const double squares = all * (all * all - 1) / 3 * (all * (count * count - 1) / 3);
    return squares > 0 ? largest / std::sqrt(squares) : 0;
}

bool monotone(const Times& times, std::size_t first, std::size_t step, std::size_t count) {
    int rises = 0;
    for (std::size_t i = 1; i < count; ++i) {
        rises += times[first + i * step] > times[first + (i - 1) * step];
    }
    return count > 3 && (rises == 0 || rises == static_cast<int>(count) - 1);
}

/// Rows and columns of four or more along which time only rises, or only falls. (Of three, the
/// balanced ones are all turns of the magic square of order 3, which has such a row.)
int monotone_lines(const Times& times, std::size_t across) {
    const std::size_t down = times.size() / across;
    int lines = 0;
    for (std::size_t y = 0; y < down; ++y) lines += monotone(times, y * across, 1, across);
    for (std::size_t x = 0; x < across; ++x) lines += monotone(times, x, across, down);
    return lines;
}

Times candidate(std::size_t across, std::size_t size, std::uint64_t seed) {
    Times times(size);
    for (std::uint32_t i = 0; i < size; ++i) {
        times[i] = static_cast<std::uint16_t>(permuted(i, static_cast<std::uint32_t>(size), seed));
    }
    balance(times, across, seed);
    return times;
}

Times made_prototype(int across, int down, std::uint64_t seed) {
    const auto columns = static_cast<std::size_t>(across);
    const std::size_t size = columns * static_cast<std::size_t>(down);
    const auto badness = [&](const Times& times) {
        return std::pair(monotone_lines(times, columns), largest_correlation(times, across, down));
    };
    Times best = candidate(columns, size, scrambled(seed));
    for (std::uint64_t i = 1; i < candidates && badness(best) > std::pair(0, good_correlation);
         ++i) {
        Times next = candidate(columns, size, scrambled(seed + i));
        if (badness(next) < badness(best)) best = std::move(next);
    }
    return best;
}

}  // namespace

double largest_correlation(std::span<const std::uint16_t> times, int across,
                           [[maybe_unused]] int down) {
    const auto [columns, rows] = sums(times, static_cast<std::size_t>(across));
    assert(rows.size() == static_cast<std::size_t>(down));
    return std::max(axis_correlation(columns, times.size()), axis_correlation(rows, times.size()));
}

SubFrames::SubFrames(int across, int down, std::uint64_t seed)
    : columns_(static_cast<std::uint32_t>(across)), rows_(static_cast<std::uint32_t>(down)) {
    for (std::uint64_t i = 0; i < prototypes; ++i) {
        const Times times = made_prototype(across, down, seed + candidates * i);
        times_.insert(times_.end(), times.begin(), times.end());
    }
}

std::uint32_t SubFrames::of(std::uint32_t stratum, std::uint64_t key) const {
    const std::uint32_t across = columns_.count(), down = rows_.count(), count = across * down;
    std::uint32_t y = columns_.quotient(stratum), x = stratum - y * across;
    if (across == down && (key & 1)) std::swap(x, y);
    if (key & 2) x = across - 1 - x;
    if (key & 4) y = down - 1 - y;
    x = turned(x, static_cast<std::uint32_t>((key >> 8 & 0xffffff) * across >> 24), across);
    y = turned(y, static_cast<std::uint32_t>((key >> 32) * down >> 32), down);
    const auto which = static_cast<std::uint32_t>(key >> 4 & (prototypes - 1));
    const std::uint32_t time = times_[which * count + y * across + x];
    return key & 8 ? count - 1 - time : time;
}

}  // namespace rayshoot

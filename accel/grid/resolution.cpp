#include "accel/grid/resolution.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

using Sizes = std::array<double, 3>;

Sizes sizes_of(const Box& space) {
    Sizes sizes;
    for (int axis = 0; axis < 3; ++axis)
        sizes[static_cast<std::size_t>(axis)] = double(space.hi[axis]) - double(space.lo[axis]);
    return sizes;
}

int whole(double cells) {
    return static_cast<int>(std::clamp(cells, 1.0, double(Resolution::most_along)));
}

/// Cells per unit of length, if they are cubes; a side too short for one cell has one and counts no
/// further, so that flat scenes get as many cells as others.
double cubes_per_length(const Sizes& sizes, double cells) {
    Sizes sorted = sizes;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t flat = 0; flat < 2; ++flat) {
        double logarithm = std::log(cells);
        for (std::size_t i = flat; i < 3; ++i) logarithm -= std::log(sorted[i]);
        const double per_length = std::exp(logarithm / double(3 - flat));
        if (sorted[flat] > 0 && sorted[flat] * per_length >= 1) return per_length;
    }
    return sorted[2] > 0 ? cells / sorted[2] : 0;
}

Cell cubes(const Sizes& sizes, double cells, double rounding) {
    const double per_length = cubes_per_length(sizes, cells);
    Cell result;
    for (std::size_t axis = 0; axis < 3; ++axis)
        // What is a whole number but for rounding stays one.
        result[axis] = whole(std::floor(sizes[axis] * per_length * (1 + 1e-9) + rounding));
    return result;
}

Cell klimaszewski(Sizes sizes, double cells) {
    const double longest = *std::max_element(sizes.begin(), sizes.end());
    if (!(longest > 0)) return {1, 1, 1};
    for (double& size : sizes) size = std::max(size / longest, 0x1p-20);
    const auto [x, y, z] = sizes;
    const int along_x = whole(std::cbrt(cells * x * x / (y * z)) + 0.5);
    const int along_y = whole(std::sqrt(cells * y / (along_x * z)) + 0.5);
    return {along_x, along_y, whole(cells / (double(along_x) * along_y) + 0.5)};
}

double product(const Cell& cells) { return double(cells[0]) * cells[1] * cells[2]; }

/// "46x46x3"
std::optional<Cell> parsed(std::string_view text) {
    Cell cells;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, cells[axis]);
        const bool last = axis == 2;
        if (error != std::errc() || cells[axis] < 1 || cells[axis] > Resolution::most_along ||
            (last ? rest != end : rest == end || *rest != 'x'))
            return std::nullopt;
        text = std::string_view(rest, static_cast<std::size_t>(end - rest));
        if (!last) text.remove_prefix(1);
    }
    return product(cells) <= Resolution::most_cells ? std::optional(cells) : std::nullopt;
}

}  // namespace

Resolution Resolution::chosen(const Options& options, std::string_view key) {
    const std::string_view text = options.text(key);
    if (const std::optional<Cell> cells = parsed(text)) return {ResolutionRule::fixed, *cells};
    return {options.choice<ResolutionRule>(
        key, {{"cleary", ResolutionRule::cleary},
              {"woo", ResolutionRule::woo},
              {"klimaszewski", ResolutionRule::klimaszewski},
              {"AxBxC, whole numbers of at most 2^27 cells", ResolutionRule::fixed}})};
}

Cell Resolution::cells(const Box& space, double objects, double density) const {
    if (rule == ResolutionRule::fixed) return fixed;
    const double wanted = std::clamp(objects * density, 1.0, most_cells / 4);
    const Sizes sizes = sizes_of(space);
    for (double cells = wanted; cells > 1; cells *= 0.75) {
        const Cell result = rule == ResolutionRule::cleary ? cubes(sizes, cells, 0)
                            : rule == ResolutionRule::woo  ? cubes(sizes, cells, 0.5)
                                                           : klimaszewski(sizes, cells);
        // Rounding may make many cells of few, where a side is short.
        if (product(result) <= 4 * wanted) return result;
    }
    return {1, 1, 1};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

#pragma once

#include <optional>
#include <span>

/// Whether a run's machine held still: what the control kernel says.
namespace rayshoot {

struct Steadiness {
    std::optional<double> moved;  ///< central_range of the samples; none: fewer than two of them
    double void_above = 0;

    /// The run is to be repeated; nothing where it is not known.
    std::optional<bool> is_void() const {
        return moved ? std::optional(*moved > void_above) : std::nullopt;
    }
};

/// `samples`: seconds of the control kernel, one median per block.
Steadiness steadiness(std::span<const double> samples, double void_above);

}  // namespace rayshoot

#pragma once

#include <cstdint>
#include <string_view>

/// When a ray is sent: the shutter's opening as a density of ray times.
namespace rayshoot {

/// How long a moment counts: alike from opening to closing; rising and falling linearly, or as
/// 1 - cos (Cook, Porter & Carpenter 1984 weight the time filter).
enum class ShutterWeight : std::uint8_t { box, triangle, raised_cosine };

/// Throws std::invalid_argument, listing the names, for one that is none of them.
ShutterWeight shutter_weight(std::string_view name);
std::string_view name(ShutterWeight weight);

/// Samples are drawn by their weight, so each counts 1.
struct Shutter {
    float open = 0, close = 1;  ///< ray times in [0, 1]; equal: an instant
    ShutterWeight weight = ShutterWeight::box;

    /// The inverse of the weight's distribution function: uniform `u` in [0, 1] to a ray time.
    float time(float u) const;
    /// Share of the light that comes in before `time`; `open` < `close`.
    double distribution(double time) const;
};

/// Throws std::invalid_argument, with the remedy, unless 0 <= open <= close <= 1.
void require_valid(const Shutter& shutter);

}  // namespace rayshoot

#pragma once

#include "accel/core/intersector.h"
#include "tracer/render.h"
#include "tracer/scalar_image.h"

#include <array>
#include <string_view>

/// What each pixel of an image costs a structure.
namespace rayshoot {

enum class Cost : std::uint8_t { tests, steps, boxes, time };
inline constexpr std::array<std::string_view, 4> cost_names{"tests", "steps", "boxes", "time"};
/// What a map of it holds: object tests, traversal steps, bounding-volume tests, nanoseconds.
inline constexpr std::array<std::string_view, 4> cost_units{"object tests", "traversal steps",
                                                            "bounding-volume tests", "ns"};

std::string_view name_of(Cost cost);
std::string_view unit_of(Cost cost);
/// Throws std::invalid_argument, listing the costs there are.
Cost cost_named(std::string_view name);

/// The same image traced in batches of one pixel: at most `spp` rays in one call, in one lane.
/// Slower than full batches, in which a structure takes several rays at once. Throws
/// std::invalid_argument where rays are not one pixel's: for filters wider than a pixel and the
/// method irradiance.
RenderSettings settings_by_pixel(const RenderSettings& settings);

/// Every ray of a pixel, of whatever kind, is charged to the pixel. Counts are those of one
/// counting session in the order of the tiles: their sum is what render() counts with these
/// settings. Time is one render's, in sessions of its own; combine several by the least. Throws
/// what render throws, and std::invalid_argument for counts of a structure that does not count.
ScalarImage cost_map(const Scene& scene, const Accel& accel, const RenderSettings& settings,
                     Cost cost);

/// Pixel by pixel the lesser of the two, into `least`.
void keep_least(ScalarImage& least, const ScalarImage& other);

/// What a map comes to.
struct CostSummary {
    double sum = 0, mean = 0, largest = 0;
    Pixel largest_at;  ///< the first, row by row
};
CostSummary summarise(const ScalarImage& costs);

}  // namespace rayshoot

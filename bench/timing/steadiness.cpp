#include "bench/timing/steadiness.h"

#include "bench/statistics/estimate.h"

namespace rayshoot {

Steadiness steadiness(std::span<const double> samples, double void_above) {
    Steadiness result{std::nullopt, void_above};
    if (samples.size() > 1) result.moved = central_range(samples);
    return result;
}

}  // namespace rayshoot

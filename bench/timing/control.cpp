#include "bench/timing/control.h"

#include "bench/statistics/random.h"
#include "bench/timing/clock.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace rayshoot {
namespace {

constexpr std::size_t table_size = std::size_t{1} << 18;  // entries of 8 bytes: 2 MiB
constexpr int loads = 1 << 19;

}  // namespace

ControlKernel::ControlKernel() : next_(table_size) {
    std::iota(next_.begin(), next_.end(), std::size_t{0});
    Sequence random(1);
    for (std::size_t i = table_size - 1; i > 0; --i) {  // Sattolo 1986: a single cycle
        std::swap(next_[i], next_[random.below(i)]);
    }
}

double ControlKernel::seconds() {
    const Stopwatch watch;
    std::size_t at = 0;
    float sum = 0;
    for (int i = 0; i < loads; ++i) {
        at = next_[at];
        sum = std::fma(0.5f, sum, static_cast<float>(at));
    }
    result_ = sum;
    return watch.seconds();
}

}  // namespace rayshoot

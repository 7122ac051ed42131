#include "bench/streams/promises.h"

#include "accel/core/promise.h"

#include <stdexcept>

namespace rayshoot {

std::string broken_promise_in(const BuildInput& input, const RayStream& stream) {
    if (stream.sources.empty()) return {};
    for (std::size_t first = 0; first < stream.size(); first += max_batch) {
        const std::string broken = broken_promise(input, stream.batch(first, max_batch));
        if (!broken.empty()) return "from ray " + std::to_string(first) + " on: " + broken;
    }
    return {};
}

void require_promises_kept(const BuildInput& input, const RayStream& stream) {
    const std::string broken = broken_promise_in(input, stream);
    if (broken.empty()) return;
    throw std::runtime_error("the sources of the rays are not true, " + broken +
                             "; record them on this scene, or leave the sources out");
}

}  // namespace rayshoot

#include "bench/streams/ray_stream.h"

#include "bench/statistics/random.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace rayshoot {

std::string_view name_of(StreamKind kind) {
    return stream_kind_names[static_cast<std::size_t>(kind)];
}

StreamKind stream_kind(std::string_view name) {
    for (std::size_t i = 0; i < stream_kind_names.size(); ++i) {
        if (stream_kind_names[i] == name) return static_cast<StreamKind>(i);
    }
    throw std::invalid_argument("unknown ray kind \"" + std::string(name) +
                                "\"; there are camera, shadow, diffuse, random and mirror");
}

RayBatch RayStream::batch(std::size_t first, std::size_t count) const {
    const std::size_t length = std::min(count, rays.size() - first);
    RayBatch batch{batch_kind, depth, std::span(rays).subspan(first, length), {}};
    if (!sources.empty()) batch.source = std::span(sources).subspan(first, length);
    return batch;
}

RayStream selection(const RayStream& stream, const std::vector<std::size_t>& chosen) {
    RayStream part = stream;
    part.rays.clear();
    part.sources.clear();
    for (const std::size_t i : chosen) {
        part.rays.push_back(stream.rays[i]);
        if (!stream.sources.empty()) part.sources.push_back(stream.sources[i]);
    }
    return part;
}

std::vector<std::size_t> spread_sample(std::size_t size, std::size_t count, std::uint64_t seed) {
    std::vector<std::size_t> chosen(std::min(size, count));
    if (count >= size) {
        std::iota(chosen.begin(), chosen.end(), std::size_t{0});
        return chosen;
    }
    Sequence random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = i * size / count;
        const std::size_t last = (i + 1) * size / count;
        chosen[i] = first + random.below(last - first);
    }
    return chosen;
}

}  // namespace rayshoot

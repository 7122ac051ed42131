#pragma once

#include "accel/embree/packet.h"

#include <vector>

/// One lane of work: takes rays in our layout through one of Embree's public paths.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

enum class Kernel : std::uint8_t { single, packet, stream };

struct Path {
    Kernel kernel;
    Coherence coherence;
};

class Lane {
public:
    /// Refers to `scene`.
    explicit Lane(const Scene& scene);

    template <Query Q>
    void answer(Path path, std::span<const Ray> rays, Answer<Q>* answers);

    std::size_t bytes() const;

private:
    template <Query Q>
    void answer_plain(Path path, std::span<const Ray> rays, Answer<Q>* answers);
    template <Query Q>
    void answer_mixed(Path path, std::span<const Ray> rays, Answer<Q>* answers);
    template <Query Q>
    Answer<Q> answer_alone(const Ray& ray);
    template <Query Q>
    void answer_records(Asker& asker, Kernel kernel, std::span<const Ray> rays, Answer<Q>* answers);
    template <Query Q>
    void answer_packets(Asker& asker, std::span<const Ray> rays, Answer<Q>* answers);

    template <Query Q>
    std::vector<Record<Q>>& records();

    const Scene& scene_;
    Ends ends_;
    std::vector<Ray> clean_;
    std::vector<RTCRayHit> closest_;
    std::vector<RTCRay> occluded_;
};

extern template void Lane::answer<Query::closest>(Path, std::span<const Ray>, Hit*);
extern template void Lane::answer<Query::occluded>(Path, std::span<const Ray>, std::uint8_t*);

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree

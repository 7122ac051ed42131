#include "accel/embree/accel.h"

#include <cassert>

namespace rayshoot::inline RAYSHOOT_ISA::embree {
namespace {

class EmbreeSession final : public Session {
public:
    EmbreeSession(const Scene& scene, Choice choice) : lane_(scene), choice_(choice) {}

    std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) override {
        assert(hits.size() >= batch.rays.size());
        lane_.answer<Query::closest>(path(choice_, Query::closest, batch.kind), batch.rays,
                                     hits.data());
        return {};
    }
    std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                            std::span<std::uint8_t> occluded) override {
        assert(occluded.size() >= batch.rays.size());
        lane_.answer<Query::occluded>(path(choice_, Query::occluded, batch.kind), batch.rays,
                                      occluded.data());
        return {};
    }
    const Counters* counters(RayKind) const override { return nullptr; }
    std::size_t bytes() const override { return lane_.bytes(); }

private:
    Lane lane_;
    Choice choice_;
};

}  // namespace

Path path(Choice choice, Query query, RayKind kind) {
    const bool camera = kind == RayKind::camera;
    const Coherence coherence = camera ? Coherence::coherent : Coherence::incoherent;
    switch (choice) {
        case Choice::single:
            return {Kernel::single, coherence};
        case Choice::packet:
            return {Kernel::packet, coherence};
        case Choice::stream:
            return {Kernel::stream, coherence};
        case Choice::automatic:
            break;
    }
    const bool stream = has_streams && query == Query::occluded && !camera;
    return {stream ? Kernel::stream : Kernel::packet, coherence};
}

std::unique_ptr<Session> open_session(const Scene& scene, Choice choice) {
    return std::make_unique<EmbreeSession>(scene, choice);
}

std::unique_ptr<Session> EmbreeAccel::open(Mode) const { return open_session(scene_, choice_); }

Footprint EmbreeAccel::footprint() const {
    Footprint footprint;
    footprint.bytes = static_cast<std::uint64_t>(scene_.bytes());
    return footprint;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree

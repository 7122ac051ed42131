#pragma once

#include "accel/core/intersector.h"
#include "accel/embree/lane.h"

/// The yardstick as an Accel.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

enum class Choice : std::uint8_t { automatic, single, packet, stream };

/// `automatic`: the fastest public path for the question and the kind of ray (README, measured).
/// The flag is part of it: for shadow and secondary rays the coherent one costs up to half the
/// speed.
Path path(Choice choice, Query query, RayKind kind);

/// Refers to `scene`.
std::unique_ptr<Session> open_session(const Scene& scene, Choice choice);

class EmbreeAccel final : public Accel {
public:
    EmbreeAccel(const Geometry& geometry, RTCBuildQuality quality, Choice choice, std::string spec)
        : scene_(geometry, quality), choice_(choice), spec_(std::move(spec)) {}

    std::unique_ptr<Session> open(Mode mode) const override;
    Footprint footprint() const override;
    bool serves(Query, RayKind) const override { return true; }
    const std::string& spec() const override { return spec_; }
    bool complete() const override { return true; }
    bool remembers() const override { return false; }

private:
    Scene scene_;
    Choice choice_;
    std::string spec_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree

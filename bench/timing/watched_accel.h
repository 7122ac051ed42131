#pragma once

#include "accel/core/intersector.h"

#include <functional>

/// A structure whose answers are watched, batch by batch: for costs by pixel or by kind of ray,
/// whatever tracer asks.
namespace rayshoot {

/// A batch that was just answered.
struct AnsweredBatch {
    const RayBatch& batch;
    Query question;
    double seconds;          ///< that the answer took
    const Session& session;  ///< that answered, with its counters
};

/// Called after each batch by the lane that asked: from one thread only when the tracer has one.
using Watcher = std::function<void(const AnsweredBatch&)>;

/// Answers as the structure it was made from, which must outlive it. What its sessions take beyond
/// the structure's own are two looks at the clock a batch and the watcher.
class WatchedAccel final : public Accel {
public:
    WatchedAccel(const Accel& accel, Watcher watcher)
        : accel_(accel), watcher_(std::move(watcher)) {}

    std::unique_ptr<Session> open(Mode mode) const override;
    Footprint footprint() const override { return accel_.footprint(); }
    bool serves(Query query, RayKind kind) const override { return accel_.serves(query, kind); }
    const std::string& spec() const override { return accel_.spec(); }
    bool complete() const override { return accel_.complete(); }
    bool remembers() const override { return accel_.remembers(); }
    std::span<const std::unique_ptr<Accel>> members() const override { return accel_.members(); }

private:
    const Accel& accel_;
    Watcher watcher_;
};

}  // namespace rayshoot

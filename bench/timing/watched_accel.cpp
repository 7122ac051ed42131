#include "bench/timing/watched_accel.h"

#include "bench/timing/clock.h"

namespace rayshoot {
namespace {

class WatchedSession final : public Session {
public:
    WatchedSession(std::unique_ptr<Session> session, const Watcher& watcher)
        : session_(std::move(session)), watcher_(watcher) {}

    std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) override {
        const Stopwatch watch;
        const auto declined = session_->closest(batch, hits);
        watcher_({batch, Query::closest, watch.seconds(), *session_});
        return declined;
    }
    std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                            std::span<std::uint8_t> occluded) override {
        const Stopwatch watch;
        const auto declined = session_->occluded(batch, occluded);
        watcher_({batch, Query::occluded, watch.seconds(), *session_});
        return declined;
    }
    const Counters* counters(RayKind kind) const override { return session_->counters(kind); }
    std::span<const std::unique_ptr<Session>> members() const override {
        return session_->members();
    }
    std::size_t bytes() const override { return session_->bytes(); }

private:
    std::unique_ptr<Session> session_;
    const Watcher& watcher_;
};

}  // namespace

std::unique_ptr<Session> WatchedAccel::open(Mode mode) const {
    return std::make_unique<WatchedSession>(accel_.open(mode), watcher_);
}

}  // namespace rayshoot

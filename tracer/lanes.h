#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tracer/tile_tracer.h"

/// Sessions belong to lanes of work, not to threads: a worker that waits may steal another tile.
namespace rayshoot {

struct Lane {
    std::unique_ptr<Session> session;
    TileTracer tracer;

    Lane(std::unique_ptr<Session> opened, TileTracer tile_tracer)
        : session(std::move(opened)), tracer(std::move(tile_tracer)) {}
};

/// A free list: last in, first out, so that warm caches are used first.
class Lanes {
public:
    explicit Lanes(std::function<std::unique_ptr<Lane>()> make) : make_(std::move(make)) {}

    std::unique_ptr<Lane> take() {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                std::unique_ptr<Lane> lane = std::move(free_.back());
                free_.pop_back();
                return lane;
            }
        }
        return make_();
    }
    void put_back(std::unique_ptr<Lane> lane) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(lane));
    }
    /// All lanes, once every one has been put back.
    std::vector<std::unique_ptr<Lane>>& all() { return free_; }

private:
    std::function<std::unique_ptr<Lane>()> make_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Lane>> free_;
};

}  // namespace rayshoot

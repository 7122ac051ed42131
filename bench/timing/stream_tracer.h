#pragma once

#include "accel/core/intersector.h"
#include "bench/streams/ray_stream.h"

#include <memory>
#include <vector>

/// Answers a stream with a structure, on lanes of oneTBB, a session per lane.
namespace rayshoot {

struct TraceSettings {
    int threads = 1;
    std::size_t batch = default_batch;  ///< rays; 1 to max_batch
};

/// Only the vector that the stream's question asks for is filled.
struct StreamAnswers {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> occluded;

    std::size_t hit_count() const;
    /// SHA-256 (hex) over the answers, bit for bit.
    std::string digest() const;
    bool operator==(const StreamAnswers&) const = default;
};

/// One structure on one stream. The buffers are allocated before any clock starts.
class StreamTracer {
public:
    /// Keeps references to both.
    StreamTracer(const Accel& accel, const RayStream& stream, TraceSettings settings);

    /// Seconds for the whole stream with sessions opened inside the time: lazy building is paid.
    double trace_fresh();
    /// Seconds for the whole stream on the sessions that the last trace left behind.
    double trace_warm();

    const StreamAnswers& answers() const { return answers_; }
    /// Rays of the last trace that nobody answered; a complete structure leaves none.
    std::size_t declined() const { return declined_; }

private:
    double trace();
    std::size_t answer_batch(Session& session, std::size_t first);

    const Accel& accel_;
    const RayStream& stream_;
    TraceSettings settings_;
    StreamAnswers answers_;
    std::vector<std::unique_ptr<Session>> sessions_;  ///< one per lane, opened by its first batch
    std::size_t declined_ = 0;
};

/// Counts from one session in stream order, so that they are the same on every machine and for any
/// number of threads, for structures that remember too.
struct StreamCounts {
    Counters total;
    std::vector<Counters> members;  ///< of a composition, in order
    bool available = false;         ///< false where the structure cannot count
    std::size_t rays = 0;
};
StreamCounts count_stream(const Accel& accel, const RayStream& stream, std::size_t batch);

}  // namespace rayshoot

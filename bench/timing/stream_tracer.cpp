#include "bench/timing/stream_tracer.h"

#include "bench/timing/clock.h"
#include "data/digest.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace rayshoot {
namespace {

void require_sensible(const TraceSettings& settings) {
    if (settings.threads < 1) throw std::invalid_argument("at least one thread is needed");
    if (settings.batch < 1 || settings.batch > max_batch) {
        throw std::invalid_argument("a batch has 1 to " + std::to_string(max_batch) +
                                    " rays, not " + std::to_string(settings.batch));
    }
}

StreamAnswers room_for(const RayStream& stream) {
    StreamAnswers answers;
    if (stream.question == Query::closest) answers.hits.resize(stream.size());
    else answers.occluded.resize(stream.size());
    return answers;
}

}  // namespace

std::size_t StreamAnswers::hit_count() const {
    const auto hit = [](const Hit& h) { return h.primitive != no_primitive; };
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), hit) +
                                    std::count(occluded.begin(), occluded.end(), 1));
}

std::string StreamAnswers::digest() const {
    Digest hash;
    hash.add(std::as_bytes(std::span(hits)));
    hash.add(std::as_bytes(std::span(occluded)));
    return hash.hex();
}

StreamTracer::StreamTracer(const Accel& accel, const RayStream& stream, TraceSettings settings)
    : accel_(accel), stream_(stream), settings_(settings), answers_(room_for(stream)) {
    require_sensible(settings);
    sessions_.resize(static_cast<std::size_t>(settings.threads));
}

double StreamTracer::trace_fresh() {
    for (auto& session : sessions_) session.reset();
    return trace();
}

double StreamTracer::trace_warm() { return trace(); }

double StreamTracer::trace() {
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> declined{0};
    const auto lane = [&](int number) {
        auto& session = sessions_[static_cast<std::size_t>(number)];
        std::size_t mine = 0;
        for (;;) {
            const std::size_t first = next.fetch_add(settings_.batch, std::memory_order_relaxed);
            if (first >= stream_.size()) break;
            if (!session) session = accel_.open(Mode::timing);
            mine += answer_batch(*session, first);
        }
        declined += mine;
    };
    const Stopwatch watch;
    if (settings_.threads == 1) {
        lane(0);
    } else {
        tbb::task_arena arena(settings_.threads);
        arena.execute(
            [&] { tbb::parallel_for(0, settings_.threads, 1, lane, tbb::simple_partitioner{}); });
    }
    const double seconds = watch.seconds();
    declined_ = declined;
    return seconds;
}

std::size_t StreamTracer::answer_batch(Session& session, std::size_t first) {
    const RayBatch batch = stream_.batch(first, settings_.batch);
    const std::size_t count = batch.rays.size();
    if (stream_.question == Query::closest) {
        return session.closest(batch, std::span(answers_.hits).subspan(first, count)).size();
    }
    return session.occluded(batch, std::span(answers_.occluded).subspan(first, count)).size();
}

StreamCounts count_stream(const Accel& accel, const RayStream& stream, std::size_t batch) {
    require_sensible({1, batch});
    const auto session = accel.open(Mode::counting);
    std::vector<Hit> hits(batch);
    std::vector<std::uint8_t> occluded(batch);
    for (std::size_t first = 0; first < stream.size(); first += batch) {
        const RayBatch part = stream.batch(first, batch);
        if (stream.question == Query::closest) session->closest(part, hits);
        else session->occluded(part, occluded);
    }
    StreamCounts counts;
    counts.rays = stream.size();
    const Counters* total = session->counters(stream.batch_kind);
    counts.available = total != nullptr;
    if (total) counts.total = *total;
    for (const auto& member : session->members()) {
        const Counters* part = member->counters(stream.batch_kind);
        counts.members.push_back(part ? *part : Counters{});
    }
    return counts;
}

}  // namespace rayshoot

#include "tracer/wavefront.h"

#include <algorithm>

namespace rayshoot {
namespace {

void clear(Sent::Rays& rays) {
    rays.rays.clear();
    rays.paths.clear();
}

void clear(Sent::Shadows& shadows) {
    shadows.rays.clear();
    shadows.arriving.clear();
}

}  // namespace

Wavefront::Wavefront(const Integrator& integrator, Session& session, std::size_t lights,
                     std::size_t batch)
    : integrator_(integrator), session_(session), batch_(batch), hits_(batch), occluded_(batch) {
    sent_.shadows.resize(lights);
}

void Wavefront::trace(std::span<Shot> shots, int level, float pdf) {
    start(shots, level, pdf);
    for (; !wave_.rays.empty(); ++level) {
        for (std::size_t first = 0; first < wave_.rays.size(); first += batch_) {
            trace_batch(first, std::min(batch_, wave_.rays.size() - first), level);
        }
        turn_wave();
    }
    counts_.totally_reflected += sent_.totally_reflected;
    sent_.totally_reflected = 0;
}

void Wavefront::start(std::span<Shot> shots, int level, float pdf) {
    sent_.shots = shots;
    const Cause cause = level == 1 ? Cause::camera : Cause::reflection;
    wave_.rays.resize(shots.size());
    wave_.paths.resize(shots.size());
    sources_.resize(shots.size());
    for (std::uint32_t i = 0; i < shots.size(); ++i) {
        wave_.rays[i] = shots[i].ray;
        wave_.paths[i] = {.shot = i, .cause = cause, .pdf = pdf};
        sources_[i] = shots[i].source;
    }
}

/// Two looks at the clock for a batch.
template <class Question>
void Wavefront::ask(const Question& question) {
    const auto start = std::chrono::steady_clock::now();
    question();
    answering_ += std::chrono::steady_clock::now() - start;
}

void Wavefront::trace_batch(std::size_t first, std::size_t count, int level) {
    RayBatch batch;
    batch.kind = level == 1 ? RayKind::camera : RayKind::secondary;
    batch.depth = static_cast<std::uint8_t>(level);
    batch.rays = std::span(wave_.rays).subspan(first, count);
    if (level == 1) batch.source = std::span(sources_).subspan(first, count);
    ask([&] { session_.closest(batch, std::span(hits_).first(count)); });
    for (std::size_t i = 0; i < count; ++i) {
        const Path& path = wave_.paths[first + i];
        const Hit& hit = hits_[i];
        Shot& shot = sent_.shots[path.shot];
        RayCount& counted = counts_[path.cause];
        ++counted.rays;
        counted.hits += hit.primitive != no_primitive;
        if (path.place == 1) shot.distance = hit.t;
        integrator_.shade({batch.rays[i], hit, path, shot, level}, sent_);
    }
    for (std::uint32_t light = 0; light < sent_.shadows.size(); ++light)
        trace_shadows(light, level);
}

void Wavefront::trace_shadows(std::uint32_t light, int level) {
    Sent::Shadows& shadows = sent_.shadows[light];
    light_sources_.assign(std::min(batch_, shadows.rays.size()), Source::light(light));
    for (std::size_t first = 0; first < shadows.rays.size(); first += batch_) {
        const std::size_t count = std::min(batch_, shadows.rays.size() - first);
        const auto occluded = std::span(occluded_).first(count);
        const RayBatch batch{RayKind::shadow, static_cast<std::uint8_t>(level),
                             std::span(shadows.rays).subspan(first, count),
                             std::span(light_sources_).first(count)};
        ask([&] { session_.occluded(batch, occluded); });
        counts_[Cause::shadow].rays += count;
        for (std::size_t i = 0; i < count; ++i) {
            counts_[Cause::shadow].hits += occluded[i];
            if (occluded[i]) continue;
            const Sent::Arriving& arriving = shadows.arriving[first + i];
            sent_.shots[arriving.shot].radiance += arriving.radiance;
        }
    }
    clear(shadows);
}

/// Rays of one kind stay together: they are the more coherent.
void Wavefront::turn_wave() {
    std::swap(wave_, sent_.reflections);
    Sent::Rays& after = sent_.refractions;
    wave_.rays.insert(wave_.rays.end(), after.rays.begin(), after.rays.end());
    wave_.paths.insert(wave_.paths.end(), after.paths.begin(), after.paths.end());
    clear(sent_.reflections);
    clear(after);
}

}  // namespace rayshoot

#pragma once

#include "accel/core/intersector.h"

#include <chrono>
#include <span>
#include <vector>

#include "tracer/integrator/integrator.h"

/// Traces the shots of a tile in waves: all rays of one level are traced in batches, shaded by the
/// integrator, and spawn the shadow rays and the next wave. Every structure sees the same batches.
namespace rayshoot {

inline constexpr int largest_depth = 255;  ///< RayBatch::depth is a byte

/// One lane's work, with one session. The radiance of a shot is summed in an order that depends on
/// its tile alone: images depend on neither structure nor lanes.
class Wavefront {
public:
    /// `batch`: most rays in one call, 1 to max_batch. `lights`: the scene's.
    Wavefront(const Integrator& integrator, Session& session, std::size_t lights,
              std::size_t batch);

    /// Adds to each shot the radiance that its ray brings. `level`: 1 for camera rays; above it
    /// they are secondary rays, without sources. `pdf`: Path::pdf of all of them.
    void trace(std::span<Shot> shots, int level = 1, float pdf = 0);
    const RayCounts& counts() const { return counts_; }
    /// Time that the session took to answer; the rest is the tracer's own.
    std::chrono::nanoseconds answering() const { return answering_; }

private:
    void start(std::span<Shot> shots, int level, float pdf);
    void trace_batch(std::size_t first, std::size_t count, int level);
    void trace_shadows(std::uint32_t light, int level);
    void turn_wave();
    template <class Question>
    void ask(const Question& question);

    const Integrator& integrator_;
    Session& session_;
    std::size_t batch_;
    RayCounts counts_;
    std::chrono::nanoseconds answering_{0};
    Sent::Rays wave_;
    std::vector<Source> sources_;        ///< of camera rays
    std::vector<Source> light_sources_;  ///< of shadow rays: of a batch, all alike
    Sent sent_;
    std::vector<Hit> hits_;
    std::vector<std::uint8_t> occluded_;
};

}  // namespace rayshoot

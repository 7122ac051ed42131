#include "bench/heatmap/cost_map.h"

#include "bench/timing/watched_accel.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rayshoot {
namespace {

Event event_of(Cost cost) {
    switch (cost) {
        case Cost::tests:
            return Event::object_test;
        case Cost::steps:
            return Event::step;
        case Cost::boxes:
            return Event::bounding_volume_test;
        case Cost::time:
            break;
    }
    throw std::logic_error("time is not counted");
}

void require_counts(const Accel& accel) {
    if (accel.open(Mode::counting)->counters(RayKind::camera)) return;
    throw std::invalid_argument("'" + accel.spec() +
                                "' does not count; --quantity time measures it");
}

/// Charges each batch to the pixel whose camera rays came last: tiles are of one pixel.
class PixelMeter {
public:
    PixelMeter(ScalarImage& costs, Cost cost) : costs_(costs), cost_(cost) {}

    void charge(const AnsweredBatch& answered) {
        if (answered.batch.kind == RayKind::camera) {
            const Source source = answered.batch.source.front();
            // With a box filter all of them are of one cell, and inside the image.
            x_ = std::clamp<int>(source.cell_x(), 0, costs_.width() - 1);
            y_ = std::clamp<int>(source.cell_y(), 0, costs_.height() - 1);
        }
        costs_.at(x_, y_) += cost_ == Cost::time ? 1e9 * answered.seconds : counted(answered);
    }

private:
    /// By this batch alone.
    double counted(const AnsweredBatch& answered) {
        const Counters& counters = *answered.session.counters(answered.batch.kind);
        const std::uint64_t total = counters[event_of(cost_)];
        std::uint64_t& before = before_[static_cast<std::size_t>(answered.batch.kind)];
        const std::uint64_t added = total - before;
        before = total;
        return static_cast<double>(added);
    }

    ScalarImage& costs_;
    Cost cost_;
    int x_ = 0, y_ = 0;
    std::array<std::uint64_t, ray_kinds> before_{};
};

}  // namespace

std::string_view name_of(Cost cost) { return cost_names[static_cast<std::size_t>(cost)]; }
std::string_view unit_of(Cost cost) { return cost_units[static_cast<std::size_t>(cost)]; }

Cost cost_named(std::string_view name) {
    const auto found = std::ranges::find(cost_names, name);
    if (found != cost_names.end()) return static_cast<Cost>(found - cost_names.begin());
    throw std::invalid_argument("unknown quantity \"" + std::string(name) +
                                "\"; there are tests, steps, boxes and time");
}

RenderSettings settings_by_pixel(const RenderSettings& settings) {
    if (settings.filter.radius > smallest_radius)
        throw std::invalid_argument(
            "a filter wider than a pixel shares its rays with others; leave it out, or give "
            "radius=0.5");
    if (settings.transport.method == Method::irradiance)
        throw std::invalid_argument(
            "the irradiance cache is filled for all pixels together; give method=path");
    RenderSettings by_pixel = settings;
    by_pixel.batch = std::min(static_cast<std::size_t>(settings.format.spp), max_batch);
    by_pixel.threads = 1;
    return by_pixel;
}

ScalarImage cost_map(const Scene& scene, const Accel& accel, const RenderSettings& settings,
                     Cost cost) {
    if (cost != Cost::time) require_counts(accel);
    RenderSettings alone = settings;
    alone.mode = cost == Cost::time ? Mode::timing : Mode::counting;
    alone.threads = 1;
    ScalarImage costs(settings.format.width, settings.format.height);
    PixelMeter meter(costs, cost);
    const WatchedAccel watched(accel,
                               [&](const AnsweredBatch& answered) { meter.charge(answered); });
    render(scene, watched, alone);
    return costs;
}

void keep_least(ScalarImage& least, const ScalarImage& other) {
    for (int y = 0; y < least.height(); ++y) {
        for (int x = 0; x < least.width(); ++x) {
            least.at(x, y) = std::min(least.at(x, y), other.at(x, y));
        }
    }
}

CostSummary summarise(const ScalarImage& costs) {
    CostSummary summary;
    for (int y = 0; y < costs.height(); ++y) {
        for (int x = 0; x < costs.width(); ++x) {
            const double cost = costs.at(x, y);
            summary.sum += cost;
            if (cost <= summary.largest) continue;
            summary.largest = cost;
            summary.largest_at = {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
        }
    }
    if (!costs.values().empty()) {
        summary.mean = summary.sum / static_cast<double>(costs.values().size());
    }
    return summary;
}

}  // namespace rayshoot

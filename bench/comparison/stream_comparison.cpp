#include "bench/comparison/stream_comparison.h"

#include "bench/statistics/random.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rayshoot {
namespace {

/// Every contestant once, in an order of its own for each block, with the control kernel before,
/// amid and after them. Returns the median of its three times, in seconds.
double time_block(std::vector<Contestant*> order, ControlKernel& control, Sequence& random,
                  Progress& progress) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    std::array<double, 3> times{control.seconds()};
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == order.size() / 2) times[1] = control.seconds();
        progress.advance(to_string(order[i]->row.name));
        order[i]->row.samples.push_back(time_once(*order[i]));
    }
    times[2] = control.seconds();
    return median(times);
}

/// The median over blocks of this row's rate over another's in the same block.
std::optional<Estimate> ratio(const Row& row, const Row* other) {
    if (!other || other->samples.size() != row.samples.size()) return std::nullopt;
    std::vector<double> ratios = row.rates();
    const std::vector<double> base = other->rates();
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] /= base[i];
    return bootstrap_median(ratios);
}

/// Embree's rows of a family, in the order they were asked for.
std::vector<const Row*> embree_rows(const std::vector<Contestant*>& timed,
                                    const std::string& family) {
    std::vector<const Row*> rows;
    for (const Contestant* contestant : timed) {
        const Row& row = contestant->row;
        if (is_embree(row.name.spec) && row.name.family == family) rows.push_back(&row);
    }
    return rows;
}

void compare_with_embree(const std::vector<Contestant*>& timed, Row& row) {
    const std::vector<const Row*> yardsticks = embree_rows(timed, row.name.family);
    if (yardsticks.empty()) return;
    const auto rate = [](const Row* yardstick) { return yardstick->mrays_per_second->median; };
    const Row* best = *std::ranges::max_element(yardsticks, {}, rate);
    row.ratio_to_embree = ratio(row, yardsticks.front());
    row.ratio_to_best_embree = ratio(row, best);
    row.best_embree = best->name.spec;
}

}  // namespace

StreamResult compare_stream(const StreamContext& context, const std::vector<Candidate>& candidates,
                            ControlKernel& control, Progress& progress) {
    const Gate gate = make_gate(context);
    std::list<Contestant> contestants = contestants_of(context, candidates, gate, progress);
    std::vector<Contestant*> timed;
    for (Contestant& contestant : contestants) {
        if (contestant.tracer) timed.push_back(&contestant);
    }
    StreamResult result;
    Sequence random(context.plan.seed);
    for (int block = 0; block < context.plan.repetitions && !timed.empty(); ++block) {
        result.control_samples.push_back(time_block(timed, control, random, progress));
    }
    for (Contestant* contestant : timed) {
        contestant->row.mrays_per_second = bootstrap_median(contestant->row.rates());
    }
    for (Contestant* contestant : timed) compare_with_embree(timed, contestant->row);
    for (Contestant& contestant : contestants) result.rows.push_back(std::move(contestant.row));
    result.summary = {context.stream.scene,       std::string(name_of(context.stream.kind)),
                      gate.answers().digest(),    context.stream.size(),
                      gate.answers().hit_count(), gate.oracle_rays(),
                      result.control_samples};
    return result;
}

}  // namespace rayshoot

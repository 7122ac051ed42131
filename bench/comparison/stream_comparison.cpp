#include "bench/comparison/stream_comparison.h"

#include "bench/statistics/random.h"

#include <utility>

namespace rayshoot {
namespace {

/// Every contestant once, in an order of its own for each block.
void time_block(std::vector<Contestant*> order, Sequence& random, Progress& progress) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (Contestant* contestant : order) {
        progress.advance(to_string(contestant->row.name));
        contestant->row.samples.push_back(time_once(*contestant));
    }
}

/// The median over blocks of this row's rate over Embree's in the same block.
std::optional<Estimate> ratio(const Row& row, const Row* embree) {
    if (!embree || embree->samples.size() != row.samples.size()) return std::nullopt;
    std::vector<double> ratios = row.rates();
    const std::vector<double> base = embree->rates();
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] /= base[i];
    return bootstrap_median(ratios);
}

const Row* embree_row(const std::list<Contestant>& contestants, const std::string& family) {
    for (const Contestant& contestant : contestants) {
        const Row& row = contestant.row;
        if (contestant.embree && contestant.tracer && row.name.family == family) return &row;
    }
    return nullptr;
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
        result.control_samples.push_back(control.seconds());
        time_block(timed, random, progress);
    }
    for (Contestant* contestant : timed) {
        contestant->row.mrays_per_second = bootstrap_median(contestant->row.rates());
    }
    for (Contestant* contestant : timed) {
        Row& row = contestant->row;
        row.ratio_to_embree = ratio(row, embree_row(contestants, row.name.family));
    }
    for (Contestant& contestant : contestants) result.rows.push_back(std::move(contestant.row));
    result.summary = {context.stream.scene,       std::string(name_of(context.stream.kind)),
                      gate.answers().digest(),    context.stream.size(),
                      gate.answers().hit_count(), gate.oracle_rays()};
    return result;
}

}  // namespace rayshoot

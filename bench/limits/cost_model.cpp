#include "bench/limits/cost_model.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace rayshoot {
namespace {

using Triple = std::array<double, 3>;  // of a ray, of a step, of a leaf

/// How often a sample pays each cost, over what it measured: costs x these should be 1.
Triple weights(const CostSample& sample) {
    return {1 / sample.ns, sample.steps / sample.ns, sample.leaves / sample.ns};
}

/// The normal equations, left and right side in one.
using Equations = std::array<std::array<double, 4>, 3>;

/// Of the costs in `kept` (bit by bit); the others' equations say that they are 0.
Equations normal_equations(std::span<const CostSample> samples, unsigned kept) {
    const auto keeps = [&](std::size_t i) { return (kept >> i & 1) != 0; };
    Equations equations{};
    for (const CostSample& sample : samples) {
        const Triple weight = weights(sample);
        for (std::size_t row = 0; row < 3; ++row) {
            if (!keeps(row)) continue;
            for (std::size_t column = 0; column < 3; ++column)
                if (keeps(column)) equations[row][column] += weight[row] * weight[column];
            equations[row][3] += weight[row];
        }
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (!keeps(i)) equations[i][i] = 1;
    return equations;
}

/// Gauss and Jordan; nothing for equations that depend on each other.
std::optional<Triple> solution(Equations equations) {
    Triple scale;
    for (std::size_t i = 0; i < 3; ++i) scale[i] = equations[i][i];
    for (std::size_t pivot = 0; pivot < 3; ++pivot) {
        if (!(equations[pivot][pivot] > 1e-10 * scale[pivot])) return std::nullopt;
        for (std::size_t row = 0; row < 3; ++row) {
            if (row == pivot) continue;
            const double factor = equations[row][pivot] / equations[pivot][pivot];
            for (std::size_t column = pivot; column < 4; ++column)
                equations[row][column] -= factor * equations[pivot][column];
        }
    }
    Triple result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = equations[i][3] / equations[i][i];
    return result;
}

double residual(std::span<const CostSample> samples, const CostModel& model) {
    double sum = 0;
    for (const CostSample& sample : samples) {
        const double error = model.ns(sample.steps, sample.leaves) / sample.ns - 1;
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

}  // namespace

CostModel fit_costs(std::span<const CostSample> samples) {
    if (samples.size() < 3)
        throw std::invalid_argument("three costs take at least three samples to be told apart");
    CostModel best;
    best.residual = std::numeric_limits<double>::infinity();
    for (unsigned kept = 1; kept < 8; ++kept) {
        const auto costs = solution(normal_equations(samples, kept));
        if (!costs || (*costs)[0] < 0 || (*costs)[1] < 0 || (*costs)[2] < 0) continue;
        CostModel model{(*costs)[0], (*costs)[1], (*costs)[2], 0};
        model.residual = residual(samples, model);
        if (model.residual < best.residual) best = model;
    }
    return best;
}

}  // namespace rayshoot

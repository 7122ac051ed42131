#pragma once

#include <span>

/// What a ray costs, as a sum over what was counted of it.
namespace rayshoot {

/// Means over the rays of one stream.
struct CostSample {
    double steps = 0, leaves = 0;
    double ns = 0;  ///< > 0
};

struct CostModel {
    double per_ray = 0, per_step = 0, per_leaf = 0;  ///< ns
    double residual = 0;  ///< root mean square of (predicted - measured) / measured

    double ns(double steps, double leaves) const {
        return per_ray + per_step * steps + per_leaf * leaves;
    }
};

/// Least squares of the relative errors, with no negative cost: of the subsets of the three costs
/// whose free solution has none, the one that fits best. Throws std::invalid_argument for fewer
/// than three samples.
CostModel fit_costs(std::span<const CostSample> samples);

}  // namespace rayshoot

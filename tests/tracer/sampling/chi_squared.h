#pragma once

#include <boost/math/distributions/chi_squared.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace rayshoot {

/// What chi^2 exceeds once in 10^5 tests if the null hypothesis holds. The numbers that are tested
/// are fixed, so the verdict is too.
inline double chi_squared_limit(std::size_t degrees_of_freedom) {
    const boost::math::chi_squared distribution(static_cast<double>(degrees_of_freedom));
    return quantile(complement(distribution, 1e-5));
}

/// Counts over bins, to be compared with what is expected of them.
class Histogram {
public:
    explicit Histogram(std::size_t bins) : counts_(bins) {}

    void add(std::size_t bin) {
        ++counts_.at(bin);
        ++total_;
    }
    double total() const { return total_; }
    double count(std::size_t bin) const { return counts_[bin]; }
    std::size_t bins() const { return counts_.size(); }

    /// `share(bin)`: of all, as expected. Bins expected to have less than five are put together.
    template <class Share>
    bool agrees(Share&& share) const {
        double sum = 0, rest_count = 0, rest_expected = 0;
        std::size_t terms = 0;
        const auto add = [&](double count, double expected) {
            sum += (count - expected) * (count - expected) / expected;
            ++terms;
        };
        for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
            const double expected = share(bin) * total_;
            if (expected >= 5) {
                add(counts_[bin], expected);
            } else {
                rest_count += counts_[bin];
                rest_expected += expected;
            }
        }
        if (rest_expected > 0) add(rest_count, rest_expected);
        return sum < chi_squared_limit(terms - 1);
    }
    bool uniform() const {
        return agrees([this](std::size_t) { return 1 / static_cast<double>(counts_.size()); });
    }

private:
    std::vector<double> counts_;
    double total_ = 0;
};

/// The cell of a value in [0, 1).
inline std::size_t cell(float value, std::size_t cells) {
    return static_cast<std::size_t>(static_cast<double>(value) * static_cast<double>(cells));
}

}  // namespace rayshoot

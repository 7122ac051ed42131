#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// How a published number follows from what is counted.
namespace rayshoot {

/// Counted things by their names.
using CountedByName = std::map<std::string, double, std::less<>>;

/// "interior", "object_tests/hits", "2*cells-empty_cells-hits/rays": sums of counted things, each
/// with a whole factor where it is not 1, and at most one division of a sum by another, which binds
/// least.
class Measure {
public:
    /// Throws std::invalid_argument for a text that is no measure, or a name that is not in
    /// `known`.
    Measure(std::string_view text, const CountedByName& known);

    double of(const CountedByName& counted) const;

private:
    using Sum = std::vector<std::pair<double, std::string>>;
    static Sum parsed(std::string_view text, const CountedByName& known);
    static double value(const Sum& sum, const CountedByName& counted);

    Sum above_, below_;  ///< `below_`: empty where nothing is divided
};

}  // namespace rayshoot

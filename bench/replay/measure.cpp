#include "bench/replay/measure.h"

#include <charconv>
#include <stdexcept>

namespace rayshoot {
namespace {

[[noreturn]] void refuse_name(std::string_view name, const CountedByName& known) {
    std::string names;
    for (const auto& [each, value] : known) names += (names.empty() ? "" : ", ") + each;
    throw std::invalid_argument("nothing is counted by the name \"" + std::string(name) +
                                "\"; there are " + names);
}

/// "2*cells" or "cells"
std::pair<double, std::string> term(std::string_view text, double sign,
                                    const CountedByName& known) {
    double factor = 1;
    if (const std::size_t times = text.find('*'); times != std::string_view::npos) {
        const std::string_view digits = text.substr(0, times);
        const auto [end, wrong] = std::from_chars(digits.begin(), digits.end(), factor);
        if (wrong != std::errc{} || end != digits.end())
            throw std::invalid_argument("\"" + std::string(digits) + "\" is no factor");
        text.remove_prefix(times + 1);
    }
    if (!known.contains(text)) refuse_name(text, known);
    return {sign * factor, std::string(text)};
}

}  // namespace

Measure::Measure(std::string_view text, const CountedByName& known) {
    const std::size_t slash = text.find('/');
    above_ = parsed(text.substr(0, slash), known);
    if (slash != std::string_view::npos) below_ = parsed(text.substr(slash + 1), known);
}

Measure::Sum Measure::parsed(std::string_view text, const CountedByName& known) {
    Sum sum;
    double sign = 1;
    while (true) {
        const std::size_t next = text.find_first_of("+-");
        sum.push_back(term(text.substr(0, next), sign, known));
        if (next == std::string_view::npos) return sum;
        sign = text[next] == '-' ? -1 : 1;
        text.remove_prefix(next + 1);
    }
}

double Measure::value(const Sum& sum, const CountedByName& counted) {
    double total = 0;
    for (const auto& [factor, name] : sum) total += factor * counted.find(name)->second;
    return total;
}

double Measure::of(const CountedByName& counted) const {
    return value(above_, counted) / (below_.empty() ? 1 : value(below_, counted));
}

}  // namespace rayshoot

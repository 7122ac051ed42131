#pragma once

#include "accel/core/catalogue.h"
#include "tests/contract/case.h"
#include "tests/contract/report.h"

/// The contract kit: runs one spec over every hard scene and every hard ray, against brute force.
/// A structure of your own, in this tree or out of it, enters through the catalogue:
///     Catalogue catalogue = built_in_catalogue();
///     catalogue.push_back(make_entry<Mine>(Agreement::exact));
///     const Report report = run_contract(catalogue, "mine", {});
/// and has passed when report.passed(); otherwise the report says which rays it got wrong.
namespace rayshoot::contract {

/// Scenes, rays and true answers, made once and good for any number of specs.
class Contract {
public:
    explicit Contract(const Settings& settings = {})
        : enough_failures_(settings.enough_failures), cases_(make_cases(settings)) {}

    Report run(const Catalogue& catalogue, const std::string& spec) const;
    const std::vector<Case>& cases() const { return cases_; }

private:
    std::uint64_t enough_failures_;
    std::vector<Case> cases_;
};

Report run_contract(const Catalogue& catalogue, const std::string& spec, const Settings& settings);

/// The specs that the kit owes an answer on: every configuration of every `exact` entry.
std::vector<std::string> exact_configurations(const Catalogue& catalogue);

}  // namespace rayshoot::contract

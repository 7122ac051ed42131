#include "tests/contract/contract.h"

#include "tests/contract/checks/checks.h"

namespace rayshoot::contract {

Report Contract::run(const Catalogue& catalogue, const std::string& spec) const {
    Report report;
    for (const Case& tested : cases_) {
        if (report.failures >= enough_failures_) break;
        ++report.scenes;
        if (!refusal(catalogue, spec, tested.scene.geometry).empty()) {
            ++report.refused;
            continue;
        }
        const auto accel = build(catalogue, spec, tested.scene.input());
        check_answers(*accel, tested, report);
        check_counters(*accel, tested, report);
        check_threads(*accel, tested, report);
        check_bare_input(catalogue, spec, tested, report);
        check_description(catalogue, *accel, tested, report);
    }
    return report;
}

Report run_contract(const Catalogue& catalogue, const std::string& spec, const Settings& settings) {
    return Contract(settings).run(catalogue, spec);
}

std::vector<std::string> exact_configurations(const Catalogue& catalogue) {
    std::vector<std::string> specs;
    for (const StructureEntry& entry : catalogue) {
        if (entry.agreement != Agreement::exact) continue;
        for (const std::string_view spec : entry.configurations) specs.emplace_back(spec);
    }
    return specs;
}

}  // namespace rayshoot::contract

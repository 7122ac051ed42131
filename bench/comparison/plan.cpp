#include "bench/comparison/plan.h"

#include "bench/comparison/row_name.h"
#include "bench/comparison/specimen.h"

#include <algorithm>
#include <stdexcept>

namespace rayshoot {
namespace {

template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

void require_between(const std::string& what, std::size_t value, std::size_t lowest,
                     std::size_t highest) {
    if (value >= lowest && value <= highest) return;
    throw std::invalid_argument(what + " must be " + std::to_string(lowest) + " to " +
                                std::to_string(highest) + ", not " + std::to_string(value));
}

}  // namespace

void narrow_to_rows(ComparisonPlan& plan, const std::vector<std::string>& names) {
    if (names.empty()) return;
    plan.scenes.clear();
    plan.structures.clear();
    plan.kinds.clear();
    for (const std::string& text : names) {
        const RowName name = parse_row_name(text);
        if (name.kind.empty()) {
            throw std::invalid_argument("\"" + text +
                                        "\" is not a row of rays; see bench_build "
                                        "and bench_render");
        }
        add_once(plan.scenes, name.scene);
        add_once(plan.structures, name.spec);
        add_once(plan.kinds, stream_kind(name.kind));
        plan.rows.insert(text);
        plan.warm = plan.warm || name.family == "warm";
    }
}

void require_valid(const Catalogue& catalogue, const ComparisonPlan& plan) {
    if (plan.scenes.empty()) throw std::invalid_argument("no scene; name one with --scene");
    if (plan.structures.empty()) {
        throw std::invalid_argument("no structure; name one with --structure");
    }
    if (plan.kinds.empty() && plan.ray_files.empty()) {
        throw std::invalid_argument("no rays; name their kinds with --rays");
    }
    if (!plan.ray_files.empty() && plan.scenes.size() != 1) {
        throw std::invalid_argument("a ray file is traced through one scene, not " +
                                    std::to_string(plan.scenes.size()));
    }
    for (const std::string& spec : plan.structures) require_spec(catalogue, spec);
    require_between("the number of threads", static_cast<std::size_t>(plan.threads), 1, 1024);
    require_between("the number of repetitions", static_cast<std::size_t>(plan.repetitions), 1,
                    100000);
    require_between("the number of builds", static_cast<std::size_t>(plan.builds), 1, 1000);
    require_between("the batch size", plan.batch, 1, max_batch);
}

}  // namespace rayshoot
